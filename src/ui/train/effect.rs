//! What the workbench wants done. Plain data: a test reads effects, with no browser.

use crate::ui::page::engine::Errand;
use crate::ui::page::news::News;
use crate::ui::train::kept::ask::Ask;
use crate::worker::protocol::{CorpusFile, Envelope, Program, Request};

/// Something for the view to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Start a new engine, ending the one there is.
    SpawnEngine(Program),
    /// Do something for an engine of the pool, by its seat.
    Pool(u32, Errand),
    /// End all engines of the pool.
    EndPool,
    /// Send an engine a message.
    Post(Program, Envelope<Request>),
    /// Look after so many milliseconds whether an engine still answers.
    Watch(Program, u32, u32),
    /// Ring after so many milliseconds; the number tells a stale timer from the one that counts.
    Ring(u32, u32),
    /// Bring an element into view.
    Reveal(&'static str),
    /// Have the store do something.
    Store(Ask),
    /// Tell the page something.
    Tell(News),
    /// Pack a study into a link.
    Pack(String),
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
