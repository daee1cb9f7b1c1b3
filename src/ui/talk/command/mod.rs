//! What is said to the robot: the command box, what a command is taken to mean, and what came of it.

pub mod link;
pub mod state;
pub mod offer;
pub mod query;
pub mod wonder;
pub mod ask;
pub mod examples;
pub mod study;
pub mod answer;
pub mod say;
