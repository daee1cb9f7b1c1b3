//! One thing that the page says of a command.

use super::help::Help;
use crate::ui::talk::command::link::Link;

/// One thing that is wrong, or worth knowing.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    /// Its kind: names the message in tests and styles.
    pub kind: &'static str,
    /// What is wrong.
    pub what: String,
    /// What to do about it.
    pub fix: String,
    /// The words that it is about.
    pub link: Option<Link>,
    /// What the page can do.
    pub helps: Vec<Help>,
}

pub(super) fn message(
    kind: &'static str,
    (what, fix): (impl Into<String>, &str),
    link: Option<Link>,
    helps: Vec<Help>,
) -> Message {
    Message { kind, what: what.into(), fix: fix.to_owned(), link, helps }
}
