//! What a model makes of every row of a corpus, command by command in bounded steps, and where it errs: which commands
//! fail most, which words it does not know, which features decided for a wrong reading, what each entry was used for.

use super::sheet::Outcome;
use crate::ccg::{ChartConfig, Derivation, EntryId, Explanation, Hearing, Model, Parse, words};
use crate::corpus::Example;
use crate::ground::{PairId, Validator};
use crate::logic::print;
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Rows that a step judges at most.
const ROWS_A_STEP: usize = 50;

/// Rows that are named for a command, a word or an entry.
const MOST_ROWS: usize = 10;

/// Lines of each table of errors.
const MOST_LINES: usize = 200;

/// Readings that are held against each other for what decided between them.
const MOST_COMPARED: usize = 5_000;

/// A model that is asked every command of some rows.
pub struct Audit {
    model: Model,
    examples: Arc<[Example]>,
    /// Distinct commands, each with its rows.
    commands: Vec<(Vec<String>, Vec<u32>)>,
    next: usize,
    now: Option<Asked>,
    done: usize,
    tallies: Vec<CommandErrors>,
    unknown: IndexMap<String, Rows, FxBuildHasher>,
    deciders: IndexMap<String, Decider, FxBuildHasher>,
    compared: usize,
    uses: IndexMap<EntryId, Rows, FxBuildHasher>,
}

/// A command that was parsed, and whose rows are judged.
struct Asked {
    parse: Parse,
    validator: Validator,
    form: Option<String>,
    next: usize,
    right: u32,
}

/// What the model makes of a row, and its best form.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The row.
    pub row: u32,
    /// What the model makes of it.
    pub outcome: Outcome,
    /// The best form, if there is a reading.
    pub form: Option<String>,
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
    /// A model that is to be asked the commands of these rows of a corpus.
    pub fn new(model: Model, examples: Arc<[Example]>) -> Audit {
        let mut commands: IndexMap<Vec<String>, Vec<u32>, FxBuildHasher> = IndexMap::default();
        for (row, example) in (0..).zip(examples.iter()) {
            commands.entry(words(&example.command)).or_default().push(row);
        }
        Audit {
            model,
            examples,
            commands: commands.into_iter().collect(),
            next: 0,
            now: None,
            done: 0,
            tallies: Vec::new(),
            unknown: IndexMap::default(),
            deciders: IndexMap::default(),
            compared: 0,
            uses: IndexMap::default(),
        }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The model, to be asked.
    pub fn model_mut(&mut self) -> &mut Model {
        &mut self.model
    }

    /// Rows that are judged, and rows in all.
    pub fn progress(&self) -> (usize, usize) {
        (self.done, self.examples.len())
    }

    /// Whether all rows are judged.
    pub fn is_over(&self) -> bool {
        self.next == self.commands.len()
    }

    /// Parses the next command, or judges some rows of the one at work.
    pub fn step(&mut self) -> Vec<Judged> {
        let Some((words, rows)) = self.commands.get(self.next) else { return Vec::new() };
        let Some(mut asked) = self.now.take() else {
            let config = ChartConfig::of(&self.model);
            let parse = crate::ccg::parse_words(&mut self.model, words.clone(), config);
            let terms = &self.model.grammar.terms;
            let form = parse.readings.first().map(|reading| print(terms, reading.form));
            let validator = Validator::new();
            self.now = Some(Asked { parse, validator, form, next: 0, right: 0 });
            return Vec::new();
        };
        let some: Vec<u32> = rows.iter().skip(asked.next).take(ROWS_A_STEP).copied().collect();
        let mut judged = Vec::with_capacity(some.len());
        for row in some {
            let outcome = self.judge(row, &mut asked);
            judged.push(Judged { row, outcome, form: asked.form.clone() });
        }
        self.done += judged.len();
        if asked.next < self.commands[self.next].1.len() {
            self.now = Some(asked);
        } else {
            self.end_command(asked);
        }
        judged
    }

    fn judge(&mut self, row: u32, asked: &mut Asked) -> Outcome {
        asked.next += 1;
        let Asked { parse, validator, .. } = asked;
        let Some(example) = self.examples.get(row as usize) else { return Outcome::Unread };
        let pairs: Vec<PairId> = example
            .pairs
            .iter()
            .map(|pair| validator.shown(&pair.pre, &pair.post, pair.way.as_deref()))
            .collect();
        let terms = &self.model.grammar.terms;
        let valid =
            parse.readings.iter().position(|reading| validator.valid(terms, reading.form, &pairs));
        let outcome = match valid {
            _ if parse.readings.is_empty() => Outcome::Unread,
            None => Outcome::Invalid,
            Some(0) if parse.answer().is_some() => Outcome::Right,
            Some(at) if at < parse.tied() => Outcome::Tied,
            Some(_) => Outcome::Lower,
        };
        asked.right += u32::from(outcome == Outcome::Right);
        if let (Outcome::Lower, Some(at)) = (outcome, valid)
            && self.compared < MOST_COMPARED
        {
            self.compared += 1;
            self.compare(row, &asked.parse, at);
        }
        outcome
    }

    /// Which features set the best reading above one that is valid.
    fn compare(&mut self, row: u32, parse: &Parse, valid: usize) {
        let explain = |at: usize| {
            let reading = parse.readings.get(at)?;
            Some(Explanation::of(&self.model, parse, *reading).parts)
        };
        let (Some(best), Some(valid)) = (explain(0), explain(valid)) else { return };
        let mut by: IndexMap<String, f64, FxBuildHasher> = IndexMap::default();
        for part in best {
            *by.entry(part.feature).or_default() += part.adds;
        }
        for part in valid {
            *by.entry(part.feature).or_default() -= part.adds;
        }
        for (feature, by) in by.into_iter().filter(|(_, by)| *by > 1e-9) {
            let decider = self.deciders.entry(feature).or_insert_with_key(|feature| Decider {
                feature: feature.clone(),
                by: 0.0,
                rows: Rows::default(),
            });
            decider.by += by;
            decider.rows.add(row);
        }
    }

    /// Counts what the command shows, once all its rows are judged.
    fn end_command(&mut self, asked: Asked) {
        let Asked { parse, form, right, .. } = asked;
        let (words, rows) = &self.commands[self.next];
        self.next += 1;
        let mut tally = Rows::default();
        rows.iter().for_each(|&row| tally.add(row));
        let heard = Hearing::new(&self.model, words);
        let knows = |word: &str| self.model.lexicon.knows(word);
        for (word, closed) in heard.words.iter().zip(&heard.closed) {
            if closed.is_none() && !knows(word) {
                let known = self.unknown.entry(word.clone()).or_default();
                rows.iter().for_each(|&row| known.add(row));
            }
        }
        if let Some(&best) = parse.readings.first() {
            let derivation = parse.derivation(best);
            let leaves = derivation.leaves();
            for entry in leaves.into_iter().filter_map(Derivation::entry) {
                let used = self.uses.entry(entry).or_default();
                rows.iter().for_each(|&row| used.add(row));
            }
        }
        let command = words.join(" ");
        self.tallies.push(CommandErrors { command, rows: tally, right, form });
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
