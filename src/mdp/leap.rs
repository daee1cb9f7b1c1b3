//! Ways on from a state: a walk of actions that each come off sooner or later, then one more with all that may come of
//! it. Who plans in leaps keeps the states at their ends and none between.

use std::ops::Range;

/// A walk and what it ends in.
#[derive(Clone, Debug, PartialEq)]
pub struct Leap<A> {
    /// The first of its actions.
    pub first: A,
    /// How many actions it takes when all goes well, at least 1.
    pub cost: u32,
    /// The chance of each action but the last to change nothing; then it is tried again.
    pub slip: f64,
    /// The same of the last action.
    pub stay: f64,
    /// Its outcomes among those of all leaps; probabilities that sum to what staying leaves.
    pub ends: Range<usize>,
}

impl<A> Leap<A> {
    /// What each outcome is worth less for the actions before it, and more for those that are tried again: γ for a step
    /// that surely comes off, (γ − γ s) / (1 − γ s) for one that slips with probability s.
    #[must_use]
    pub fn scale(&self, discount: f64) -> f64 {
        let step = discount * (1.0 - self.slip) / (1.0 - discount * self.slip);
        power(step, self.cost.saturating_sub(1)) / (1.0 - discount * self.stay)
    }

    /// Whether nothing is left to chance.
    #[must_use]
    pub fn is_sure(&self) -> bool {
        self.ends.len() == 1 && self.stay == 0.0 && (self.slip == 0.0 || self.cost == 1)
    }
}

/// Leaps with their outcomes, kept to be used again.
#[derive(Clone, Debug)]
pub struct Leaps<S, A> {
    all: Vec<Leap<A>>,
    /// The outcomes of all; those from the last leap's on belong to the next.
    pub ends: Vec<(S, f64)>,
}

impl<S, A> Default for Leaps<S, A> {
    fn default() -> Self {
        Self { all: Vec::new(), ends: Vec::new() }
    }
}

impl<S: Copy + Eq, A> Leaps<S, A> {
    /// Forgets all.
    pub fn clear(&mut self) {
        self.all.clear();
        self.ends.clear();
    }

    /// Makes a leap of the outcomes that were added since the last one; those that are `here`, where the last action is
    /// taken, are tried again. No leap if that never leads elsewhere.
    pub fn close(&mut self, first: A, cost: u32, slip: f64, here: S) {
        let begin = self.all.last().map_or(0, |leap| leap.ends.end);
        let mut stay = 0.0;
        let mut kept = begin;
        for at in begin..self.ends.len() {
            if self.ends[at].0 == here {
                stay += self.ends[at].1;
            } else {
                self.ends[kept] = self.ends[at];
                kept += 1;
            }
        }
        self.ends.truncate(kept);
        if kept > begin {
            self.all.push(Leap { first, cost, slip, stay, ends: begin..kept });
        }
    }

    /// The leaps, each with its outcomes.
    pub fn iter(&self) -> impl Iterator<Item = (&Leap<A>, &[(S, f64)])> {
        self.all.iter().map(|leap| (leap, &self.ends[leap.ends.clone()]))
    }
}

/// `base` to the power of `n` by squaring: the same on every machine.
#[must_use]
pub fn power(base: f64, n: u32) -> f64 {
    let (mut result, mut square, mut left) = (1.0, base, n);
    while left > 0 {
        if left & 1 == 1 {
            result *= square;
        }
        square *= square;
        left >>= 1;
    }
    result
}
