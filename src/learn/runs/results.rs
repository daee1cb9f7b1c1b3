//! What runs found, as a file of JSON that a shard hands back; and how the files of all shards become one.

use super::spec::Plan;
use crate::corpus::json::whole_json;
use crate::learn::confusion::Confusion;
use crate::learn::planning::PlannerCost;
use crate::learn::report::Report;
use crate::learn::score::Mark;
use serde::{Deserialize, Serialize};

/// What a file of results calls itself.
const FORMAT: &str = "groundling results";
/// The version of its form.
const VERSION: u32 = 1;

#[derive(Serialize, Deserialize)]
#[serde(expecting = "results of runs", deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    /// The plan, by the fingerprint of its text.
    plan: String,
    // What became of the rows of the corpus' files; who was handed rows alone does not know it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rows: Option<usize>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rejected: Option<usize>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    left_out: Option<usize>,
    results: Vec<RunResult>,
}

/// What became of the rows of a corpus' files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub struct RowCounts {
    /// All that were read.
    pub rows: usize,
    /// Those that no run uses because they were rejected.
    pub rejected: usize,
    /// Those that something is wrong with.
    pub left_out: usize,
}

/// What one run found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunResult {
    /// Its place in the plan.
    pub run: u32,
    /// Commands learned from.
    pub examples: usize,
    /// Those with a valid parse in the last epoch.
    pub valid: usize,
    /// Updates in the last epoch.
    pub updates: usize,
    /// Lexical entries.
    pub entries: usize,
    /// What planning cost, in a run that plans.
    pub planner: Option<PlannerCost>,
    /// How each command was answered.
    pub marks: Vec<Mark>,
    /// What the wrong answers did instead: task, what was done, how often.
    pub confusion: Vec<(Option<String>, Option<String>, usize)>,
}

impl RunResult {
    /// How it was judged.
    pub fn report(&self) -> Report {
        let mut confusion = Confusion::default();
        for (task, does, n) in &self.confusion {
            (0..*n).for_each(|_| confusion.count(task.as_deref(), does.as_deref()));
        }
        Report { marks: self.marks.clone(), confusion }
    }
}

/// Results as a file, with what became of rows where that is known.
pub fn write(plan: &Plan, results: Vec<RunResult>, counts: Option<RowCounts>) -> String {
    let file = File {
        format: FORMAT.to_owned(),
        version: VERSION,
        plan: fingerprint(plan),
        rows: counts.map(|counts| counts.rows),
        rejected: counts.map(|counts| counts.rejected),
        left_out: counts.map(|counts| counts.left_out),
        results,
    };
    // Results always have a JSON form: they have no maps, and their floats are finite.
    serde_json::to_string(&file).unwrap_or_default() + "\n"
}

/// Reads the results of some of a plan's runs.
fn read(plan: &Plan, text: &str) -> Result<Vec<RunResult>, String> {
    let file: File = whole_json(text).map_err(|wrong| wrong.to_string())?;
    if file.format != FORMAT || file.version != VERSION {
        let File { format, version, .. } = file;
        return Err(format!(
            "this is {format:?}, version {version}: results are {FORMAT:?}, version {VERSION}"
        ));
    }
    if file.plan != fingerprint(plan) {
        return Err("the results are of another plan".to_owned());
    }
    Ok(file.results)
}

/// What became of rows, as the first of some shards' files that knows it says.
pub fn counts(shards: &[String]) -> Option<RowCounts> {
    shards.iter().find_map(|text| serde_json::from_str(text).ok())
}

/// The results of all runs of a plan, in its order, from the files of its shards in any order.
///
/// # Errors
/// In words: which file is none, or which run is missing or there twice.
pub fn join(plan: &Plan, shards: &[String]) -> Result<Vec<RunResult>, String> {
    let mut all: Vec<Option<RunResult>> = vec![None; plan.runs.len()];
    for (number, text) in (1..).zip(shards) {
        let results = read(plan, text).map_err(|error| format!("shard {number}: {error}"))?;
        for result in results {
            let place = all.get_mut(result.run as usize);
            let place = place.ok_or_else(|| format!("the plan has no run {}", result.run))?;
            if place.is_some() {
                return Err(format!("run {} is there twice", result.run));
            }
            *place = Some(result);
        }
    }
    let missing = all.iter().position(Option::is_none);
    if let Some(missing) = missing {
        return Err(format!("run {missing} is missing"));
    }
    Ok(all.into_iter().flatten().collect())
}

fn fingerprint(plan: &Plan) -> String {
    blake3::hash(plan.write().as_bytes()).to_hex().to_string()
}
