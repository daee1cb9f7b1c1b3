//! The engine behind the page: one protocol, one job, pumped by the page's worker, tests and benches alike.

pub mod protocol;
mod ask;
pub mod job;

pub use job::Engine;
