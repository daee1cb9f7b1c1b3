//! What the page that asks wants done. Plain data: a test reads effects, with no browser.

use crate::study::journal::Note;
use crate::ui::page::language::Language;

/// Something for the view to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Fetch the study's file, beside the page.
    Fetch(String),
    /// Unpack the study that the link holds.
    Unpack,
    /// Open the store, and find who the person is here for a study of this fingerprint.
    Open(String),
    /// Claim a sitting for this tab, even from another.
    Claim {
        /// Its name.
        sitting: String,
        /// Whether it is taken from the tab that has it.
        steal: bool,
    },
    /// Read what is kept of a sitting.
    Read(String),
    /// Keep a note of a sitting, at its place.
    Keep {
        /// The sitting's name.
        sitting: String,
        /// The note's place among all.
        place: u32,
        /// The note.
        note: Box<Note>,
    },
    /// Erase what is kept of a sitting; where it is over, keep that it is, with its code.
    Erase {
        /// The sitting's name.
        sitting: String,
        /// The code, if it is over.
        over: Option<String>,
    },
    /// Ring for `Rested` when nothing was typed for a moment.
    Rest,
    /// Ring for `Ticked` after so many milliseconds; a ring that is still to come does not.
    Tick(u32),
    /// Post JSON to an address.
    Post {
        /// The address.
        url: String,
        /// The text.
        body: String,
    },
    /// Ring for `Again` after so many milliseconds.
    Retry(u32),
    /// Post a form to an address, which leaves the page.
    Submit {
        /// The address.
        url: String,
        /// Names and values.
        fields: Vec<(String, String)>,
    },
    /// Give a text to the person as a file.
    Save {
        /// The file's name.
        name: String,
        /// Its text.
        text: String,
    },
    /// Copy a text.
    Copy(String),
    /// Go to another address, which leaves the page.
    Go(String),
    /// Show the top of the page, and give the heading the keyboard.
    Top,
    /// The page is in another language.
    Speak(Language),
}
