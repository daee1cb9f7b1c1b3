//! The update of the weights after an example: a step along the gradient of the softmax-margin likelihood (Gimpel and
//! Smith 2010) of the valid readings together, as validation leaves open which of them was meant (Artzi and
//! Zettlemoyer 2013). An invalid reading counts the more, the higher it scores; their perceptron, whose update is
//! the mean over all readings that violate a margin, stayed behind on tasks never seen (www/guide/learning.md).

use crate::ccg::{Feature, Features, Vector};
use crate::logic::TermId;
use std::rc::Rc;

/// How far a step goes.
const RATE: f64 = 0.3;
/// What is less probable moves nothing.
const LEAST: f64 = 1e-4;

/// θ += rate · (mean φ of the valid readings − mean φ of all), each weighted by exp(θ·φ), invalid ones with `margin`
/// added to their score. Only weights that `moves` lets move do. Returns how far each reading was followed; nothing
/// where there was nothing to tell apart. A reading is a goal with its φ; which of them are valid stands in the same
/// order.
pub fn update(
    features: &mut Features,
    readings: &[(TermId, Rc<Vector>)],
    valid: &[bool],
    (margin, moment): (f64, f64),
    moves: impl Fn(Feature) -> bool,
) -> Option<Vec<f64>> {
    let score = |((_, vector), &valid): (&(TermId, Rc<Vector>), &bool)| {
        features.dot(vector) + if valid { 0.0 } else { margin }
    };
    let scores: Vec<f64> = readings.iter().zip(valid).map(score).collect();
    if !valid.contains(&false) {
        return None;
    }
    let shares_of_valid = softmax(&scores, |at| valid[at])?;
    let mut steps = softmax(&scores, |_| true)?;
    for (((_, vector), step), share_of_valid) in
        readings.iter().zip(&mut steps).zip(shares_of_valid)
    {
        let by = RATE * (share_of_valid - *step);
        *step = if by.abs() > LEAST { by } else { 0.0 };
        if *step != 0.0 {
            features.add_where(vector, by, moment, &moves);
        }
    }
    Some(steps)
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
