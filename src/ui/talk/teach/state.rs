//! The state of teaching: the lesson in preparation, and what came of the last one.

use crate::worker::protocol::TeachReport;
use std::rc::Rc;

/// What is taught, but for the demonstration and the lessons, which are in the document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Teach {
    /// The words of the lesson in preparation.
    pub words: String,
    /// What the last lesson added.
    pub report: Option<Rc<TeachReport>>,
    /// The command that was taught last.
    pub taught: Option<String>,
    /// Why the last lesson was not learned.
    pub notice: Option<String>,
    /// What the lesson lacks, once it was to be taught without.
    pub missing: Option<Missing>,
}

/// What a lesson still lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// Nothing is shown.
    Demonstration,
    /// Nothing is said.
    Words,
}
