//! What is said: what stands in the command box, what it would mean, and what is looked at of it.

use super::link::Link;
use crate::worker::protocol::{Answer, Study};
use std::rc::Rc;

/// The elements that a question's choices are, in their order.
pub const CHOICES: [&str; 3] = ["choice-1", "choice-2", "choice-3"];

/// Characters that a command may have; the engine says so of those with too many words.
pub const MOST_CHARACTERS: usize = 1_000;

/// What is said, and about it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Command {
    /// What stands in the command box.
    pub input: String,
    /// Whether it was sent before there was anyone to hear it, and is asked as soon as there is.
    pub early: bool,
    /// What it would mean, while it is typed.
    pub live: Option<Rc<Answer>>,
    /// Why the last command was not answered at all.
    pub notice: Option<String>,
    /// The words that are pointed at.
    pub link: Option<Link>,
    /// The reading whose goal cells are to be seen.
    pub preview: Option<usize>,
    /// What the readings' scores are made of, and how their meanings came about.
    pub studies: Option<Rc<Vec<Study>>>,
    /// Whether all readings are shown, or the first few.
    pub all_readings: bool,
    /// The constituent that is studied.
    pub node: Option<usize>,
    /// How many steps of its reduction are shown.
    pub steps: usize,
}

impl Command {
    /// Only what stands in the box is kept: all else is of another command now.
    pub(crate) fn forget(&mut self) {
        let Command { input, .. } = std::mem::take(self);
        self.input = input;
    }
}
