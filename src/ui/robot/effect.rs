//! What the page that drives a robot wants done. Plain data: a test reads effects, with no browser.

use crate::ui::page::engine::Errand;
use crate::ui::page::language::Language;
use crate::worker::protocol::{Envelope, Request};

/// Something for the view to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Open a link to this address, in place of the one there is.
    Open(String),
    /// Close it.
    Close,
    /// Send this over it, now or never.
    Send(String),
    /// Ring for `LinkAgain` of this number after so many milliseconds.
    Again(u32, u32),
    /// Start the engine that talks, ending the one there is.
    SpawnTalker,
    /// Send it a message.
    Post(Envelope<Request>),
    /// Ring for `Look` of this number after so many milliseconds.
    Watch(u32, u32),
    /// Get the model that comes with the page.
    FetchModel,
    /// Get what other words may stand for.
    FetchWords,
    /// Get what is kept of how a robot is set up.
    Recall,
    /// Keep this of it, once nothing has changed for a moment.
    Keep(String),
    /// The page is in another language.
    Speak(Language),
}

impl From<Errand> for Effect {
    fn from(errand: Errand) -> Effect {
        match errand {
            Errand::Spawn(_) => Effect::SpawnTalker,
            Errand::Post(_, envelope) => Effect::Post(envelope),
            Errand::Watch(_, watch, ms) => Effect::Watch(watch, ms),
        }
    }
}
