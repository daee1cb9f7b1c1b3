//! The envelope around every message, the protocol's version, and the programs that talk by it.

use serde::{Deserialize, Serialize};

/// The protocol's version; both sides refuse any other.
pub const VERSION: u32 = 13;

/// One message: a request and every event that answers it carry the same `id`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Envelope<T> {
    /// The protocol's version, [`VERSION`]; the first field, by which readers know what follows.
    pub groundling: u32,
    /// Which request this is, or answers; chosen by the page, 0 for what nobody asked for.
    pub id: u32,
    /// The message itself.
    pub body: T,
}

/// The page's programs, each an engine in a worker of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// It answers, plans and says what it found; the page always has it.
    Talker,
    /// It reads corpora, trains, teaches and runs experiments; loaded when there is something to learn.
    Learner,
}

impl Program {
    /// Its name, which is what the page's worker script is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Program::Talker => "talker",
            Program::Learner => "learner",
        }
    }
}
