//! What Groundling computes with: logical forms, Cleanup World, goals grounded in it, and the planners that earn them. A
//! crate of its own, so that a program that is made to be small can have it made for speed (profile `talk`). All else
//! reaches it through `groundling`, whose invariants are its own.

pub mod logic;
pub mod mdp;
pub mod domain;
pub mod ground;
pub mod plan;
pub mod solve;
