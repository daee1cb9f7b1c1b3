//! Running a problem forward: one seeded draw a step, by inversion over the successors in their order.
//! Invariant: the same problem, actions and seed visit the same states on every machine.

use super::problem::Mdp;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Draws the successor of `action` in `state`. `buffer` is working space, so that a step allocates nothing.
pub fn sample<P: Mdp>(
    problem: &P,
    state: P::State,
    action: P::Action,
    buffer: &mut Vec<(P::State, f64)>,
    rng: &mut impl Rng,
) -> P::State {
    buffer.clear();
    problem.successors(state, action, buffer);
    if let [(only, _)] = buffer[..] {
        return only;
    }
    let mut left: f64 = rng.random();
    for &(next, probability) in buffer.iter() {
        if left < probability {
            return next;
        }
        left -= probability;
    }
    // Rounding may leave a little over: it belongs to the last.
    buffer.last().map_or(state, |last| last.0)
}

/// The states of a run from the initial one under `actions`, one more than those, or fewer when a
/// terminal state ends it.
#[must_use]
pub fn simulate<P: Mdp>(problem: &P, actions: &[P::Action], seed: u64) -> Vec<P::State> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let mut buffer = Vec::new();
    let mut state = problem.initial();
    let mut states = vec![state];
    for &action in actions {
        if problem.is_terminal(state) {
            break;
        }
        state = sample(problem, state, action, &mut buffer, &mut rng);
        states.push(state);
    }
    states
}
