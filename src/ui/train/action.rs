//! What can happen to the workbench: a person did it in one of its parts, the page told it, an engine said it, or a
//! timer ran out.

use super::{data, run};
use crate::ui::page::document::Model;
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Preferences;
use crate::worker::protocol::{Envelope, Event, Program};

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Something was done with the corpus.
    Data(data::Action),
    /// Something was done about training.
    Run(run::Action),

    /// It is to be seen, or no more.
    Shown(bool),
    /// The page is in another language.
    Speak(Language),
    /// What the person prefers is known, or has changed.
    Prefers(Preferences),
    /// The robot uses this model.
    Uses(Model),
    /// Why the robot has no model, or not the one that was wanted.
    Notice(Option<String>),

    /// An engine sent a message.
    Heard(Program, Envelope<Event>),
    /// An engine could not be loaded or died; the text says how.
    EngineBroke(Program, String),
    /// A person asked for a new engine.
    RestartEngine(Program),
    /// It is time to see whether an engine still answers.
    Look(Program, u32),
}
