//! Experiments: runs that are planned together, shared out among engines, and compared.

pub mod words;
pub mod matrix;
pub mod pool;
pub mod picture;
pub mod action;
pub mod state;
pub mod file;
pub mod share;
pub mod update;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
