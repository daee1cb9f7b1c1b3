//! The plan of some runs, as a file of JSON.

use super::spans;
use crate::corpus::Example;
use crate::corpus::json::whole_json;
use crate::learn::fingerprint::fingerprint;
use crate::learn::planning::Planning;
use crate::learn::settings::Settings;
use serde::{Deserialize, Serialize};

/// What a plan's file calls itself.
const FORMAT: &str = "groundling runs";
/// The version of its form.
const VERSION: u32 = 1;

/// The most runs of a plan.
pub const MOST_RUNS: usize = 1_000;

/// Runs on one corpus.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "a plan of runs", deny_unknown_fields)]
pub struct Plan {
    format: String,
    version: u32,
    /// What it is called.
    pub name: String,
    /// The fingerprint of the corpus.
    pub corpus: String,
    /// The number of its rows, rejected ones among them.
    pub rows: u32,
    /// Whether the runs' test halves part the corpus, so that all of them together judge it once.
    pub pooled: bool,
    /// The runs.
    pub runs: Vec<RunSpec>,
}

/// One run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunSpec {
    /// What it is called.
    pub name: String,
    /// How it learns.
    pub settings: Settings,
    /// The baseline that plans, if it does: its horizon, and the states that it may expand.
    pub planning: Option<(u32, u64)>,
    /// The rows that are learned from.
    pub train: String,
    /// The rows that are judged on.
    pub test: String,
    /// The F1 that the paper reports for this.
    pub paper_f1: Option<f64>,
}

impl Plan {
    /// A plan for a corpus that has no runs yet.
    pub(super) fn new(name: String, corpus: &[Example], pooled: bool) -> Plan {
        Plan {
            format: FORMAT.to_owned(),
            version: VERSION,
            name,
            corpus: fingerprint(corpus),
            rows: corpus.len() as u32,
            pooled,
            runs: Vec::new(),
        }
    }

    /// Reads a plan's file.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn read(text: &str) -> Result<Plan, String> {
        let plan: Plan = whole_json(text).map_err(|wrong| wrong.to_string())?;
        if plan.format != FORMAT || plan.version != VERSION {
            return Err(format!(
                "this is {:?}, version {}: a plan is {FORMAT:?}, version {VERSION}",
                plan.format, plan.version
            ));
        }
        if !(1..=MOST_RUNS).contains(&plan.runs.len()) {
            return Err(format!("a plan has 1 to {MOST_RUNS} runs"));
        }
        for RunSpec { name, settings, train, test, .. } in &plan.runs {
            settings.config().map_err(|error| format!("{name}: {error}"))?;
            let half = |text| spans::read(text, plan.rows).filter(|rows| !rows.is_empty());
            if half(train).is_none() || half(test).is_none() {
                return Err(format!("{name}: its rows are spans like 0-4,7 below {}", plan.rows));
            }
        }
        Ok(plan)
    }

    /// The plan as a file.
    pub fn write(&self) -> String {
        // A plan always has a JSON form: its maps have names for keys, and its floats are finite.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    /// Whether a corpus is the one that it was made for.
    ///
    /// # Errors
    /// In words, that it is another.
    pub fn check(&self, corpus: &[Example]) -> Result<(), String> {
        let found = fingerprint(corpus);
        if found == self.corpus && corpus.len() == self.rows as usize {
            return Ok(());
        }
        Err(format!(
            "the plan is for another corpus: its {} rows have the fingerprint {}, these {} have {found}",
            self.rows,
            self.corpus,
            corpus.len()
        ))
    }
}

impl RunSpec {
    /// The baseline that plans.
    pub(super) fn planning(&self) -> Option<Planning> {
        self.planning.map(|(horizon, budget)| Planning { horizon, memo: true, budget })
    }
}
