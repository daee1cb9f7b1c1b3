//! The runs that are worth a plan: the paper's tables, cross-validation, learning curves, and what is lost without some
//! features or demonstrations.

use super::spans;
use super::spec::{MOST_RUNS, Plan, RunSpec};
use crate::ccg::Kind;
use crate::corpus::json::whole_json;
use crate::corpus::{Example, Wrong, folds, share};
use crate::learn::experiment::By;
use crate::learn::paper;
use crate::learn::settings::Settings;
use serde::{Deserialize, Serialize};

/// Which runs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Matrix {
    /// One, on what is held out.
    Once,
    /// The rows of the paper's Table II for one set: 3, 2 and 1 demonstrations a command.
    Table2 {
        /// What the set is called; the paper's are `raw` and `pruned`.
        set: String,
    },
    /// The paper's Table III: without a planner, and with one of horizon 1, 10 and 20.
    Table3 {
        /// States that a run's planner may expand.
        budget: u64,
    },
    /// Cross-validation on what is learned from.
    Cross {
        /// Parts.
        folds: u32,
        /// What stays together.
        by: By,
    },
    /// A learning curve: shares of what is learned from, judged on what is held out.
    Curve {
        /// The shares, in percent.
        percents: Vec<u32>,
        /// What stays together.
        by: By,
    },
    /// What is lost without each of some kinds of features, with so many demonstrations each time.
    Ablation {
        /// The kinds; all of them together are there once more, with nothing left out.
        kinds: Vec<Kind>,
        /// Numbers of demonstrations; none for that of the settings.
        demonstrations: Vec<u32>,
    },
    /// The same run with several seeds.
    Seeds {
        /// How many, from the settings' seed on.
        count: u32,
    },
}

impl Matrix {
    /// Reads which runs a text of JSON wants.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn read(text: &str) -> Result<Matrix, Wrong> {
        whole_json(text)
    }

    /// The plan of the runs on a corpus, of which these rows are learned from and those judged on.
    ///
    /// # Errors
    /// In words, why it cannot be.
    pub fn plan(
        &self,
        settings: &Settings,
        corpus: &[Example],
        (train, test): (&[u32], &[u32]),
    ) -> Result<Plan, String> {
        settings.config()?;
        if train.is_empty() {
            return Err("There is nothing to learn from.".to_owned());
        }
        if test.is_empty() && !matches!(self, Matrix::Cross { .. }) {
            return Err("Nothing is held out: part the corpus first.".to_owned());
        }
        let (whole, judged) = (spans::write(train), spans::write(test));
        let run = |name: String, settings: Settings| RunSpec {
            name,
            settings,
            planning: None,
            train: whole.clone(),
            test: judged.clone(),
            paper_f1: None,
        };
        let keys = |by: By| -> Vec<String> {
            let all = by.keys(corpus);
            train.iter().filter_map(|&row| all.get(row as usize)).cloned().collect()
        };
        let rows = |places: &[u32]| -> String {
            let rows: Vec<u32> =
                places.iter().filter_map(|&at| train.get(at as usize)).copied().collect();
            spans::write(&rows)
        };
        let mut plan = Plan::new(self.name(), corpus, matches!(self, Matrix::Cross { .. }));
        plan.runs = match self {
            Matrix::Once => vec![run("once".to_owned(), settings.clone())],
            Matrix::Table2 { set } => [3, 2, 1]
                .map(|n| RunSpec {
                    paper_f1: paper::table_2(set, n),
                    ..run(
                        format!("{set}, {n}"),
                        Settings { demonstrations: Some(n), ..settings.clone() },
                    )
                })
                .into(),
            Matrix::Table3 { budget } => {
                let horizons = paper::TABLE_3.iter().filter_map(|row| row.horizon).map(Some);
                let row = |horizon: Option<u32>| RunSpec {
                    planning: horizon.map(|horizon| (horizon, *budget)),
                    paper_f1: paper::table_3(horizon).map(|row| row.f1),
                    ..run(
                        horizon.map_or("no planning".to_owned(), |n| format!("horizon {n}")),
                        settings.clone(),
                    )
                };
                std::iter::once(None).chain(horizons).map(row).collect()
            }
            Matrix::Cross { folds: n, by } => {
                let most = u32::try_from(train.len().min(MOST_RUNS)).unwrap_or(u32::MAX);
                if !(2..=most).contains(n) {
                    return Err(format!("The folds must be between 2 and {most}."));
                }
                let fold = |(number, fold): (usize, crate::corpus::Fold)| RunSpec {
                    train: rows(&fold.train),
                    test: rows(&fold.test),
                    ..run(format!("fold {number}"), settings.clone())
                };
                let all = (1..).zip(folds(&keys(*by), *n, settings.seed)).map(fold);
                // With fewer keys than folds some folds judge nothing.
                all.filter(|run| !run.test.is_empty() && !run.train.is_empty()).collect()
            }
            Matrix::Curve { percents, by } => {
                let keys = keys(*by);
                let part = |&percent: &u32| {
                    let places = match percent {
                        100 => (0..train.len() as u32).collect(),
                        _ => share(&keys, percent, settings.seed).test,
                    };
                    RunSpec {
                        train: rows(&places),
                        ..run(format!("{percent} %"), settings.clone())
                    }
                };
                percents.iter().map(part).filter(|run| !run.train.is_empty()).collect()
            }
            Matrix::Ablation { kinds, demonstrations } => {
                let left_out = std::iter::once(None).chain(kinds.iter().copied().map(Some));
                let demonstrations: Vec<Option<u32>> = match demonstrations.as_slice() {
                    [] => vec![settings.demonstrations],
                    some => some.iter().copied().map(Some).collect(),
                };
                let cell = |kind: Option<Kind>, n: Option<u32>| {
                    let without = settings.without.iter().copied().chain(kind).collect();
                    let name = kind.map_or("all features".to_owned(), |kind| {
                        format!("without {}", kind.name())
                    });
                    let name = n.map_or(name.clone(), |n| format!("{name}, {n} demonstrations"));
                    run(name, Settings { without, demonstrations: n, ..settings.clone() })
                };
                let row = |kind| demonstrations.iter().map(move |&n| (kind, n));
                left_out.flat_map(row).map(|(kind, n)| cell(kind, n)).collect()
            }
            Matrix::Seeds { count } => {
                let seeds = (0..*count).map(|n| settings.seed.wrapping_add(n));
                seeds
                    .map(|seed| run(format!("seed {seed}"), Settings { seed, ..settings.clone() }))
                    .collect()
            }
        };
        if !(1..=MOST_RUNS).contains(&plan.runs.len()) {
            return Err(format!(
                "These are {} runs; a plan has 1 to {MOST_RUNS}.",
                plan.runs.len()
            ));
        }
        for run in &plan.runs {
            run.settings.config()?;
        }
        Ok(plan)
    }

    fn name(&self) -> String {
        match self {
            Matrix::Once => "one run".to_owned(),
            Matrix::Table2 { set } => format!("Table II, {set}"),
            Matrix::Table3 { .. } => "Table III".to_owned(),
            Matrix::Cross { folds, by } => {
                let name = By::ALL.iter().find(|(_, kind)| kind == by).map_or("", |(name, _)| name);
                format!("{folds} folds by {name}")
            }
            Matrix::Curve { .. } => "learning curve".to_owned(),
            Matrix::Ablation { .. } => "ablation".to_owned(),
            Matrix::Seeds { .. } => "seeds".to_owned(),
        }
    }
}
