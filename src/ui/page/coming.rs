//! How far something is that the page has fetched and gives to an engine.

use std::rc::Rc;

/// How far the resource is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Resource {
    /// Nobody asked for it yet.
    #[default]
    Absent,
    /// It is being fetched, or read.
    Coming,
    /// This is its text, and the engine has read it.
    Here(Rc<str>),
    /// It cannot be had.
    Lost,
}
