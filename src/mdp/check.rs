//! A consistency kit for any problem (after POMDPs.jl's): walks the states that can be reached, breadth
//! first, and holds every distribution and every bound against the interface's promises.

use super::problem::Mdp;
use std::collections::BTreeSet;

/// How far a sum of probabilities may be from one.
const TOLERANCE: f64 = 1e-9;

/// A promise of [`Mdp`] that a problem breaks, with the state where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[expect(missing_docs, reason = "each message says what its fields are")]
pub enum Fault<S> {
    #[error("a probability is {probability}, not within (0, 1]")]
    Probability { state: S, probability: f64 },
    #[error("the probabilities of an action sum to {sum}")]
    Sum { state: S, sum: f64 },
    #[error("a successor is no legal state")]
    Illegal { state: S, successor: S },
    #[error("the same action in the same state gives another distribution the second time")]
    Unsteady { state: S },
    #[error("a terminal state's bound is {bound:?}, not 0")]
    Terminal { state: S, bound: Option<u32> },
    #[error("the bound falls from {from:?} to {to:?} in one step")]
    Bound { state: S, from: Option<u32>, to: Option<u32> },
}

/// Checks every state within reach, up to `limit` of them, and returns how many it saw. Terminal states
/// absorb: nothing beyond them is looked at. `is_legal` judges successors by what the problem knows.
///
/// # Errors
/// The first broken promise.
pub fn check<P: Mdp>(
    problem: &P,
    limit: usize,
    is_legal: impl Fn(P::State) -> bool,
) -> Result<usize, Fault<P::State>> {
    let mut seen = BTreeSet::from([problem.initial()]);
    let mut order = vec![problem.initial()];
    let mut next = 0;
    let (mut out, mut again) = (Vec::new(), Vec::new());
    while let Some(&state) = order.get(next) {
        next += 1;
        let from = problem.heuristic(state);
        if problem.is_terminal(state) {
            if from != Some(0) {
                return Err(Fault::Terminal { state, bound: from });
            }
            continue;
        }
        for &action in problem.actions() {
            out.clear();
            again.clear();
            problem.successors(state, action, &mut out);
            problem.successors(state, action, &mut again);
            if out != again {
                return Err(Fault::Unsteady { state });
            }
            let mut sum = 0.0;
            for &(successor, probability) in &out {
                if !(probability > 0.0 && probability <= 1.0) {
                    return Err(Fault::Probability { state, probability });
                }
                sum += probability;
                if !is_legal(successor) {
                    return Err(Fault::Illegal { state, successor });
                }
                let to = problem.heuristic(successor);
                if !is_consistent(from, to) {
                    return Err(Fault::Bound { state, from, to });
                }
                if order.len() < limit && seen.insert(successor) {
                    order.push(successor);
                }
            }
            if (sum - 1.0).abs() > TOLERANCE {
                return Err(Fault::Sum { state, sum });
            }
        }
    }
    Ok(order.len())
}

/// Whether a bound sinks by at most one in a step; `None` is infinite.
fn is_consistent(from: Option<u32>, to: Option<u32>) -> bool {
    match (from, to) {
        (_, None) => true,
        (None, Some(_)) => false,
        (Some(from), Some(to)) => from <= to.saturating_add(1),
    }
}
