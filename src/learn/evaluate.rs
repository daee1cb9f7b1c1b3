//! Scoring a model on commands with demonstrations: one best form is an answer, tied best forms abstain, no parse
//! is no answer; then the same with the parse that skips words counted (Williams et al., Section VI).

use crate::ccg::chart::ChartConfig;
use crate::ccg::{Model, parse};
use crate::corpus::Example;
use crate::ground::{PairId, Validator};

/// How often a model answered and was right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// Commands that got an answer.
    pub answered: usize,
    /// Answers that hold on all demonstrations.
    pub correct: usize,
}

impl Score {
    /// correct / answered; 0 when nothing was answered.
    pub fn precision(self) -> f64 {
        ratio(self.correct, self.answered)
    }

    /// correct / `total`; 0 when there is nothing.
    pub fn recall(self, total: usize) -> f64 {
        ratio(self.correct, total)
    }

    /// The harmonic mean of precision and recall.
    pub fn f1(self, total: usize) -> f64 {
        let (p, r) = (self.precision(), self.recall(total));
        if p + r == 0.0 { 0.0 } else { 2.0 * p * r / (p + r) }
    }
}

/// What an evaluation has found so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scores {
    /// Commands seen.
    pub total: usize,
    /// Without skipping words.
    pub plain: Score,
    /// With the skipping parse counted.
    pub skipping: Score,
}

/// An evaluation, command by command.
pub struct Evaluation<'a> {
    model: &'a mut Model,
    examples: &'a [Example],
    config: ChartConfig,
    scores: Scores,
}

impl<'a> Evaluation<'a> {
    /// An evaluation of a model on examples.
    pub fn new(model: &'a mut Model, examples: &'a [Example], config: ChartConfig) -> Self {
        Evaluation { model, examples, config, scores: Scores::default() }
    }

    /// Scores the next command; `None` when all are done.
    pub fn step(&mut self) -> Option<Scores> {
        let example = self.examples.get(self.scores.total)?;
        self.scores.total += 1;
        let parse = parse(self.model, &example.command, self.config);
        if let Some(answer) = parse.answer() {
            let mut validator = Validator::new();
            let pairs: Vec<PairId> =
                example.pairs.iter().map(|pair| validator.pair(&pair.pre, &pair.post)).collect();
            let correct = validator.valid(&self.model.grammar.terms, answer.form, &pairs);
            let count = |score: &mut Score| {
                score.answered += 1;
                score.correct += usize::from(correct);
            };
            if parse.skipped.is_empty() {
                count(&mut self.scores.plain);
            }
            count(&mut self.scores.skipping);
        }
        Some(self.scores)
    }

    /// What was found so far.
    pub fn scores(&self) -> Scores {
        self.scores
    }
}

fn ratio(part: usize, whole: usize) -> f64 {
    if whole == 0 { 0.0 } else { part as f64 / whole as f64 }
}
