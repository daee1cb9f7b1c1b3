//! Planners. They know a problem only as an [`crate::mdp::Mdp`].

mod index;
mod weights;
mod graph;
mod order;
pub mod astar;
mod parts;
pub mod anytime;
pub mod value_iteration;
pub mod lrtdp;
pub mod uct;
pub mod choose;

pub use anytime::AnyTime;
pub use astar::{AStar, Solution};
pub use choose::{AnySolver, Auto, SOLVERS, Why};
pub use lrtdp::Lrtdp;
pub use uct::Uct;
pub use value_iteration::ValueIteration;
