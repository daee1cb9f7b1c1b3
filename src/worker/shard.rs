//! Runs of a plan in the engine: planned on the sheet as it is parted, some of them run, the results of all joined.

use super::demonstration::judgement;
use super::job::{Job, Step};
use super::progress::progress;
use super::protocol::{Event, ExperimentProgress, Joined, Matrix, RunPart, RunReport, Settings};
use crate::learn::runs::{Plan, RunResult, Shard, Told, export, join, results};
use crate::learn::sheet::{Half, Sheet};

/// The plan of runs on a sheet as it is parted now.
pub(super) fn plan(sheet: &Sheet, matrix: &Matrix, settings: &Settings) -> Result<Event, String> {
    let halves = (sheet.rows_in(Half::Train), sheet.rows_in(Half::HeldOut));
    let plan = matrix.plan(settings, sheet.examples(), (&halves.0, &halves.1))?;
    Ok(Event::Plan { text: plan.write() })
}

/// Some runs of a plan.
pub(super) fn run<R>(sheet: &Sheet, plan: &str, runs: Vec<u32>) -> Result<Job<R>, String> {
    let plan = read(plan)?;
    let n_runs = runs.len();
    let places = runs.clone();
    let mut shard =
        Some(Shard::new(plan, sheet.examples().clone(), runs).map_err(|error| sentence(&error))?);
    Ok(Box::new(move |_| match shard.take_if(|shard| shard.is_over()) {
        Some(done) => Step::Over(Event::Shard { text: done.end(None) }),
        None => {
            let Some(shard) = &mut shard else { return Step::Over(Event::Cancelled) };
            match shard.step() {
                Err(message) => Step::Over(Event::Refused { message: sentence(&message) }),
                Ok(told) => Step::Working(told.and_then(|told| {
                    let (at, part) = part(told)?;
                    let name = shard.plan().runs.get(at as usize)?.name.clone();
                    let run = places.iter().position(|&place| place == at)?;
                    Some(Event::Experimenting(ExperimentProgress { run, runs: n_runs, name, part }))
                })),
            }
        }
    }))
}

fn part(told: Told) -> Option<(u32, RunPart)> {
    match told {
        Told::Learning(at, done, passes, examples) => {
            Some((at, RunPart::Learning(progress(done, passes, examples))))
        }
        Told::Judging(at, judged, commands) => Some((at, RunPart::Judging { judged, commands })),
        Told::Ended(_) => None,
    }
}

/// What all runs of a plan found.
pub(super) fn joined(plan: &str, shards: &[String]) -> Result<Event, String> {
    let plan = read(plan)?;
    let found = join(&plan, shards).map_err(|error| sentence(&error))?;
    let report = |(spec, result): (&_, &RunResult)| {
        let spec: &crate::learn::runs::RunSpec = spec;
        RunReport {
            name: spec.name.clone(),
            examples: result.examples,
            valid: result.valid,
            entries: result.entries,
            paper_f1: spec.paper_f1,
            planner: result.planner,
            judgement: judgement(&result.report()),
        }
    };
    Ok(Event::Joined(Box::new(Joined {
        runs: plan.runs.iter().zip(&found).map(report).collect(),
        all: plan.pooled.then(|| judgement(&export::all(&found))),
        csv: export::csv(&plan, &found),
        markdown: export::markdown(&plan, &found),
        results: results::write(&plan, found, results::counts(shards)),
    })))
}

fn read(plan: &str) -> Result<Plan, String> {
    Plan::read(plan).map_err(|error| format!("The plan cannot be read: {error}."))
}

/// What is wrong as a sentence of its own.
fn sentence(what: &str) -> String {
    let mut letters = what.trim_end_matches('.').chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).chain(['.']).collect()
}
