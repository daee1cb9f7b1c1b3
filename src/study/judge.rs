//! What a model makes of answers: whether a command, read by it, is false before and true after every pair that was
//! shown, or of some alone. Told to who reviews, never to who took part. In steps, an answer each.

use super::answer::Answer;
use crate::ccg::{ChartConfig, Model, parse};
use crate::corpus::Pair;
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
    verdicts: Vec<Verdict>,
}

/// Readings that are tried, the best first: a worse one that holds on all pairs tells that the words are fair.
const READINGS: usize = 50;

impl Judging {
    /// Nothing judged yet.
    pub fn new(model: Model) -> Judging {
        Judging { model, validator: Validator::new(), verdicts: Vec::new() }
    }

    /// How many are judged.
    pub fn progress(&self) -> usize {
        self.verdicts.len()
    }

    /// Judges one more.
    pub fn step(&mut self, answer: &Answer) {
        let verdict = judged(&mut self.model, &mut self.validator, answer);
        self.verdicts.push(verdict);
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
        .shown()
        .map(|showing| {
            let Pair { pre, post, way } = showing.pair();
            validator.shown(pre, post, way.as_deref())
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
