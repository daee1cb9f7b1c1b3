//! The Train page: a corpus is opened and looked at, a parser is trained on it.

pub mod corpus;
pub mod words;
pub mod action;
pub mod state;
pub mod update;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::{Action, Wish};
pub use state::State;
