//! The Talk page: a person says what the robot should do, sees what was understood and how it is planned and done,
//! changes the room, teaches, shares. A folder a part, each with the state that is its own; `state` holds them
//! together, `update` says which part does what a person wants, `hear` which one asked for what an engine says.
//!
//! Parts go one way: `watch` and `command` know nothing of the others' doing, `room` has the command read again, `teach`
//! learns, `why` mends by all of these, `share` opens what others made of them.

pub mod command;
pub mod watch;
pub mod room;
pub mod teach;
pub mod why;
pub mod share;
pub mod proof;
pub mod words;
pub mod action;
pub mod state;
pub mod update;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
