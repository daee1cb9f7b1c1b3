//! What an evaluation found, command by command, and the figures that follow: scores, 95 % bootstrap intervals
//! (Efron 1979, the percentile method), scores by task, confusion between tasks.

use super::confusion::Confusion;
use super::score::{Mark, Scores, Ties};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::collections::BTreeMap;

/// How often the commands are drawn anew.
pub const RESAMPLES: usize = 1_000;
/// The seed of the draws: intervals are a function of the marks alone.
const SEED: u64 = 95;
/// The resamples at both ends that a 95 % interval leaves out.
const LEFT_OUT: usize = RESAMPLES / 40;

/// What an evaluation found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// How each command was answered, in order.
    pub marks: Vec<Mark>,
    /// What the wrong answers did instead.
    pub confusion: Confusion,
}

impl Report {
    /// The scores of all commands.
    pub fn scores(&self, ties: Ties) -> Scores {
        Scores::of(&self.marks, ties)
    }

    /// The scores of every task, in the order of names; those without a label come first.
    pub fn tasks(&self, ties: Ties) -> BTreeMap<Option<&str>, Scores> {
        let mut tasks: BTreeMap<Option<&str>, Scores> = BTreeMap::new();
        for mark in &self.marks {
            tasks.entry(mark.task.as_deref()).or_default().count(mark, ties);
        }
        tasks
    }

    /// 95 % intervals of the figures of [`Scores::figures`], lower and upper end: commands are drawn with
    /// replacement, and 2.5 % of the resamples lie beyond either end.
    pub fn intervals(&self, ties: Ties) -> [(f64, f64); 6] {
        let mut random = Pcg32::seed_from_u64(SEED);
        let n = self.marks.len() as u32;
        let mut resamples: [Vec<f64>; 6] = Default::default();
        for _ in 0..RESAMPLES {
            let draws = (0..n).map(|_| random.random_range(0..n) as usize);
            let scores = Scores::of(draws.filter_map(|at| self.marks.get(at)), ties);
            for (values, figure) in resamples.iter_mut().zip(scores.figures()) {
                values.push(figure);
            }
        }
        resamples.map(|mut values| {
            values.sort_by(f64::total_cmp);
            let at = |index: usize| values.get(index).copied().unwrap_or_default();
            (at(LEFT_OUT), at(RESAMPLES - 1 - LEFT_OUT))
        })
    }

    /// Takes in what was found on other commands.
    pub fn add(&mut self, other: Report) {
        self.marks.extend(other.marks);
        self.confusion.add(other.confusion);
    }
}
