//! What a person can do with what is kept, and what the store says.

use super::ask::News;
use crate::ui::page::keep::ask::Place;

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The name of what is kept next is this.
    Name(String),
    /// Keep the corpus that is open, with what was decided of it.
    KeepCorpus,
    /// Keep the model that the robot uses.
    KeepModel,
    /// Open what is kept at a place.
    Open(Place),
    /// Save what is kept at a place as a file.
    Save(Place),
    /// Delete what is kept at a place.
    Delete(Place),
    /// Keep runs in this tab, and not in another.
    KeepHere,
    /// The store said something.
    Heard(News),
}
