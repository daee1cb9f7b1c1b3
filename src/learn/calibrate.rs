//! Learning how far an answer can be trusted: logistic regression of right and wrong on the signs of a parse (Platt
//! 1999), by gradient descent with a fixed number of steps, so that the same marks give the same map to the last bit.

use super::evaluate::verdict;
use super::score::Verdict;
use crate::ccg::doubt::{Doubt, Signs};
use crate::ccg::{ChartConfig, Model, parse, signs};
use crate::corpus::Example;
use crate::logic::ty::RUN;

/// Steps of the descent; each goes once over all marks.
const STEPS: usize = 1_500;
/// How far a step goes.
const RATE: f64 = 1.0;
/// What a large weight costs.
const DECAY: f64 = 1e-3;

/// Whether an answer with these signs was right.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What the parse showed.
    pub signs: Signs,
    /// Whether the answer did what was shown.
    pub right: bool,
}

/// The marks of a model's answers to examples; those without an answer have none, nor have tasks over time that pairs of
/// states are to show: they tell nothing of those.
pub fn marks(model: &mut Model, examples: &[Example]) -> Vec<Mark> {
    let config = ChartConfig::of(model);
    let mut marks = Vec::new();
    for example in examples {
        let parse = parse(model, &example.command, config);
        let Some(answer) = parse.answer() else { continue };
        let is_of_time = model.grammar.terms.ty(answer.form) == RUN;
        if is_of_time && example.pairs.iter().all(|pair| pair.way.is_none()) {
            continue;
        }
        let right = verdict(&model.grammar.terms, Some(answer.form), example) == Verdict::Right;
        marks.extend(signs(model, &parse).map(|signs| Mark { signs, right }));
    }
    marks
}

/// The map that fits marks of several corpora, each of the same weight, and the threshold from which on answers are right
/// in at least the share `precision`.
pub fn calibrate(corpora: &[Vec<Mark>], precision: f64) -> Doubt {
    let corpora: Vec<&Vec<Mark>> = corpora.iter().filter(|marks| !marks.is_empty()).collect();
    let names = corpora.iter().flat_map(|marks| marks.iter()).flat_map(|mark| &mark.signs);
    let mut doubt = Doubt::default();
    doubt.weights.extend(names.map(|(name, _)| (name.clone(), 0.0)));
    for _ in 0..STEPS {
        let mut slopes: Vec<f64> = doubt.weights.values().map(|weight| -DECAY * weight).collect();
        for marks in &corpora {
            let share = 1.0 / (marks.len() * corpora.len()) as f64;
            for Mark { signs, right } in *marks {
                let error = f64::from(u8::from(*right)) - doubt.probability(signs);
                for (name, value) in signs {
                    if let Some(slope) =
                        doubt.weights.get_index_of(name).and_then(|at| slopes.get_mut(at))
                    {
                        *slope += share * error * value;
                    }
                }
            }
        }
        for (weight, slope) in doubt.weights.values_mut().zip(slopes) {
            *weight += RATE * slope;
        }
    }
    doubt.threshold = threshold(&doubt, &corpora, precision);
    doubt
}

/// The lowest of a hundred thresholds above which every corpus is answered rightly in at least this share.
fn threshold(doubt: &Doubt, corpora: &[&Vec<Mark>], precision: f64) -> f64 {
    let enough = |threshold: f64, marks: &[Mark]| {
        let told: Vec<bool> = marks
            .iter()
            .filter(|mark| doubt.probability(&mark.signs) >= threshold)
            .map(|mark| mark.right)
            .collect();
        let right = told.iter().filter(|&&right| right).count();
        right as f64 >= precision * told.len() as f64
    };
    let all = (0..100).map(|step| f64::from(step) / 100.0);
    let mut fitting = all.filter(|&at| corpora.iter().all(|marks| enough(at, marks)));
    fitting.next().unwrap_or(1.0)
}
