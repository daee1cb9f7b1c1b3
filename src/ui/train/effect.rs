//! What the workbench wants done. Plain data: a test reads effects, with no browser.

use crate::ui::page::engine::Errand;
use crate::ui::page::news::News;
use crate::worker::protocol::{CorpusFile, Envelope, Program, Request};

/// Something for the view to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Start a new engine, ending the one there is.
    SpawnEngine(Program),
    /// Send an engine a message.
    Post(Program, Envelope<Request>),
    /// Look after so many milliseconds whether an engine still answers.
    Watch(Program, u32, u32),
    /// Tell the page something.
    Tell(News),
    /// Offer a text to the person as a file.
    Save {
        /// The file's name.
        name: String,
        /// Its text.
        text: String,
    },
    /// Offer a file that a person gave to the person again.
    GiveBack(CorpusFile),
}

impl From<Errand> for Effect {
    fn from(errand: Errand) -> Effect {
        match errand {
            Errand::Spawn(program) => Effect::SpawnEngine(program),
            Errand::Post(program, envelope) => Effect::Post(program, envelope),
            Errand::Watch(program, watch, ms) => Effect::Watch(program, watch, ms),
        }
    }
}
