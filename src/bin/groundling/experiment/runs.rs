//! `experiment plan`, `run`, `shard` and `join`: runs as data. A plan is a file that repeats its runs exactly; a shard is
//! some of them, for machines that share a plan out; joined they are what one machine finds alone.

use super::options::{Common, missing};
use crate::arguments::Arguments;
use crate::corpora::{Rows, text};
use crate::failure::Failure;
use groundling::corpus::{Decision, Example};
use groundling::learn::runs::{
    Matrix, Plan, RowCounts, RunResult, Shard, Told, export, join as joined, results, spans,
};
use groundling::learn::settings::Lexicon;
use groundling::learn::{SeedLexicon, Settings};
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// The form of results.
#[derive(Clone, Copy)]
enum Form {
    Markdown,
    Csv,
    Json,
}

/// A plan for what is given.
pub(super) fn plan(mut given: Arguments) -> Result<String, Failure> {
    let mut common = Common::new();
    let (mut corpus, mut held_out, mut matrix) = (Vec::new(), Vec::new(), Matrix::Once);
    while let Some(name) = given.option()? {
        match name.as_str() {
            "corpus" => corpus.extend(given.files()?),
            "held-out" => held_out.extend(given.files()?),
            "matrix" => {
                let text = given.text()?;
                matrix = Matrix::read(&text)
                    .map_err(|e| Failure::Usage(format!("--matrix {text}: {e}")))?;
            }
            _ => common.take(&name, &mut given)?,
        }
    }
    if corpus.is_empty() {
        return Err(missing("--corpus FILE"));
    }
    let first = common.all_rows(&corpus)?;
    let second = if held_out.is_empty() { Vec::new() } else { common.all_rows(&held_out)? };
    let (n, with_rejected) = (first.len() as u32, common.with_rejected);
    let rows: Vec<Example> = first.into_iter().chain(second).collect();
    let is_used = |row: &u32| {
        let decision = rows.get(*row as usize).map(|example| &example.decision);
        with_rejected || !matches!(decision, Some(Decision::Rejected(_)))
    };
    let train: Vec<u32> = (0..n).filter(is_used).collect();
    let test: Vec<u32> = (n..rows.len() as u32).filter(is_used).collect();
    common.rows = common.rows.rejecting(rows.len() - train.len() - test.len(), "--with-rejected");
    let config = &common.config;
    let settings = Settings {
        lexicon: match common.lexicon_text()? {
            Some(text) => Lexicon::Own(text),
            None => Lexicon::Here(SeedLexicon::Domain),
        },
        epochs: config.epochs,
        demonstrations: config.demonstrations,
        seed: config.seed,
        idioms: config.idioms,
        ..Settings::default()
    };
    let plan = matrix.plan(&settings, &rows, (&train, &test)).map_err(Failure::Usage)?;
    tell(common.rows);
    Ok(plan.write().trim_end().to_owned())
}

/// All runs of a plan.
pub(super) fn run(given: Arguments) -> Result<String, Failure> {
    let (plan, rows, _, common, form) = read(given)?;
    let counts = common.rows.counts();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            if at >= plan.runs.len() {
                return Ok(done);
            }
            done.push(pump(&plan, &rows, vec![at as u32], counts)?);
        }
    };
    let shards: Result<Vec<Vec<String>>, Failure> = thread::scope(|scope| {
        let n_threads = common.jobs.clamp(1, plan.runs.len().max(1));
        let threads: Vec<_> = (0..n_threads).map(|_| scope.spawn(work)).collect();
        let join = |thread: thread::ScopedJoinHandle<'_, _>| {
            thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        threads.into_iter().map(join).collect()
    });
    let found = joined(&plan, &shards?.concat()).map_err(Failure::Usage)?;
    Ok(told(&plan, found, Some(counts), form))
}

/// Some runs of a plan.
pub(super) fn shard(given: Arguments) -> Result<String, Failure> {
    let (plan, rows, runs, common, _) = read(given)?;
    let runs = if runs.is_empty() { (0..plan.runs.len() as u32).collect() } else { runs };
    Ok(pump(&plan, &rows, runs, common.rows.counts())?.trim_end().to_owned())
}

/// What all shards of a plan found.
pub(super) fn join(mut given: Arguments) -> Result<String, Failure> {
    let (mut plan, mut shards, mut form) = (None::<PathBuf>, Vec::new(), Form::Markdown);
    while let Some(name) = given.option()? {
        match name.as_str() {
            "plan" => plan = Some(given.file()?),
            "shard" => shards.extend(given.files()?),
            "json" => form = Form::Json,
            "csv" => form = Form::Csv,
            _ => return Err(given.unknown()),
        }
    }
    let plan = plan_in(&plan.ok_or_else(|| missing("--plan FILE"))?)?;
    let texts: Vec<String> = shards.iter().map(|path| text(path)).collect::<Result<_, _>>()?;
    let found = joined(&plan, &texts).map_err(Failure::Usage)?;
    Ok(told(&plan, found, results::counts(&texts), form))
}

type Given4 = (Plan, Arc<[Example]>, Vec<u32>, Common, Form);

fn read(mut given: Arguments) -> Result<Given4, Failure> {
    let mut common = Common::new();
    let (mut plan, mut corpus, mut runs) = (None::<PathBuf>, Vec::new(), Vec::new());
    let mut form = Form::Markdown;
    while let Some(name) = given.option()? {
        match name.as_str() {
            "plan" => plan = Some(given.file()?),
            "corpus" => corpus.extend(given.files()?),
            "run" => runs.extend(given.wholes::<u32>()?),
            "json" => form = Form::Json,
            "csv" => form = Form::Csv,
            "jobs" => common.take(&name, &mut given)?,
            _ => return Err(given.unknown()),
        }
    }
    let plan = plan_in(&plan.ok_or_else(|| missing("--plan FILE"))?)?;
    if corpus.is_empty() {
        return Err(missing("--corpus FILE"));
    }
    let rows: Arc<[Example]> = common.all_rows(&corpus)?.into();
    plan.check(&rows).map_err(Failure::Usage)?;
    common.rows = common.rows.rejecting(rejected(&plan, &rows), "a plan made with --with-rejected");
    tell(common.rows);
    Ok((plan, rows, runs, common, form))
}

/// How many rejected rows no run of a plan uses.
fn rejected(plan: &Plan, rows: &[Example]) -> usize {
    let halves = plan.runs.iter().flat_map(|run| [&run.train, &run.test]);
    let used: BTreeSet<u32> =
        halves.flat_map(|half| spans::read(half, plan.rows).unwrap_or_default()).collect();
    let is_rejected = |example: &Example| matches!(example.decision, Decision::Rejected(_));
    (0..).zip(rows).filter(|(at, row)| is_rejected(row) && !used.contains(at)).count()
}

/// Says on standard error what became of rows; the work goes on when nobody listens there.
fn tell(rows: Rows) {
    let _ = writeln!(io::stderr(), "{rows}");
}

fn plan_in(path: &std::path::Path) -> Result<Plan, Failure> {
    Plan::read(&text(path)?)
        .map_err(|e| Failure::Usage(format!("{}: no plan: {e}", path.display())))
}

/// Runs some runs of a plan; their results as a file.
fn pump(
    plan: &Plan,
    rows: &Arc<[Example]>,
    runs: Vec<u32>,
    counts: RowCounts,
) -> Result<String, Failure> {
    let mut shard = Shard::new(plan.clone(), rows.clone(), runs).map_err(Failure::Usage)?;
    while !shard.is_over() {
        if let Some(Told::Ended(at)) = shard.step().map_err(Failure::Usage)? {
            let name = plan.runs.get(at as usize).map_or("", |run| run.name.as_str());
            // Standard error may be gone; the work goes on.
            let _ = writeln!(io::stderr(), "{name}: done");
        }
    }
    Ok(shard.end(Some(counts)))
}

fn told(plan: &Plan, found: Vec<RunResult>, counts: Option<RowCounts>, form: Form) -> String {
    let mut text = match form {
        Form::Markdown => {
            let rows = counts.map(|counts| format!("\n{}\n", Rows::from(counts)));
            export::markdown(plan, &found) + &rows.unwrap_or_default()
        }
        Form::Csv => export::csv(plan, &found),
        Form::Json => results::write(plan, found, counts),
    };
    // Who prints it ends the line.
    if text.ends_with('\n') {
        text.pop();
    }
    text
}
