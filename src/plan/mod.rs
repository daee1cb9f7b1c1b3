//! Planners. They know a problem only as an [`crate::mdp::Mdp`].

pub mod astar;

pub use astar::{AStar, Budget, Outcome, Solution};
