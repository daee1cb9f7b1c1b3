//! What all pages say in English; what each word is for stands here for all languages.

use super::table::Text;

/// The words.
pub(super) static ENGLISH: Text = Text {
    copied: "Copied.",
    not_copied: "This browser did not allow copying.",
    share: "Share",

    engine_stopped: "The engine has stopped",
    engine_kept: "What you loaded and taught is kept. Start it again and go on.",
    engine_restart: "Start it again",
    engine_stopped_said: "The engine has stopped. What you loaded is kept; it can be started again.",
    engine_starting: "The engine is being started again.",
    engine_silent: "It has not answered for some seconds.",
    other_version: "Page and engine are of different versions. Load the page again.",

    no_model: |why| format!("The model that comes with this page could not be loaded ({why})."),
    model_opened: |entries| format!("The model is open: {entries} entries."),

    // The foot, and what is dropped on the page.
    stays_here: "Everything runs in this page. Nothing that you type, teach or open leaves your machine.",
    drop_here: "Drop the file to open it",
};
