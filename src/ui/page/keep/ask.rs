//! What is wanted of the store, and what it says.

use super::fault::Fault;
use crate::ui::page::language::Language;

/// Something for the store to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ask {
    /// Open the store.
    Open,
    /// Have this tab keep what is under a name, even if another does.
    Claim {
        /// The name.
        name: String,
        /// Whether it is taken from the tab that has it.
        steal: bool,
    },
    /// Read a session.
    Read(Place),
    /// Keep a session, packed.
    Write(Place, Vec<u8>),
    /// Keep what is kept at a place at another, too.
    Copy(Place, Place),
    /// Draw the list of what is kept into the page, in this language.
    Show(Language),
}

/// Where a text is kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Its kind.
    pub kind: String,
    /// Its name among those of its kind.
    pub name: String,
}

impl Place {
    /// A place.
    pub fn new(kind: &str, name: &str) -> Place {
        Place { kind: kind.to_owned(), name: name.to_owned() }
    }
}

/// What the store says.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// It is open.
    Open,
    /// Whether this tab keeps what it claimed.
    Claimed(bool),
    /// The session that is kept at a place, packed, or why that is none; and whether its newest copy was damaged.
    Read(Place, Option<(Result<Vec<u8>, String>, bool)>),
    /// It is kept.
    Written,
    /// Something went wrong, with what is at a place or with all of it.
    Failed(Option<Place>, Fault),
}
