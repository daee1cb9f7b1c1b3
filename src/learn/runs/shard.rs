//! Some runs of a plan, one after the other in bounded steps: a function of plan, corpus and numbers alone.

use super::results::{RowCounts, RunResult, write};
use super::spans;
use super::spec::Plan;
use crate::corpus::Example;
use crate::learn::config::Config;
use crate::learn::experiment::{Event, Outcome, Run, Running, Selection};
use crate::learn::progress::Progress;
use std::collections::VecDeque;
use std::sync::Arc;

/// Runs at work.
pub struct Shard {
    plan: Plan,
    corpus: Arc<[Example]>,
    waiting: VecDeque<u32>,
    running: Option<(u32, Box<Running>)>,
    results: Vec<RunResult>,
}

/// What there is to say of a shard at work, and of which run of the plan.
#[derive(Clone, Debug)]
pub enum Told {
    /// Training has seen one more example, of so many, in so many passes.
    Learning(u32, Progress, u32, usize),
    /// So many commands are judged, of so many.
    Judging(u32, usize, usize),
    /// The run is over.
    Ended(u32),
}

impl Shard {
    /// The runs of these numbers.
    ///
    /// # Errors
    /// In words, when the corpus is not the plan's, or a run is not in it.
    pub fn new(plan: Plan, corpus: Arc<[Example]>, runs: Vec<u32>) -> Result<Shard, String> {
        plan.check(&corpus)?;
        if let Some(run) = runs.iter().find(|&&run| run as usize >= plan.runs.len()) {
            return Err(format!("the plan has no run {run}"));
        }
        let (waiting, running, results) = (runs.into(), None, Vec::new());
        Ok(Shard { plan, corpus, waiting, running, results })
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Whether there is nothing left to do.
    pub fn is_over(&self) -> bool {
        self.waiting.is_empty() && self.running.is_none()
    }

    /// Does a bounded part, and says what there is to say of it.
    ///
    /// # Errors
    /// In words, when a run cannot begin.
    pub fn step(&mut self) -> Result<Option<Told>, String> {
        let Some((at, running)) = &mut self.running else {
            if let Some(at) = self.waiting.pop_front() {
                self.running = Some((at, Box::new(self.begin(at)?)));
            }
            return Ok(None);
        };
        let at = *at;
        Ok(match running.step() {
            None => None,
            Some(Event::Trained(progress, examples)) => {
                Some(Told::Learning(at, progress, running.passes(), examples))
            }
            Some(Event::Judged(scores, commands)) => {
                Some(Told::Judging(at, scores.total, commands))
            }
            Some(Event::Ended { outcome, .. }) => {
                self.running = None;
                self.results.push(result(at, *outcome));
                Some(Told::Ended(at))
            }
        })
    }

    fn begin(&self, at: u32) -> Result<Running, String> {
        let spec = self.plan.runs.get(at as usize).ok_or("the plan has no such run")?;
        let half = |text: &str| {
            Selection::of(&self.corpus, spans::read(text, self.plan.rows).unwrap_or_default())
        };
        let run = Run {
            name: spec.name.clone(),
            train: half(&spec.train),
            test: half(&spec.test),
            config: Config { planning: spec.planning(), ..spec.settings.config()? },
            paper_f1: spec.paper_f1,
        };
        Ok(Running::new(run, spec.settings.seed_model()?))
    }

    /// The results as a file, once it is over, with what became of the corpus' rows where that is known.
    pub fn end(self, counts: Option<RowCounts>) -> String {
        write(&self.plan, self.results, counts)
    }
}

fn result(run: u32, outcome: Outcome) -> RunResult {
    let Outcome { examples, last, planner, report } = outcome;
    let cells = report.confusion.cells();
    let name = |name: Option<&str>| name.map(str::to_owned);
    RunResult {
        run,
        examples,
        valid: last.valid,
        updates: last.updates,
        entries: last.entries,
        planner,
        confusion: cells.map(|(task, does, n)| (name(task), name(does), n)).collect(),
        marks: report.marks,
    }
}
