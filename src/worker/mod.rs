//! The engines behind the page: one protocol, two programs (one talks, one learns), each one job at a time, pumped by
//! the page's workers, tests and benches alike.

pub mod protocol;
mod solving;
mod plan;
mod course;
mod watch;
mod world;
mod read;
mod ask;
mod choose;
mod examples;
pub mod job;
pub mod reports;
mod talker;
mod progress;
mod demonstration;
mod lesson;
mod teaching;
mod training;
mod shard;
mod study;
mod review;
mod learner;
mod bench;
#[cfg(target_arch = "wasm32")]
pub mod agent;

pub use job::Engine;
pub use learner::Learner;
pub use talker::Talker;
