//! `experiment table3`: what planning during learning costs and what it brings, at the paper's horizons, beside
//! learning without it.

use super::options::{Common, missing};
use super::table;
use crate::arguments::Arguments;
use crate::failure::Failure;
use crate::parallel::{Finished, run_all};
use groundling::learn::experiment::{Selection, table_3};
use groundling::learn::{CLEANUP_LEXICON, Planning, paper};
use serde_json::json;

pub(super) fn run(mut given: Arguments) -> Result<String, Failure> {
    // One run at a time, unless asked: side by side they would share what the clock on the wall measures.
    let mut common = Common::new();
    common.jobs = 1;
    let (mut train, mut test) = (Vec::new(), Vec::new());
    let mut budget = Planning::default().budget;
    let mut memos = vec![true];
    while let Some(name) = given.option()? {
        match name.as_str() {
            "train" => train.extend(given.files()?),
            "test" => test.extend(given.files()?),
            "budget" => budget = given.whole()?,
            "without-memo" => memos = vec![true, false],
            _ => common.take(&name, &mut given)?,
        }
    }
    if train.is_empty() {
        return Err(missing("--train FILE"));
    }
    if test.is_empty() {
        return Err(missing("--test FILE"));
    }
    let train = Selection::all(&common.rows(&train)?);
    let test = Selection::all(&common.rows(&test)?);
    let runs = table_3(&train, &test, &common.config, budget, &memos);
    let finished = run_all(&runs, &common.seed(CLEANUP_LEXICON)?, common.jobs);
    if !common.json {
        return Ok(common.told(&text(&finished)));
    }
    let mut lines = table::json(&finished);
    for (line, done) in lines.as_array_mut().into_iter().flatten().zip(&finished) {
        line["paper_seconds"] = paper_seconds(done).into();
    }
    let report = json!({ "experiment": "table3", "source": paper::SOURCE, "runs": lines });
    Ok(common.report(report))
}

fn paper_seconds(done: &Finished) -> Option<f64> {
    let horizon = done.run.config.planning.map(|planning| planning.horizon);
    paper::table_3(horizon).map(|row| row.seconds)
}

/// The table, and under it what the planners did.
fn text(finished: &[Finished]) -> String {
    let mut lines = vec![
        format!("Learning with and without a planner ({})", paper::SOURCE),
        table::text(finished),
        String::new(),
        format!(
            "{:<20}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>11}  {:>8}",
            "time to learn, seconds",
            "paper",
            "ours",
            "ours, CPU",
            "calls",
            "by memo",
            "states",
            "given up"
        ),
    ];
    for done in finished {
        let paper = paper_seconds(done).map_or("–".to_owned(), |seconds| format!("{seconds:.0}"));
        let cost = done.outcome.planner.unwrap_or_default();
        lines.push(format!(
            "{:<22}  {paper:>9}  {:>9.2}  {:>9.2}  {:>9}  {:>9}  {:>11}  {:>8}",
            done.run.name,
            done.learning.wall,
            done.learning.cpu,
            cost.calls,
            cost.saved,
            cost.expanded,
            cost.given_up,
        ));
    }
    lines.join("\n")
}
