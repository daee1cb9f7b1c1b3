//! The state of the workbench: what its parts share, and each part's own.

use super::desk::Desk;
use super::{data, run};

/// All that the workbench knows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// What the parts are lent.
    pub desk: Desk,
    /// Whether it is to be seen.
    pub shown: bool,
    /// The corpus.
    pub data: data::State,
    /// Training.
    pub run: run::State,
}
