//! The page that asks people (`collect.html`): a program of its own, which links no parser, no planner and no renderer.
//!
//! A person comes by a link. The study comes as a file beside the page, or inside the link. After consent, instructions
//! and a worked example come the items, each with its pictures and a box for the command; then the study's ends, one
//! after another; then the journal is erased, and all that stays is that it is over, and the code.
//!
//! `update` is the reducer: an action changes the state and yields effects, which are data. What happens is kept as notes
//! (`study::journal`) before the page moves on: a note is written, the browser says that it is kept, and only then is it
//! part of the sitting. So whatever kills the page, the next visit reads the same notes and goes on behind the last one.
//! Where nothing can be kept the person is told, and the page goes on in memory. One tab has the sitting, by the
//! browser's lock on its name; another may take it over, which reads the notes anew.
//!
//! A preview keeps and sends nothing. A participant that is simulated (`view/rehearse`) presses the same buttons.

pub mod words;
pub mod action;
pub mod effect;
pub mod outbox;
pub mod state;
pub mod ending;
pub mod change;
pub mod runs;
mod arrive;
mod leave;
mod notes;
pub mod update;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use effect::Effect;
pub use state::State;
pub use update::reduce;
