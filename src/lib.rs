//! Groundling: from a sentence to a moving robot.
//!
//! A sentence is parsed by a learned CCG (`ccg`) into a λ-calculus goal (`logic`), the goal is grounded in a
//! world (`ground`, `domain`) as the reward of an MDP (`mdp`), a planner earns it (`plan`), and the rooms on the
//! page show it (`render`, `ui`). The parser is learned (`learn`) from commands paired only with states before
//! and after (`corpus`): Williams, Gopalan, Rhee and Tellex, *Learning to Parse Natural Language to Grounded
//! Reward Functions with Weak Supervision*.
//!
//! Modules stand in reading order, which is the way of the data; imports go one way only
//! (`tests/suite/tidy.rs` holds both).

pub mod logic;
pub mod ccg;
pub mod mdp;
pub mod domain;
pub mod ground;
pub mod plan;
pub mod corpus;
pub mod learn;
pub mod study;
pub mod render;
pub mod worker;
pub mod ui;
