//! Experiments: runs of training and judging that do not depend on each other, each a pure function of corpora,
//! seed lexicon and settings, pumped in bounded steps. Whoever owns threads may run them side by side.

use super::config::Config;
use super::evaluate::Judge;
use super::paper;
use super::planning::{PlannerCost, Planning};
use super::progress::{Epoch, Progress};
use super::report::Report;
use super::score::Scores;
use super::trainer::Trainer;
use crate::ccg::{ChartConfig, Model, words};
use crate::corpus::{Example, Fold, folds, leave};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Some rows of a corpus; a corpus is shared between the runs that use it.
#[derive(Clone, Debug)]
pub struct Selection {
    corpus: Arc<[Example]>,
    /// `None` for all.
    rows: Option<Vec<u32>>,
}

impl Selection {
    /// All rows.
    pub fn all(corpus: &Arc<[Example]>) -> Self {
        Selection { corpus: corpus.clone(), rows: None }
    }

    /// The rows with these indices; those that there are.
    pub fn of(corpus: &Arc<[Example]>, rows: Vec<u32>) -> Self {
        Selection { corpus: corpus.clone(), rows: Some(rows) }
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.rows.as_ref().map_or(self.corpus.len(), Vec::len)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The rows.
    pub fn examples(&self) -> Vec<Example> {
        match &self.rows {
            None => self.corpus.to_vec(),
            Some(rows) => {
                rows.iter().filter_map(|&row| self.corpus.get(row as usize)).cloned().collect()
            }
        }
    }
}

/// One run: what is learned from, what is judged on, and how.
#[derive(Clone, Debug)]
pub struct Run {
    /// What a table calls it.
    pub name: String,
    /// What is learned from.
    pub train: Selection,
    /// What is judged on.
    pub test: Selection,
    /// The settings of training.
    pub config: Config,
    /// The F1 that the paper reports for this.
    pub paper_f1: Option<f64>,
}

/// What a run found.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Examples learned from.
    pub examples: usize,
    /// What the last epoch did.
    pub last: Epoch,
    /// What planning cost, in a run that plans.
    pub planner: Option<PlannerCost>,
    /// The judgement.
    pub report: Report,
}

/// What there is to say of a run at work.
#[derive(Clone, Debug)]
pub enum Event {
    /// Training has seen one more example of so many.
    Trained(Progress, usize),
    /// One more command was judged, of so many.
    Judged(Scores, usize),
    /// The run is over.
    Ended {
        /// What it found.
        outcome: Box<Outcome>,
        /// What it learned.
        model: Box<Model>,
    },
}

/// A run at work.
pub struct Running {
    run: Run,
    last: Epoch,
    planner: Option<PlannerCost>,
    stage: Stage,
}

enum Stage {
    Training(Box<Trainer>),
    Judging(Box<Judging>),
    Over,
}

struct Judging {
    model: Model,
    examples: Vec<Example>,
    judge: Judge,
}

impl Running {
    /// A run that begins, from a model that knows a seed lexicon.
    pub fn new(run: Run, seed: Model) -> Self {
        let trainer = Trainer::new(seed, &run.train.examples(), run.config.clone());
        let stage = Stage::Training(Box::new(trainer));
        Running { run, last: Epoch::default(), planner: None, stage }
    }

    /// Passes over the corpus in all.
    pub fn passes(&self) -> u32 {
        self.run.config.passes()
    }

    /// Whether training is done.
    pub fn is_trained(&self) -> bool {
        !matches!(self.stage, Stage::Training(_))
    }

    /// Whether there is nothing left to do.
    pub fn is_over(&self) -> bool {
        matches!(self.stage, Stage::Over)
    }

    /// Does a bounded part, and says what there is to say of it.
    pub fn step(&mut self) -> Option<Event> {
        match &mut self.stage {
            Stage::Training(trainer) if !trainer.is_done() => {
                let progress = trainer.step()?;
                self.last = progress.so_far;
                Some(Event::Trained(progress, trainer.n_examples()))
            }
            Stage::Training(_) => {
                let Stage::Training(trainer) = std::mem::replace(&mut self.stage, Stage::Over)
                else {
                    return None;
                };
                self.planner = trainer.planner_cost();
                let model = trainer.end();
                let examples = self.run.test.examples();
                let judge = Judge::new(&examples, ChartConfig::of(&model));
                self.stage = Stage::Judging(Box::new(Judging { model, examples, judge }));
                None
            }
            Stage::Judging(judging) => {
                let Judging { model, examples, judge } = &mut **judging;
                if let Some(example) = examples.get(judge.scores().total) {
                    let scores = judge.ask(model, example);
                    return Some(Event::Judged(scores, examples.len()));
                }
                let outcome = Outcome {
                    examples: self.run.train.len(),
                    last: self.last,
                    planner: self.planner,
                    report: judge.take_report(),
                };
                let outcome = Box::new(outcome);
                let model = Box::new(std::mem::take(model));
                self.stage = Stage::Over;
                Some(Event::Ended { outcome, model })
            }
            Stage::Over => None,
        }
    }
}

/// What stays together in cross-validation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum By {
    /// Commands that are the same when their words are.
    Command,
    /// Nothing: every row by itself, as in the paper's own split.
    Row,
    /// Commands of one task; those without a label are one task more.
    Task,
    /// Commands of one person; those that do not tell are one person more.
    Worker,
}

impl By {
    /// All ways, by name.
    pub const ALL: [(&'static str, By); 4] =
        [("command", By::Command), ("row", By::Row), ("task", By::Task), ("worker", By::Worker)];

    /// What parts a corpus in this way: examples with the same key stay together.
    pub fn keys(self, corpus: &[Example]) -> Vec<String> {
        corpus.iter().enumerate().map(|row| self.key(row)).collect()
    }

    fn key(self, (row, example): (usize, &Example)) -> String {
        match self {
            By::Command => words(&example.command).join(" "),
            By::Row => row.to_string(),
            By::Task => example.task.clone().unwrap_or_default(),
            By::Worker => example.worker.clone().unwrap_or_default(),
        }
    }
}

/// The runs of a cross-validation: for each of `n` folds, training on all others and judging on it.
pub fn cross(corpus: &Arc<[Example]>, n: u32, by: By, config: &Config) -> Vec<Run> {
    cross_by(corpus, n, &by.keys(corpus), config)
}

/// The same for whatever parts a corpus: rows with the same key, of which there is one a row, stay together. A fold
/// that would judge nothing, or learn from nothing, is none.
pub fn cross_by(corpus: &Arc<[Example]>, n: u32, keys: &[String], config: &Config) -> Vec<Run> {
    let folds = folds(keys, n, config.seed).into_iter();
    let folds = folds.filter(|fold| !fold.test.is_empty() && !fold.train.is_empty());
    (1..).zip(folds).map(|(n, fold)| parted(corpus, format!("fold {n}"), fold, config)).collect()
}

/// As many runs as `draws`, each trained without all rows of `n` keys, drawn by chance, and judged on those. There is a key
/// a row, and a kind: no kind is left out whole.
pub fn left_out(
    corpus: &Arc<[Example]>,
    (keys, kinds): (&[String], &[String]),
    (n, draws): (usize, u32),
    config: &Config,
) -> Vec<Run> {
    let draw = |draw| (draw + 1, leave(keys, kinds, n, config.seed.wrapping_add(draw)));
    let folds = (0..draws).map(draw);
    let folds = folds.filter(|(_, fold)| !fold.test.is_empty() && !fold.train.is_empty());
    folds.map(|(n, fold)| parted(corpus, format!("draw {n}"), fold, config)).collect()
}

/// A run on two parts of a corpus.
fn parted(corpus: &Arc<[Example]>, name: String, fold: Fold, config: &Config) -> Run {
    Run {
        name,
        train: Selection::of(corpus, fold.train),
        test: Selection::of(corpus, fold.test),
        config: config.clone(),
        paper_f1: None,
    }
}

/// The rows of Table II for one set: all three, the first two, the first of each command's demonstrations, judged
/// on the same test set. `name` is the set's; those of the paper are `raw` and `pruned`.
pub fn table_2(name: &str, train: &Selection, test: &Selection, config: &Config) -> Vec<Run> {
    let run = |demonstrations| Run {
        name: format!("{name}, {demonstrations}"),
        train: train.clone(),
        test: test.clone(),
        config: Config { demonstrations: Some(demonstrations), ..config.clone() },
        paper_f1: paper::table_2(name, demonstrations),
    };
    [3, 2, 1].map(run).into()
}

/// The rows of Table III: learning without a planner, and with one for each of the paper's horizons; after those,
/// if asked for, the same without memo. `budget` is [`Planning::budget`].
pub fn table_3(
    train: &Selection,
    test: &Selection,
    config: &Config,
    budget: u64,
    memos: &[bool],
) -> Vec<Run> {
    let run = |planning: Option<Planning>| {
        let horizon = planning.map(|planning| planning.horizon);
        let name = match planning {
            None => "no planning".to_owned(),
            Some(Planning { horizon, memo: true, .. }) => format!("horizon {horizon}"),
            Some(Planning { horizon, memo: false, .. }) => format!("horizon {horizon}, no memo"),
        };
        Run {
            name,
            train: train.clone(),
            test: test.clone(),
            config: Config { planning, ..config.clone() },
            paper_f1: paper::table_3(horizon).map(|row| row.f1),
        }
    };
    let mut runs = vec![run(None)];
    for &memo in memos {
        let horizons = paper::TABLE_3.iter().filter_map(|row| row.horizon);
        runs.extend(horizons.map(|horizon| run(Some(Planning { horizon, memo, budget }))));
    }
    runs
}
