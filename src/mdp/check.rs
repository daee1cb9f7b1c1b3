//! A consistency kit for any problem (after POMDPs.jl's): walks the states that can be reached, breadth
//! first, and holds every distribution and every bound against the interface's promises.

use super::problem::Mdp;
use super::simulate::sample;
use super::solver::DISCOUNT;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
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
    #[error(
        "a state is said to be worth {most} at most, but an action leads to what is worth {next}"
    )]
    Most { state: S, most: f64, next: f64 },
    #[error(
        "draws do not follow the distribution: chi-square is {statistic}, and at most {limit} by chance"
    )]
    Draws { state: S, statistic: f64, limit: f64 },
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
            let (mut sum, mut worth) = (0.0, 0.0);
            for &(successor, probability) in &out {
                worth += probability
                    * if problem.is_terminal(successor) {
                        1.0
                    } else {
                        DISCOUNT * problem.most(successor, DISCOUNT)
                    };
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
            let most = problem.most(state, DISCOUNT);
            if worth > most + TOLERANCE {
                return Err(Fault::Most { state, most, next: worth });
            }
        }
    }
    Ok(order.len())
}

/// Draws `n` times from every distribution of more than one outcome within reach, up to `limit` states, and holds
/// the counts against the distribution by Pearson's chi-square (1900). Returns how many distributions it saw.
///
/// # Errors
/// The first whose counts chance explains less than once in three million (Wilson and Hilferty's limit, 1931).
pub fn check_draws<P: Mdp>(
    problem: &P,
    limit: usize,
    n: u32,
    seed: u64,
) -> Result<usize, Fault<P::State>> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let mut seen = BTreeSet::from([problem.initial()]);
    let mut order = vec![problem.initial()];
    let (mut next, mut distributions) = (0, 0);
    let (mut out, mut buffer) = (Vec::new(), Vec::new());
    while let Some(&state) = order.get(next) {
        next += 1;
        if problem.is_terminal(state) {
            continue;
        }
        for &action in problem.actions() {
            out.clear();
            problem.successors(state, action, &mut out);
            for &(successor, _) in &out {
                if order.len() < limit && seen.insert(successor) {
                    order.push(successor);
                }
            }
            if out.len() < 2 {
                continue;
            }
            distributions += 1;
            let mut counts = vec![0_u32; out.len()];
            for _ in 0..n {
                let drawn = sample(problem, state, action, &mut buffer, &mut rng);
                match out.iter().position(|o| o.0 == drawn) {
                    Some(at) => counts[at] += 1,
                    None => return Err(Fault::Illegal { state, successor: drawn }),
                }
            }
            let statistic: f64 = out
                .iter()
                .zip(&counts)
                .map(|(&(_, probability), &count)| {
                    let expected = probability * f64::from(n);
                    let off = f64::from(count) - expected;
                    off * off / expected
                })
                .sum();
            let limit = chi_square_limit(out.len() - 1);
            if statistic > limit {
                return Err(Fault::Draws { state, statistic, limit });
            }
        }
    }
    Ok(distributions)
}

/// What chi-square with so many degrees of freedom exceeds once in three million.
fn chi_square_limit(freedom: usize) -> f64 {
    const DEVIATIONS: f64 = 5.0;
    let k = u32::try_from(freedom).map_or(f64::MAX, f64::from);
    let part = 2.0 / (9.0 * k);
    let root = 1.0 - part + DEVIATIONS * part.sqrt();
    k * root * root * root
}

/// Whether a bound sinks by at most one in a step; `None` is infinite.
fn is_consistent(from: Option<u32>, to: Option<u32>) -> bool {
    match (from, to) {
        (_, None) => true,
        (None, Some(_)) => false,
        (Some(from), Some(to)) => from <= to.saturating_add(1),
    }
}
