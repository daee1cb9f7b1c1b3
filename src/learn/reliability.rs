//! Whether answers are as likely right as they say: what is asked, expected calibration error (Guo et al. 2017, ten bins),
//! and risk against coverage (El-Yaniv and Wiener 2010). All of the pass that skips words, over answers that say how
//! likely they are.

use super::score::{Mark, Verdict};

/// Bins of the calibration error, of equal width.
pub const BINS: usize = 10;
/// Thresholds of [`Reliability::risk_coverage`], evenly from 0.
const THRESHOLDS: usize = 20;

/// What answers above a threshold come to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The least probability of an answer that is given.
    pub threshold: f64,
    /// The share of all commands that are then answered.
    pub coverage: f64,
    /// The share of these answers that is wrong; 0 when there is none.
    pub risk: f64,
}

/// A bin of answers by their probability.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bin {
    /// Answers in it.
    pub answers: usize,
    /// Their mean probability.
    pub said: f64,
    /// The share of them that is right.
    pub right: f64,
}

/// How far answers can be trusted.
#[derive(Clone, Debug, PartialEq)]
pub struct Reliability {
    /// Answers that a page would ask about first.
    pub asked: usize,
    /// The share of the others that is right; 0 when there is none.
    pub unasked_precision: f64,
    /// The mean distance between what answers say and what they are, by bin; 0 when none says anything.
    pub ece: f64,
    /// The bins.
    pub bins: [Bin; BINS],
    /// Risk and coverage from all answers to few.
    pub risk_coverage: Vec<Cut>,
}

impl Reliability {
    /// What marks say.
    pub fn of(marks: &[Mark]) -> Self {
        let answers = || marks.iter().filter(|mark| mark.answer != Verdict::Silent);
        let is_right = |mark: &&Mark| mark.answer == Verdict::Right;
        let told: Vec<(f64, bool)> =
            answers().filter_map(|mark| Some((mark.probability?, is_right(&mark)))).collect();
        let unasked = || answers().filter(|mark| !mark.asked);
        let mut bins = [Bin::default(); BINS];
        for &(probability, right) in &told {
            let place = (probability * BINS as f64) as usize;
            if let Some(bin) = bins.get_mut(place.min(BINS - 1)) {
                bin.answers += 1;
                bin.said += probability;
                bin.right += f64::from(u8::from(right));
            }
        }
        let mut ece = 0.0;
        for bin in bins.iter_mut().filter(|bin| bin.answers > 0) {
            (bin.said, bin.right) = (bin.said / bin.answers as f64, bin.right / bin.answers as f64);
            ece += (bin.said - bin.right).abs() * ratio(bin.answers, told.len());
        }
        let cut = |step: usize| {
            let threshold = step as f64 / THRESHOLDS as f64;
            let kept: Vec<bool> =
                told.iter().filter(|(p, _)| *p >= threshold).map(|&(_, right)| right).collect();
            let wrong = kept.iter().filter(|&&right| !right).count();
            let (coverage, risk) = (ratio(kept.len(), marks.len()), ratio(wrong, kept.len()));
            Cut { threshold, coverage, risk }
        };
        Reliability {
            asked: answers().filter(|mark| mark.asked).count(),
            unasked_precision: ratio(unasked().filter(is_right).count(), unasked().count()),
            ece,
            bins,
            risk_coverage: (0..THRESHOLDS).map(cut).collect(),
        }
    }
}

fn ratio(part: usize, whole: usize) -> f64 {
    if whole == 0 { 0.0 } else { part as f64 / whole as f64 }
}
