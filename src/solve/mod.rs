//! The solvers of tasks in Cleanup World, ready made. They know both what a task is and how to plan.

pub mod planner;

pub use planner::{AllStates, Planner};
