//! What may go wrong: the distribution of an action's outcomes. Draws in this order, each of them only where it
//! can matter: slip (nothing changes), lock (a door that nobody tried, first the one that the robot enters, then
//! the one that its object enters: it is locked from now on, the robot has turned, nothing moves; or else it is
//! open from now on), loss (the object stays, and the robot with it). Units: probabilities.

use super::dynamics::{Dynamics, SMALL};
use super::object::Lock;
use super::packing::Packed;
use super::rules::Action;

impl Dynamics {
    /// Appends what `action` may lead to, each state once, with a probability above 0; they sum to one.
    /// Nothing is allocated once `out` has grown to its size.
    pub fn outcomes(&self, packed: Packed, action: Action, out: &mut Vec<(Packed, f64)>) {
        let from = out.len();
        let chances = self.rules().chances;
        let attempt = self.attempt(packed, action);
        let mut still = attempt.still;
        add(out, from, packed, chances.slip());
        let mut left = 1.0 - chances.slip();
        for place in attempt.entered {
            if let Some(shift) = self.untried(still, place) {
                let locked = still.with(shift, SMALL, Lock::Locked as u64);
                add(out, from, locked, left * chances.lock());
                still = still.with(shift, SMALL, Lock::Unlocked as u64);
                left *= 1.0 - chances.lock();
            }
        }
        if attempt.carries {
            add(out, from, still, left * chances.loss());
            left *= 1.0 - chances.loss();
        }
        add(out, from, attempt.moved, left);
    }
}

/// Adds an outcome to those from an index on, or its probability to its equal.
#[inline]
fn add(out: &mut Vec<(Packed, f64)>, from: usize, packed: Packed, probability: f64) {
    if probability > 0.0 {
        match out.iter_mut().skip(from).find(|o| o.0 == packed) {
            Some(known) => known.1 += probability,
            None => out.push((packed, probability)),
        }
    }
}
