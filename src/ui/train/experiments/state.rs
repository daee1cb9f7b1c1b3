//! The state of experiments.

use super::matrix::Kind;
use super::pool::Pool;
use crate::worker::protocol::{Demonstrated, Joined, Settings};
use serde::Deserialize;
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
    /// The experiment whose runs are at work, and those that were given up and are to be kept no longer.
    pub begun: Vec<Begun>,
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
    /// The name that it is kept under; empty as long as it is not.
    pub name: String,
    /// What the plan says of them.
    pub about: About,
    /// The file that repeats them.
    pub plan: String,
    /// What they found.
    pub joined: Joined,
}

/// An experiment that was begun.
#[derive(Clone, Debug, PartialEq)]
pub struct Begun {
    /// Its plan.
    pub plan: String,
    /// The name that it is kept under; empty as long as it is not.
    pub name: String,
    /// Whether it was given up.
    pub is_given_up: bool,
}

/// What a plan says of its runs.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct About {
    /// What the plan is called.
    pub name: String,
    /// The runs.
    pub runs: Vec<AboutRun>,
}

/// What a plan says of a run.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct AboutRun {
    /// How it learns.
    pub settings: Settings,
}

impl Found {
    /// What the runs of a plan found, which is not kept yet.
    pub fn new(plan: String, joined: Joined) -> Found {
        Found { name: String::new(), about: About::of(&plan), plan, joined }
    }
}

impl About {
    /// What a plan says; nothing where it is none.
    pub fn of(plan: &str) -> About {
        serde_json::from_str(plan).unwrap_or_default()
    }
}

impl State {
    /// The engines at work, if they ask a model every row.
    pub fn asking(&self) -> Option<&Pool> {
        self.pool.as_ref().filter(|pool| pool.asks().is_some())
    }
}

impl Default for State {
    fn default() -> State {
        State {
            kind: Kind::default(),
            folds: 5,
            by: 0,
            seeds: 5,
            pool: None,
            begun: Vec::new(),
            six: None,
            results: Vec::new(),
            notice: None,
        }
    }
}
