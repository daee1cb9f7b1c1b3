//! The problem interface between worlds and planners: what a Markov decision process is, here.
//! A problem is an [`Mdp`]; a solver holds settings and a policy holds the result.

pub mod problem;

pub use problem::Mdp;
