//! What can happen to the page ([`Action`]) and what the page wants done ([`Effect`]). Both are plain data:
//! a test plays actions and reads effects, with no browser.

use crate::render::Theme;
use crate::worker::protocol::{Envelope, Event, Program, Request};

/// What the person's system asks of every page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Preferences {
    /// Whether things should jump rather than glide.
    pub reduced_motion: bool,
    /// Light or dark.
    pub theme: Theme,
}

/// Something that happened: a person did it, the engine said it, or a timer ran out.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The page has opened.
    Opened,
    /// What the person prefers is known, or has changed.
    Prefers(Preferences),
    /// An engine sent a message.
    Heard(Program, Envelope<Event>),
    /// An engine could not be loaded or died; the text says how.
    EngineBroke(Program, String),
    /// A timer ran out.
    Rang(Timer),
    /// A person asked for a new engine.
    RestartEngine(Program),

    /// A file was opened and read as text.
    FileRead {
        /// Its name.
        name: String,
        /// Its text.
        text: String,
    },
    /// A file was offered that cannot be read; the text says why.
    FileRefused(String),
    /// Go back to the page's own six sentences.
    OpenDemo,
    /// Open or close a row of the corpus.
    ToggleRow(usize),
    /// Show more rows of the corpus.
    MoreRows,
    /// Save the corpus as a file.
    SaveCorpus,

    /// Train on the corpus that is open.
    Train,
    /// Stop training.
    CancelTraining,
    /// Save the model as a file.
    SaveModel,

    /// The command box changed.
    Typed(String),
    /// A command was sent: what stands in the box.
    Ask,
    /// An example command was chosen: fill the box and send it.
    AskExample(String),

    /// Another world was chosen, by its place in [`super::world::WORLDS`].
    PickWorld(usize),
    /// Put the world back as it began.
    ResetWorld,
    /// Take the last change of the world back.
    Undo,

    /// Play or pause the plan.
    TogglePlay,
    /// Go to a step of the plan, and pause there.
    Seek(usize),
}

/// Something for the view to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Start a new engine, ending the one there is.
    SpawnEngine(Program),
    /// Send an engine a message.
    Post(Program, Envelope<Request>),
    /// Ring after so many milliseconds.
    StartTimer(Timer, u32),
    /// Bring the room into view.
    ShowRoom,
    /// Offer a text to the person as a file.
    Save {
        /// The file's name.
        name: String,
        /// Its text.
        text: String,
    },
}

/// What a timer was for. The number tells a stale one from the one that counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timer {
    /// The next step of the plan that is played.
    Play(u32),
    /// Time to see whether an engine still answers.
    Watch(Program, u32),
}
