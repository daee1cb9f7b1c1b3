//! The page that drives a robot (`robot.html`): a program of its own, which links no parser, no planner and no renderer. The
//! engine that talks is the front page's, fetched when it is wanted first.
//!
//! What a person does, what the link and the engine say and the time that goes by are actions; `update` changes the state
//! and yields effects, which are data. A robot that is simulated lives in the state, behind the frames that a real one sends
//! and takes (`drive`), so that all of it is one way, and is pure.

pub mod words;
pub mod talker;
pub mod action;
pub mod effect;
pub mod state;
pub mod think;
pub mod drive;
pub mod place;
pub mod kept;
pub mod ask;
pub mod update;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use effect::Effect;
pub use state::State;
pub use update::reduce;
