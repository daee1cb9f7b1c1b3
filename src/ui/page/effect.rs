//! What the pages want done ([`Effect`]). Plain data: a test reads effects, with no browser.

use super::engine::Errand;
use super::keep::ask::Ask;
use super::language::Language;
use crate::worker::protocol::{Envelope, Program, Request};

/// Something for the view to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Start a new engine, ending the one there is.
    SpawnEngine(Program),
    /// Send an engine a message.
    Post(Program, Envelope<Request>),
    /// Ring after so many milliseconds.
    StartTimer(Timer, u32),
    /// Get the model that comes with the page.
    FetchModel,
    /// Get the general resource that comes with the page: what words that the lexicon does not know may stand for.
    FetchWords,
    /// Get the guide in a language.
    FetchGuide(Language),
    /// Have the store do something.
    Keep(Ask),
    /// The person reads another language.
    SetLanguage(Language),
    /// Make a link that holds a session, packed; show it in the address bar and copy it.
    Share(Vec<u8>),
    /// Offer a session, packed, to the person as a file.
    SaveSession(Vec<u8>),
    /// Offer lessons, packed, to the person as a corpus.
    SaveLessons(Vec<u8>),
    /// Read the text of a session.
    ReadSession(String),
    /// Read a world from JSON.
    ReadWorld(String),
    /// Copy a text.
    Copy(String),
    /// Move the keyboard's focus to an element, and bring it into view.
    Focus(&'static str),
    /// The same for an element that is typed into, where that brings no keyboard up on the screen.
    FocusOnDesk(&'static str),
    /// Bring an element into view.
    Reveal(&'static str),
    /// Offer a text to the person as a file.
    Save {
        /// The file's name.
        name: String,
        /// Its text.
        text: String,
    },
    /// Get the program of the workbench.
    LoadWorkbench,
}

impl From<Errand> for Effect {
    fn from(errand: Errand) -> Effect {
        match errand {
            Errand::Spawn(program) => Effect::SpawnEngine(program),
            Errand::Post(program, envelope) => Effect::Post(program, envelope),
            Errand::Watch(program, watch, ms) => {
                Effect::StartTimer(Timer::Watch(program, watch), ms)
            }
        }
    }
}

/// What a timer was for. The number tells a stale one from the one that counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timer {
    /// The next step of the plan that is played.
    Play(u32),
    /// Time to look for commands to try.
    Examples(u32),
    /// Time for the next thing that the page does by itself.
    Demo(u32),
    /// Time to keep the session, if it has changed.
    Keep,
    /// Time to see whether an engine still answers.
    Watch(Program, u32),
}
