//! Planners. They know a problem only as an [`crate::mdp::Mdp`].

mod graph;
pub mod astar;
pub mod value_iteration;
pub mod lrtdp;

pub use astar::{AStar, Solution};
pub use lrtdp::Lrtdp;
pub use value_iteration::ValueIteration;
