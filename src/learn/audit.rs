//! What a model makes of every row of a corpus, and where it errs: which commands fail most, which words it does not know,
//! which features decided for a wrong reading, what each entry was used for.

use super::asking::{Answered, Asking, MOST_COMPARED};
use super::sheet::Outcome;
use crate::ccg::{EntryId, Model};
use crate::corpus::Example;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Rows that are named for a command, a word or an entry.
const MOST_ROWS: usize = 10;

/// Lines of each table of errors.
const MOST_LINES: usize = 200;

/// A model that is asked every command of some rows.
pub struct Audit {
    asking: Asking,
    /// What others have found of commands, the last one first.
    known: Vec<Answered>,
    /// Rows that are judged, and rows in all.
    progress: (usize, usize),
    tallies: Vec<CommandErrors>,
    unknown: IndexMap<String, Rows, FxBuildHasher>,
    deciders: IndexMap<String, Decider, FxBuildHasher>,
    compared: usize,
    uses: FxHashMap<EntryId, Rows>,
}

/// Rows, of which the first few are named.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rows {
    /// How many there are.
    pub count: u32,
    /// The first of them.
    pub first: Vec<u32>,
}

impl Rows {
    pub(super) fn add(&mut self, row: u32) {
        self.count += 1;
        if self.first.len() < MOST_ROWS {
            self.first.push(row);
        }
    }
}

/// How the rows of one command were answered.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CommandErrors {
    /// The command's words.
    pub command: String,
    /// Its rows.
    pub rows: Rows,
    /// Those that are answered rightly.
    pub right: u32,
    /// The best form, if there is a reading.
    pub form: Option<String>,
}

/// A feature that spoke for a wrong reading and against a right one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Decider {
    /// The feature, as a model file names it.
    pub feature: String,
    /// By how much it set the wrong readings above the right ones, in all.
    pub by: f64,
    /// The rows.
    pub rows: Rows,
}

/// Where a model errs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// Commands with rows that are not answered rightly, those with most of them first.
    pub commands: Vec<CommandErrors>,
    /// Words that the lexicon does not know, those of most rows first.
    pub unknown: Vec<(String, Rows)>,
    /// Features that decided wrongly, the strongest first.
    pub deciders: Vec<Decider>,
}

impl Audit {
    /// A model that is to be asked the commands of these rows of a corpus, but for those of which it is known what it makes
    /// of them: in the order of the commands it is all the same who asked.
    pub fn new(model: Model, examples: Arc<[Example]>, mut known: Vec<Answered>) -> Audit {
        let n_rows = examples.len();
        let mut asking = Asking::new(model, examples);
        known.retain(|answered| (answered.command as usize) < asking.n_commands());
        known.sort_by_key(|answered| std::cmp::Reverse(answered.command));
        known.dedup_by_key(|answered| answered.command);
        asking.retain(|at| known.binary_search_by(|one| at.cmp(&one.command)).is_err());
        Audit {
            asking,
            known,
            progress: (0, n_rows),
            tallies: Vec::new(),
            unknown: IndexMap::default(),
            deciders: IndexMap::default(),
            compared: 0,
            uses: FxHashMap::default(),
        }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        self.asking.model()
    }

    /// The model, to be asked.
    pub fn model_mut(&mut self) -> &mut Model {
        self.asking.model_mut()
    }

    /// Rows that are judged, and rows in all.
    pub fn progress(&self) -> (usize, usize) {
        self.progress
    }

    /// Whether all rows are judged.
    pub fn is_over(&self) -> bool {
        self.known.is_empty() && self.asking.is_over()
    }

    /// Asks on in bounded steps; what came of a command, once that is known.
    pub fn step(&mut self) -> Option<Answered> {
        let next = self.tallies.len() as u32;
        let known = self.known.pop_if(|answered| answered.command == next);
        let answered = known.or_else(|| self.asking.step())?;
        self.count(&answered);
        Some(answered)
    }

    /// Counts what a command shows.
    fn count(&mut self, answered: &Answered) {
        let Answered { command, form, rows, unknown, uses, decided } = answered;
        self.progress.0 += rows.len();
        let add_all = |known: &mut Rows| rows.iter().for_each(|(row, _)| known.add(*row));
        for word in unknown {
            add_all(self.unknown.entry(word.clone()).or_default());
        }
        for place in uses {
            let entry = self.asking.model().lexicon.entries().get(*place as usize);
            entry.into_iter().for_each(|entry| add_all(self.uses.entry(*entry).or_default()));
        }
        for (row, by) in decided.iter().take(MOST_COMPARED - self.compared) {
            self.compared += 1;
            for (feature, by) in by {
                let decider = self.deciders.entry(feature.clone()).or_insert_with_key(|feature| {
                    Decider { feature: feature.clone(), by: 0.0, rows: Rows::default() }
                });
                decider.by += by;
                decider.rows.add(*row);
            }
        }
        let right = rows.iter().filter(|(_, outcome)| *outcome == Outcome::Right).count() as u32;
        let mut tally = Rows::default();
        add_all(&mut tally);
        let command = self.asking.command(*command).join(" ");
        self.tallies.push(CommandErrors { command, rows: tally, right, form: form.clone() });
    }

    /// The rows whose best reading uses an entry.
    pub fn uses(&self, entry: EntryId) -> Rows {
        self.uses.get(&entry).cloned().unwrap_or_default()
    }

    /// Where the model errs, as far as the rows are judged.
    pub fn errors(&self) -> Errors {
        let wrong = |tally: &CommandErrors| tally.rows.count - tally.right;
        let mut commands: Vec<CommandErrors> =
            self.tallies.iter().filter(|tally| wrong(tally) > 0).cloned().collect();
        commands.sort_by(|a, b| wrong(b).cmp(&wrong(a)).then_with(|| a.command.cmp(&b.command)));
        commands.truncate(MOST_LINES);
        let mut unknown: Vec<(String, Rows)> =
            self.unknown.iter().map(|(word, rows)| (word.clone(), rows.clone())).collect();
        unknown.sort_by(|a, b| b.1.count.cmp(&a.1.count).then_with(|| a.0.cmp(&b.0)));
        unknown.truncate(MOST_LINES);
        let mut deciders: Vec<Decider> = self.deciders.values().cloned().collect();
        deciders.sort_by(|a, b| b.by.total_cmp(&a.by).then_with(|| a.feature.cmp(&b.feature)));
        deciders.truncate(MOST_LINES);
        Errors { commands, unknown, deciders }
    }
}
