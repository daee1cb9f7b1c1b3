//! The problem interface between worlds and planners: what a Markov decision process is, here.
//! A problem is an [`Mdp`]; a solver holds settings and a policy holds the result.

pub mod problem;
pub mod simulate;
pub mod check;

pub use check::{Fault, check};
pub use problem::Mdp;
pub use simulate::{sample, simulate};
