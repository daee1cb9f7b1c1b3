//! The state of experiments.

use super::matrix::Kind;
use super::pool::Pool;
use crate::worker::protocol::{Demonstrated, Joined};
use std::rc::Rc;

/// All that is known of experiments.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The experiment that is chosen.
    pub kind: Kind,
    /// Parts of a cross-validation.
    pub folds: u32,
    /// What stays together, by its place in the list of all.
    pub by: usize,
    /// How many seeds.
    pub seeds: u32,
    /// The engines at work.
    pub pool: Option<Pool>,
    /// What came of the paper's six sentences.
    pub six: Option<Rc<Demonstrated>>,
    /// What the runs found, the last experiment first.
    pub results: Vec<Rc<Found>>,
    /// What came of an experiment, when it is no result.
    pub notice: Option<String>,
}

/// What the runs of a plan found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The file that repeats them.
    pub plan: String,
    /// What they found.
    pub joined: Joined,
}

impl Default for State {
    fn default() -> State {
        State {
            kind: Kind::default(),
            folds: 5,
            by: 0,
            seeds: 5,
            pool: None,
            six: None,
            results: Vec::new(),
            notice: None,
        }
    }
}
