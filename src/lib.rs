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
//!
//! What holds throughout, each with its tests:
//!
//! 1. Equal term ids are α-equivalent, β-normal terms with conjuncts in one order; printing and reading is the identity.
//! 2. The core (all but `*/gpu`, `*/agent`, `robot/link`, `ui/**/view` and `bin`) has no clock, no randomness of its own, no
//!    threads, no printing and no browser: callers pass seeds, times and budgets.
//! 3. The same corpus, settings and seed give the same model, byte for byte, natively and in the browser.
//! 4. `the` and `argmax` are resolved only in `ground`, in the initial state; a `Goal` of states or a `Course` of runs cannot
//!    be made otherwise.
//! 5. Learning never plans, but for the planning validator that Table III compares with.
//! 6. Ids never leave the owner of their arena; between programs and in files go text and plain data, with a version.
//! 7. Bad input is no error of the program: it is answered with its place and a remedy, and nothing is lost.
//! 8. No reading is silent about a word that turns round, excludes, joins or orders: it is used with its meaning, or
//!    named as left out (`ccg::closed`).
//! 9. Long work goes in bounded steps, so that a cancel and a look at how far it is are answered at once.

pub use groundling_kernel::{domain, ground, logic, mdp, plan, solve};

pub mod ccg;
pub mod corpus;
pub mod learn;
pub mod study;
pub mod render;
pub mod worker;
pub mod robot;
pub mod ui;
