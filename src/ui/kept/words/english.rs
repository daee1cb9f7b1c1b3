//! What is kept, in English; what each word is for stands here for all languages.

use super::table::Text;

/// The words.
pub(super) static ENGLISH: Text = Text {
    title: "Kept on this machine",
    about: "The page keeps your session here, in this browser, so that a reload, a closed tab or a crash loses nothing. Nobody else gets it. It is kept twice, and checked when it is read.",
    nothing: "Nothing is kept.",
    what: "What",
    when: "Last changed",
    size: "Size",
    kinds: [
        ("own", "Your session"),
        ("before", "The session before that"),
        ("session", "The session of a link"),
        ("corpus", "Corpus"),
        ("run", "Training run"),
        ("experiment", "Experiment"),
        ("model", "Model"),
        ("sitting", "What you answered in a study"),
        ("robot", "How your robot is set up"),
    ],
    save: "Save as a file",
    delete: "Delete",
    delete_all: "Delete all of it",
    deleted: "It is deleted.",
};
