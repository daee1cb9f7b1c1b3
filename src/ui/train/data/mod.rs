//! The corpus: opened, mapped, looked at, decided of, parted.

pub mod words;
pub mod demo;
pub mod table;
pub mod sheet;
pub mod mapping;
pub mod action;
pub mod state;
pub mod pack;
pub mod open;
pub mod look;
pub mod care;
pub mod update;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
