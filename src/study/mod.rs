//! Studies: the tasks that people are asked to put into words, and the pairs of states that show them.

pub mod tasks;
pub mod pairs;
mod runs;
mod world;

pub use pairs::{DrawError, Drawing, Drawn, draw};
pub use tasks::{Look, Paint, Saying, StudyTask, TASKS, TaskFileError, read_tasks};
