//! Studies, for who makes them and reviews what people answered: a study is drawn and saved, or opened; answers are
//! merged, flagged, judged by a model, decided, and saved or handed to training.

pub mod words;
pub mod action;
pub mod state;
pub mod update;
pub mod files;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
