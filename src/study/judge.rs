//! What a model makes of answers: whether a command, read by it, is false before and true after every pair that was
//! shown, or of some alone. Told to who reviews, never to who took part. In steps, an answer each.

use super::answer::Answer;
use crate::ccg::{ChartConfig, Model, parse};
use crate::ground::{PairId, Validator};
use serde::{Deserialize, Serialize};

/// What a model makes of an answer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It reads the command, and the reading holds on every pair.
    All,
    /// On some pairs alone; on which.
    Some(Vec<bool>),
    /// On none.
    None,
    /// It cannot read the command.
    Unread,
}

/// Answers that are being judged.
pub struct Judging {
    model: Model,
    validator: Validator,
    answers: Vec<Answer>,
    verdicts: Vec<Verdict>,
}

/// Readings that are tried, the best first: a worse one that holds on all pairs tells that the words are fair.
const READINGS: usize = 50;

impl Judging {
    /// Nothing judged yet.
    pub fn new(model: Model, answers: Vec<Answer>) -> Judging {
        Judging { model, validator: Validator::new(), answers, verdicts: Vec::new() }
    }

    /// How many are judged, and how many there are.
    pub fn progress(&self) -> (usize, usize) {
        (self.verdicts.len(), self.answers.len())
    }

    /// Judges one more; whether there was one.
    pub fn step(&mut self) -> bool {
        let Some(answer) = self.answers.get(self.verdicts.len()) else { return false };
        let verdict = judged(&mut self.model, &mut self.validator, answer);
        self.verdicts.push(verdict);
        true
    }

    /// What was made of each, in order.
    pub fn end(self) -> Vec<Verdict> {
        self.verdicts
    }
}

fn judged(model: &mut Model, validator: &mut Validator, answer: &Answer) -> Verdict {
    let config = ChartConfig::of(model);
    let parse = parse(model, &answer.command, config);
    let pairs: Vec<PairId> = answer
        .pairs
        .iter()
        .map(|showing| {
            let (pre, post) = showing.states();
            validator.pair(pre, post)
        })
        .collect();
    let mut best: Option<Vec<bool>> = None;
    for reading in parse.readings.iter().take(READINGS.max(parse.tied())) {
        let terms = &model.grammar.terms;
        let holds: Vec<bool> =
            pairs.iter().map(|&pair| validator.valid(terms, reading.form, &[pair])).collect();
        let n = |holds: &[bool]| holds.iter().filter(|&&is| is).count();
        if best.as_ref().is_none_or(|best| n(&holds) > n(best)) {
            best = Some(holds);
        }
    }
    match best {
        None => Verdict::Unread,
        Some(holds) if holds.iter().all(|&is| is) => Verdict::All,
        Some(holds) if holds.iter().any(|&is| is) => Verdict::Some(holds),
        Some(_) => Verdict::None,
    }
}

/// All of it at once.
pub fn judge(model: Model, answers: Vec<Answer>) -> Vec<Verdict> {
    let mut judging = Judging::new(model, answers);
    while judging.step() {}
    judging.end()
}
