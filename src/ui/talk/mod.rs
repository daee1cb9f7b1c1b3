//! The Talk page: a person says what the robot should do, sees what was understood and how it is planned and done,
//! changes the room, teaches, shares. A folder a part, each with the state that is its own; `state` holds them
//! together, `update` says which part does what a person wants, `hear` which one asked for what an engine says.
//!
//! What is done goes one way: `room` has the command in the box read again (`command/ask`), `command/answer` asks what
//! went wrong (`why/messages`), `why/mend` helps by what `command`, `room` and `teach` can do, `share` opens what these
//! have made; none of them comes back.

pub mod command;
pub mod past;
pub mod watch;
pub mod room;
pub mod teach;
pub mod why;
pub mod share;
pub mod proof;
pub mod words;
pub mod demo;
pub mod action;
pub mod state;
pub mod update;
pub mod hear;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
