//! What can happen to the page that asks.

use crate::study::ends::Source;
use crate::study::journal::Note;
use crate::study::{Link, Study};
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Preferences;

/// Why there is no study to take part in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// The link names none.
    Unnamed,
    /// It names one that is not beside the page.
    Elsewhere,
    /// It did not come.
    Absent(String),
    /// It is none; why.
    Bad(String),
}

/// What was kept of an earlier visit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kept {
    /// The notes of the sitting.
    pub notes: Vec<Note>,
    /// The code of a sitting that is over; empty where it had none.
    pub over: Option<String>,
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The page was opened by a link, in a browser of this language.
    Opened(Box<Link>, Language),
    /// What the person prefers is known, or has changed.
    Prefers(Preferences),
    /// The study has come, and from where, or there is none.
    Came(Result<(Box<Study>, Source), Trouble>),
    /// The store is open: who the person is here, where the link does not say.
    Known(Result<String, Fault>),
    /// Whether this tab has the sitting.
    Claimed(bool),
    /// What was kept was read.
    Read(Result<Kept, Fault>),
    /// A note was kept, or was not.
    Noted(Result<(), Fault>),
    /// Something went wrong with the store.
    Broke(Fault),

    /// The person agreed.
    Agree,
    /// The instructions and the example were read.
    Ready,
    /// The command is this now; so many characters of it were pasted just now.
    Typed(String, u32),
    /// Nothing was typed for a moment.
    Rested,
    /// So many milliseconds were spent with the page, and these showings were in sight.
    Spent(u32, Vec<bool>),
    /// What changed in a showing is to be seen, or no more.
    Point(usize),
    /// A run is to be played, from its start or from where it is; or to rest.
    Play(usize),
    /// A run is to go on by a step.
    Step(usize),
    /// It is time for the next step of the run that is played.
    Ticked,
    /// The command is done.
    Answer,
    /// The end at hand is wanted: send, save, copy, go.
    End,
    /// The end at hand is done with.
    Ended,
    /// What was posted has arrived, or has not.
    Posted(Result<(), String>),
    /// It is time to post again, or there is a network again.
    Again,
    /// The answers are to be saved as a file, whatever the study says.
    Save,
    /// What was kept was erased.
    Erased(Result<(), Fault>),
    /// The person wants to withdraw; asked whether they are sure.
    Withdraw,
    /// They are not.
    Stay,
    /// They are.
    Withdrawn,
    /// This tab is to have the sitting, which another has.
    Take,
    /// The page is wanted in another language.
    Speak(Language),
}
