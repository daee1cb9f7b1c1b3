//! The page. Everything it decides is the pure [`state::reduce`]: an [`Action`] changes the [`State`] and yields
//! [`Effect`]s, which are data; `view` (wasm only) draws the state and carries the effects out.

pub mod action;
pub mod world;
pub mod playback;
pub mod point;
pub mod proof;
pub mod chart;
pub mod engine;
pub mod corpus;
pub mod files;
pub mod describe;
pub mod why;
pub mod state;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::{Action, Effect, Timer};
pub use state::{State, reduce};
