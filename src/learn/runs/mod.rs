//! Runs as data: a plan says what each run learns from, is judged on and how, so that it is repeated exactly from its
//! file; a shard is some of its runs, a pure function of plan, corpus and numbers; results are joined in the plan's order,
//! whoever worked on them.

pub mod spans;
pub mod spec;
pub mod matrix;
pub mod shard;
pub mod results;
pub mod export;

pub use matrix::Matrix;
pub use results::{RowCounts, RunResult, join};
pub use shard::{Shard, Told};
pub use spec::{Plan, RunSpec};
