//! What all pages say in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::ui::page::keep::fault::Fault;

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

    fault: |fault| {
        match fault {
        Fault::None => "This browser keeps nothing for this page, as in a private window: save what you do as a file before you close it.".to_owned(),
        Fault::Newer => "What is kept here was written by a newer build of this page: it is left as it is, and nothing is kept until you load the page again.".to_owned(),
        Fault::Older => "An older build of this page is open in another tab and holds what is kept. Close that tab: this one goes on by itself.".to_owned(),
        Fault::Full => "There is no room left in this browser: the last change is not kept. Delete something, or save a file.".to_owned(),
        Fault::Damaged => "What was kept is damaged, both copies of it.".to_owned(),
        Fault::Elsewhere => "Another tab has this session open and keeps it. What you do here is not kept.".to_owned(),
        Fault::Other(words) => format!("Nothing is kept: the browser says “{words}”."),
    }
    },
    origins: [
        "This is where you were.",
        "This is where you were a little before: what was written last is damaged.",
        "This is a link’s session. Your own is kept beside it.",
        "This is the link’s session as you left it. Your own is kept beside it.",
        "The session you had before is kept, too.",
    ],
    afresh: "Start afresh",
    begun_afresh: "All is as on the first visit. Undo brings back what was.",
    go_back: "Back to mine",
    keep_here: "Keep it here instead",
    what_is_kept: "What is kept",
    open_saved: "Open a saved file",
    close: "Close",

    no_model: |why| format!("The model that comes with this page could not be loaded ({why})."),
    model_opened: |entries| format!("The model is open: {entries} entries."),

    // The foot, and what is dropped on the page.
    stays_here: "Everything runs in this page. Nothing that you type, teach or open leaves your machine.",
    drop_here: "Drop the file to open it",
};
