//! Training: its settings, begun, paused, followed step by step, gone on with, and what comes of it.

pub mod words;
pub mod clock;
pub mod curve;
pub mod chart;
pub mod picture;
pub mod action;
pub mod state;
pub mod file;
pub mod hear;
pub mod update;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
