//! What the workbench wants of the store, and what it says.

use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::copies::Item;
use crate::ui::page::keep::fault::Fault;
use std::rc::Rc;

/// Something for the store to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ask {
    /// Open the store.
    Open,
    /// Have this tab keep runs, even if another does when it is so.
    Claim(bool),
    /// List what is kept.
    List,
    /// Read what is kept at a place.
    Read(Place),
    /// Keep bytes at a place.
    Write(Place, Rc<[u8]>),
    /// Delete what is kept at a place.
    Delete(Place),
}

/// What the store says.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// It is open.
    Open,
    /// Whether this tab keeps runs.
    Claimed(bool),
    /// What is kept, the latest first.
    List(Vec<Item>),
    /// What is kept at a place, and whether its newest copy was damaged.
    Read(Place, Option<(Vec<u8>, bool)>),
    /// Something is kept at a place.
    Written(Place),
    /// Nothing is kept at a place any more.
    Deleted(Place),
    /// Something went wrong, with what is at a place or with all of it.
    Failed(Option<Place>, Fault),
}
