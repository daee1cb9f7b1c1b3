//! The engine behind the page: one protocol, one job, pumped by the page's worker, tests and benches alike.

pub mod protocol;
mod plan;
mod watch;
mod world;
mod read;
mod ask;
mod experiment;
pub mod job;
#[cfg(target_arch = "wasm32")]
pub mod agent;

pub use job::Engine;
