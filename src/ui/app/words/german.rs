//! The frame around the pages in German.

use super::table::Text;

/// The words.
pub(super) static GERMAN: Text = Text {
    pitch: "Sein Englisch hat er aus Paaren von Räumen gelernt, vorher und nachher, ohne eine annotierte Form. Lehr ihn ein Wort, das ihm fehlt.",
    links: [
        ("Wie das geht", "guide/learning.md"),
        ("Der Aufsatz", "https://doi.org/10.1109/ICRA.2018.8460937"),
        ("Die Anleitung", "guide/page.md"),
        ("Einen Roboter fahren", "robot.html"),
    ],
    source: "Der Quelltext",
    views: "Ansichten",
    talk: "Sprechen",
    train: "Trainieren",
    help: "Hilfe",
    skip: "Zum Befehl",
    language: "Sprache",
    depth: "Wie tief man hineinsieht",
    depths: [
        ("Sagen", "Der Raum, der Befehl, was er verstanden hat"),
        ("Sehen", "Andere Lesarten, Ziele, Werte und Strategie"),
        ("Studieren", "Herleitungen, Formeln, Merkmale und Punkte"),
    ],
    undo: "Rückgängig",
    redo: "Wiederholen",
    undone: "Rückgängig gemacht.",
    redone: "Wiederholt.",
    workbench_comes: "Die Werkbank kommt…",
    no_workbench: |why| format!("Die Werkbank ließ sich nicht laden ({why})."),
    try_again: "Noch einmal versuchen",
};
