//! What was learned: the lexicon by words and meanings, where the model errs, and what tells two models apart.

pub mod words;
pub mod action;
pub mod state;
pub mod update;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
