//! The validation-driven perceptron (Artzi and Zettlemoyer 2013, Algorithm 1): valid readings are to score
//! higher than invalid ones by a margin that grows with how much they differ.

use crate::ccg::{Features, Vector};

/// A reading's features and whether it is valid.
pub struct Judged {
    /// φ of the reading.
    pub features: Vector,
    /// Whether it holds on every demonstration.
    pub valid: bool,
}

/// θ += mean φ over E⁺ − mean φ over E⁻, where E⁺ and E⁻ are the members of pairs of a valid and an invalid
/// reading that violate the margin. Returns whether there were any.
pub fn update(features: &mut Features, judged: &[Judged], margin: f64, moment: f64) -> bool {
    let scores: Vec<f64> = judged.iter().map(|reading| features.dot(&reading.features)).collect();
    let mut violates = vec![false; judged.len()];
    for (v, valid) in judged.iter().enumerate().filter(|(_, reading)| reading.valid) {
        for (w, invalid) in judged.iter().enumerate().filter(|(_, reading)| !reading.valid) {
            let distance = valid.features.l1_distance(&invalid.features);
            if scores[v] - scores[w] < margin * distance {
                violates[v] = true;
                violates[w] = true;
            }
        }
    }
    if !violates.contains(&true) {
        return false;
    }
    for valid in [true, false] {
        let members = || {
            let all = judged.iter().zip(&violates);
            all.filter(move |(reading, violates)| **violates && reading.valid == valid)
        };
        let share = 1.0 / members().count() as f64;
        let by = if valid { share } else { -share };
        members().for_each(|(reading, _)| features.add(&reading.features, by, moment));
    }
    true
}
