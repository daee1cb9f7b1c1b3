//! Whether two tasks are first satisfied at the same state of every run: breadth first over what is left of both, so that
//! a run that tells them apart is a shortest one.

use super::goal::GoalError;
use super::monitor::{Monitor, Residual, TooMany};
use super::outline::Outline;
use super::proposition::{Guards, Propositions};
use crate::domain::State;
use crate::logic::{TermId, Terms};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// What may be so in one state, in all combinations.
const MOST_WORLDS: usize = 1 << 12;
/// Pairs of residuals that are looked at.
const MOST_PAIRS: usize = 1 << 12;

/// How two tasks compare.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// Every run satisfies both first at the same state, or neither.
    Equivalent,
    /// This run does not: what is so in each of its states.
    Apart(Vec<Vec<String>>),
}

/// Why two tasks cannot be compared.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CompareError {
    /// One is no task.
    #[error("{0}")]
    Goal(#[from] GoalError),
    /// There is too much to look at.
    #[error("budget: the two ask too much of a state, or have too many stages, to be compared")]
    Budget,
}

impl From<TooMany> for CompareError {
    fn from(_: TooMany) -> Self {
        CompareError::Budget
    }
}

/// One of the two, on its way along a run.
struct Side {
    monitor: Monitor,
    guards: Guards,
}

impl Side {
    fn step(&mut self, from: Residual, world: u64) -> Result<(Residual, bool), TooMany> {
        let to = self.monitor.step(from, self.guards.valuation(world))?;
        Ok((to, self.monitor.satisfies(to)))
    }
}

/// Compares two tasks, of type `t` or `p`. Without a world closed atoms that differ are independent of each other; in
/// one, phrases are resolved there and a body is in one place at a time.
///
/// # Errors
/// When one is no task, or when there is too much to compare.
pub fn compare(
    terms: &Terms,
    a: TermId,
    b: TermId,
    world: Option<&State>,
) -> Result<Comparison, CompareError> {
    let mut propositions = Propositions::default();
    let mut side = |term: TermId| -> Result<Side, CompareError> {
        let outline = Outline::new(terms, term)?;
        let guards = match world {
            Some(world) => propositions.bound(terms, &outline, world)?,
            None => propositions.said(terms, &outline),
        };
        Ok(Side { monitor: Monitor::new(&outline)?, guards })
    };
    let (mut one, mut other) = (side(a)?, side(b)?);
    let worlds = propositions.worlds(MOST_WORLDS).ok_or(CompareError::Budget)?;
    // What is left of both, with the pair and the state that led there.
    let mut pairs: IndexMap<(Residual, Residual), Option<(usize, u64)>, FxBuildHasher> =
        IndexMap::default();
    pairs.insert((Monitor::START, Monitor::START), None);
    let mut next = 0;
    while let Some((&(left, right), _)) = pairs.get_index(next) {
        for &world in &worlds {
            let (left, is_satisfied) = one.step(left, world)?;
            let (right, is_other) = other.step(right, world)?;
            if is_satisfied != is_other {
                let run = trace(&pairs, (next, world)).into_iter();
                return Ok(Comparison::Apart(run.map(|world| propositions.names(world)).collect()));
            }
            let is_over = is_satisfied || one.monitor.fails(left) && other.monitor.fails(right);
            if !is_over && !pairs.contains_key(&(left, right)) {
                if pairs.len() == MOST_PAIRS {
                    return Err(CompareError::Budget);
                }
                pairs.insert((left, right), Some((next, world)));
            }
        }
        next += 1;
    }
    Ok(Comparison::Equivalent)
}

/// The states that led to a pair and on by one more.
fn trace(
    pairs: &IndexMap<(Residual, Residual), Option<(usize, u64)>, FxBuildHasher>,
    last: (usize, u64),
) -> Vec<u64> {
    let mut run = Vec::new();
    let mut at = Some(last);
    while let Some((pair, world)) = at {
        run.push(world);
        at = pairs.get_index(pair).and_then(|(_, before)| *before);
    }
    run.reverse();
    run
}
