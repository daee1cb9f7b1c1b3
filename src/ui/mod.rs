//! The page. Everything it decides is the pure [`state::reduce`]: an [`Action`] changes the [`State`] and yields
//! [`Effect`]s, which are data; `view` (wasm only) draws the state and carries the effects out.

pub mod text;
pub mod proof;
pub mod chart;
pub mod action;
pub mod engine;
pub mod world;
pub mod point;
pub mod edit;
pub mod document;
pub mod history;
pub mod playback;
pub mod link;
pub mod why;
pub mod talk;
pub mod watch;
pub mod overlay;
pub mod room;
pub mod teach;
pub mod model;
pub mod files;
pub mod corpus;
pub mod train;
pub mod share;
pub mod hear;
pub mod state;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::{Action, Effect, Timer};
pub use state::{State, reduce};
