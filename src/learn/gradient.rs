//! The update of the weights after an example: a step along the gradient of the softmax-margin likelihood (Gimpel and
//! Smith 2010) of the valid readings together, as validation leaves open which of them was meant (Artzi and
//! Zettlemoyer 2013). An invalid reading counts the more, the higher it scores; METHOD's perceptron, whose update
//! is the mean over all that violate the margin, stayed behind by six points on tasks never seen.

use crate::ccg::{Features, Vector};

/// How far a step goes.
const RATE: f64 = 0.3;
/// What is less probable moves nothing.
const LEAST: f64 = 1e-4;

/// A reading's features and whether it is valid.
pub struct Judged {
    /// φ of the reading.
    pub features: Vector,
    /// Whether it holds on every demonstration.
    pub valid: bool,
}

/// θ += rate · (mean φ of the valid readings − mean φ of all), each weighted by exp(θ·φ), invalid ones with `margin`
/// added to their score. Returns whether there was something to tell apart.
pub fn update(features: &mut Features, judged: &[Judged], margin: f64, moment: f64) -> bool {
    let scores: Vec<f64> = judged
        .iter()
        .map(|reading| features.dot(&reading.features) + if reading.valid { 0.0 } else { margin })
        .collect();
    let all = softmax(&scores, |_| true);
    let valid = softmax(&scores, |at| judged[at].valid);
    let (Some(all), Some(valid)) = (all, valid) else { return false };
    if judged.iter().all(|reading| reading.valid) {
        return false;
    }
    for ((reading, all), valid) in judged.iter().zip(all).zip(valid) {
        let by = RATE * (valid - all);
        if by.abs() > LEAST {
            features.add(&reading.features, by, moment);
        }
    }
    true
}

/// exp(score) over its sum, among the members; 0 for others. `None` without members.
fn softmax(scores: &[f64], is_member: impl Fn(usize) -> bool) -> Option<Vec<f64>> {
    let members = || scores.iter().enumerate().filter(|(at, _)| is_member(*at));
    let best = members().map(|(_, &score)| score).reduce(f64::max)?;
    let mut shares = vec![0.0; scores.len()];
    members().for_each(|(at, score)| shares[at] = libm::exp(score - best));
    let sum = shares.iter().fold(0.0, |sum, share| sum + share);
    shares.iter_mut().for_each(|share| *share /= sum);
    Some(shares)
}
