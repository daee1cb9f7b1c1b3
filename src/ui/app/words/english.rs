//! The frame around the pages in English; what each word is for stands here for all languages.

use super::table::Text;

/// The words.
pub(super) static ENGLISH: Text = Text {
    pitch: "It learned its English from pairs of rooms, before and after, with no annotated forms. Teach it a word it lacks.",
    links: [
        ("How it works", "guide/learning.md"),
        ("The paper", "https://doi.org/10.1109/ICRA.2018.8460937"),
        ("The guide", "guide/page.md"),
        ("Drive a robot", "robot.html"),
    ],
    source: "The source",
    views: "Views",
    talk: "Talk",
    train: "Train",
    help: "Help",
    skip: "Skip to the command",
    language: "Language",
    depth: "How deep to look",
    depths: [
        ("Say", "The room, your command, what it understood"),
        ("See", "Other readings, goals, values and policy"),
        ("Study", "Derivations, forms, features and scores"),
    ],
    undo: "Undo",
    redo: "Redo",
    undone: "Undone.",
    redone: "Done again.",
    workbench_comes: "The workbench is coming…",
    no_workbench: |why| format!("The workbench could not be loaded ({why})."),
    try_again: "Try again",
};
