//! The lines of what was said, the latest last.

use crate::domain::State as World;
use crate::ui::page::document::Said;
use serde::{Deserialize, Serialize};

/// Lines that are kept.
pub const MOST_LINES: usize = 30;

/// Something that was said.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// The command.
    pub command: String,
    /// What came of it.
    pub outcome: Outcome,
    /// The world after it.
    pub world: World,
}

/// What came of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Outcome {
    /// It was done in so many steps.
    Done(usize),
    /// It was so already.
    Already,
    /// It was asked what is meant, and not answered yet.
    Asked,
    /// It was understood, and cannot be done.
    Unable,
    /// It was not understood.
    Lost,
    /// It was a question, and answered.
    Told,
}

/// What was said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Past {
    /// The lines.
    pub lines: Vec<Line>,
    /// The line that stands in the command box, while one goes through them.
    pub at: Option<usize>,
}

impl Outcome {
    /// What came of what was said.
    pub fn of(said: &Said) -> Outcome {
        match &said.plan {
            Some(plan) if !plan.reached => Outcome::Unable,
            Some(plan) if plan.actions.is_empty() => Outcome::Already,
            Some(plan) => Outcome::Done(plan.actions.len()),
            None if said.answer.readings.is_empty() => Outcome::Lost,
            None => Outcome::Asked,
        }
    }
}
