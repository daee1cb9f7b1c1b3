//! What a person can do with what is kept, and what the page wants that is not its own to do. Plain data.

use crate::ui::page::files::Offered;
use crate::ui::page::keep::ask::Place;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// A file was chosen.
    Offered(Offered),
    /// Save what is at a place as a file.
    Export(Place),
    /// Delete what is at a place.
    Delete(Place),
    /// Delete all that is kept.
    DeleteAll,
}

/// What the page wants done elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// Open a file, whatever it is.
    Open(Offered),
}
