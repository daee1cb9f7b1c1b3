//! The state of teaching: the lesson in preparation, and what came of the last one.

use crate::worker::protocol::{Fit, Lesson, TeachReport};
use std::rc::Rc;

/// What is taught, but for the demonstration and the lessons, which are in the document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Teach {
    /// The words of the lesson in preparation.
    pub words: String,
    /// What the last lesson added.
    pub report: Option<Rc<TeachReport>>,
    /// The lesson that was taught last.
    pub taught: Option<Lesson>,
    /// Why the last lesson was not learned.
    pub notice: Option<String>,
    /// A lesson that would end otherwise than it was shown, and the readings that fit it.
    pub offer: Option<Offer>,
    /// What the lesson lacks, once it was to be taught without.
    pub missing: Option<Missing>,
    /// The way that the page would have taken in place of the one that is driven, where it leads through other rooms.
    pub straight: Option<String>,
}

impl Teach {
    /// What came of the last lesson is no longer told.
    pub(crate) fn drop_last(&mut self) {
        (self.notice, self.report, self.offer) = (None, None, None);
    }
}

/// A lesson whose command can be read as what was shown, though not at first.
#[derive(Clone, Debug, PartialEq)]
pub struct Offer {
    /// The lesson.
    pub lesson: Lesson,
    /// The readings that account for all that was shown.
    pub fits: Vec<Fit>,
}

/// What a lesson still lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// Nothing is shown.
    Demonstration,
    /// Nothing is said.
    Words,
    /// There are ways that are not meant, and none that is.
    Way,
}
