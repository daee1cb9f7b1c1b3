//! A model that is asked the commands of a corpus one by one, in bounded steps: what it makes of each, and of its rows.
//! Several engines can share the commands out; what they find is the same, whoever asks.

use super::sheet::Outcome;
use crate::ccg::{ChartConfig, Derivation, EntryId, Explanation, Hearing, Model, Parse, words};
use crate::corpus::Example;
use crate::ground::{PairId, Validator};
use crate::logic::print;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Rows that a step judges at most.
const ROWS_A_STEP: usize = 50;

/// Readings that are held against each other for what decided between them.
pub(super) const MOST_COMPARED: usize = 5_000;

/// A model that is asked.
pub struct Asking {
    model: Model,
    examples: Arc<[Example]>,
    /// Distinct commands, each with its rows.
    commands: Vec<(Vec<String>, Vec<u32>)>,
    /// The places of those that are still to be asked, the last one first.
    waiting: Vec<u32>,
    now: Option<Asked>,
    compared: usize,
    /// The entries of its lexicon, by their places in it.
    places: FxHashMap<EntryId, u32>,
}

/// A command that was parsed, and whose rows are judged.
struct Asked {
    at: u32,
    parse: Parse,
    validator: Validator,
    next: usize,
    answer: Answered,
}

/// What the model makes of a command.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Answered {
    /// The command, by its place among the distinct ones.
    pub command: u32,
    /// The best form, if there is a reading.
    pub form: Option<String>,
    /// Its rows, with what the answer does in each.
    pub rows: Vec<(u32, Outcome)>,
    /// Words that the lexicon does not know.
    pub unknown: Vec<String>,
    /// The entries that the best reading uses, by their places in the lexicon.
    pub uses: Vec<u32>,
    /// For rows with a valid reading below the best, the features that set the best one above it, and by how much.
    pub decided: Vec<(u32, Vec<(String, f64)>)>,
}

impl Asking {
    /// A model that is to be asked all commands of these rows.
    pub fn new(model: Model, examples: Arc<[Example]>) -> Asking {
        let mut commands: IndexMap<Vec<String>, Vec<u32>, FxBuildHasher> = IndexMap::default();
        for (row, example) in (0..).zip(examples.iter()) {
            commands.entry(words(&example.command)).or_default().push(row);
        }
        let places = model.lexicon.entries().iter().copied().zip(0..).collect();
        let waiting = (0..commands.len() as u32).rev().collect();
        let commands = commands.into_iter().collect();
        Asking { model, examples, commands, waiting, now: None, compared: 0, places }
    }

    /// Of the commands that are to be asked those that are wanted, by their places.
    pub fn retain(&mut self, is_wanted: impl Fn(u32) -> bool) {
        self.waiting.retain(|&at| is_wanted(at));
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The model, to be asked something else.
    pub fn model_mut(&mut self) -> &mut Model {
        &mut self.model
    }

    /// The words of a command.
    pub fn command(&self, at: u32) -> &[String] {
        self.commands.get(at as usize).map_or(&[], |(words, _)| words)
    }

    /// The number of commands.
    pub fn n_commands(&self) -> usize {
        self.commands.len()
    }

    /// Rows of the commands that wait to be asked.
    pub fn n_rows(&self) -> usize {
        let rows = |at: &u32| self.commands.get(*at as usize).map_or(0, |(_, rows)| rows.len());
        self.waiting.iter().map(rows).sum()
    }

    /// Whether all commands that are wanted were asked.
    pub fn is_over(&self) -> bool {
        self.waiting.is_empty() && self.now.is_none()
    }

    /// Parses the next command, or judges some rows of the one at work; what came of it once they all are.
    pub fn step(&mut self) -> Option<Answered> {
        let Some(mut asked) = self.now.take() else {
            self.now = self.waiting.pop().map(|at| self.ask(at));
            return None;
        };
        let rows = self.commands.get(asked.at as usize).map_or(&[][..], |(_, rows)| rows);
        let some: Vec<u32> = rows.iter().skip(asked.next).take(ROWS_A_STEP).copied().collect();
        asked.next += some.len();
        let is_done = asked.next == rows.len();
        for row in some {
            let outcome = self.judge(row, &mut asked);
            asked.answer.rows.push((row, outcome));
        }
        if is_done {
            return Some(asked.answer);
        }
        self.now = Some(asked);
        None
    }

    fn ask(&mut self, at: u32) -> Asked {
        let words = self.command(at).to_vec();
        let config = ChartConfig::of(&self.model);
        let parse = crate::ccg::parse_words(&mut self.model, words.clone(), config);
        let terms = &self.model.grammar.terms;
        let form = parse.readings.first().map(|reading| print(terms, reading.form));
        let heard = Hearing::new(&self.model, &words);
        let is_unknown = |(word, closed): &(&String, &Option<_>)| {
            closed.is_none() && !self.model.lexicon.knows(word)
        };
        let unknown = heard.words.iter().zip(&heard.closed).filter(is_unknown);
        let unknown = unknown.map(|(word, _)| word.clone()).collect();
        let best = parse.readings.first().map(|&best| parse.derivation(best));
        let leaves = best.iter().flat_map(Derivation::leaves).filter_map(Derivation::entry);
        let uses = leaves.filter_map(|entry| self.places.get(&entry).copied()).collect();
        let (rows, decided) = (Vec::new(), Vec::new());
        let answer = Answered { command: at, form, rows, unknown, uses, decided };
        Asked { at, parse, validator: Validator::new(), next: 0, answer }
    }

    fn judge(&mut self, row: u32, asked: &mut Asked) -> Outcome {
        let Asked { parse, validator, answer, .. } = asked;
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
        if let (Outcome::Lower, Some(at)) = (outcome, valid)
            && self.compared < MOST_COMPARED
        {
            self.compared += 1;
            answer.decided.push((row, self.compare(parse, at)));
        }
        outcome
    }

    /// Which features set the best reading above one that is valid, and by how much.
    fn compare(&self, parse: &Parse, valid: usize) -> Vec<(String, f64)> {
        let explain = |at: usize| {
            let reading = parse.readings.get(at)?;
            Some(Explanation::of(&self.model, parse, *reading).parts)
        };
        let (Some(best), Some(valid)) = (explain(0), explain(valid)) else { return Vec::new() };
        let mut by: IndexMap<String, f64, FxBuildHasher> = IndexMap::default();
        for part in best {
            *by.entry(part.feature).or_default() += part.adds;
        }
        for part in valid {
            *by.entry(part.feature).or_default() -= part.adds;
        }
        by.into_iter().filter(|(_, by)| *by > 1e-9).collect()
    }
}
