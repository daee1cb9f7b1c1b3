//! The state of sharing: the link that was made, and what of a session that was opened waits for a model.

use crate::worker::protocol::Lesson;

/// A link to the page as it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The address.
    pub address: String,
    /// Whether it is on the clipboard.
    pub copied: bool,
}

/// What is shared of the sharing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sharing {
    /// The link that was made, or why there is none.
    pub made: Option<Result<Link, String>>,
    /// What is wrong with the link that the page was opened by.
    pub notice: Option<String>,
}

/// What of a session waits for a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resume {
    /// Lessons to learn.
    pub lessons: Option<Vec<Lesson>>,
    /// The command to answer after that.
    pub command: Option<String>,
    /// The reading to choose then.
    pub form: Option<String>,
    /// Whether what comes of it is shown as it ended, since it was seen before.
    pub is_quiet: bool,
}
