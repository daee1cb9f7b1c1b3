//! The corpus: opened, looked at.

pub mod corpus;
pub mod action;
pub mod state;
pub mod update;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
