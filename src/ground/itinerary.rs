//! How far the robot alone is from the end of a task over time that speaks of nothing but where it is: exact where there
//! are neither objects nor locks, found once for every place and stage by breadth-first search backwards from where the
//! task is satisfied. Invariant: a lower bound, consistent, as every action leads to a place beside or to none.

use super::monitor::{Monitor, Residual, TooMany};
use super::outline::Valuation;
use crate::domain::layout::{Layout, NOWHERE, Place};

/// The task is never satisfied from there.
const NEVER: u16 = u16::MAX;
/// Nothing is known of it: no way leads there.
const UNMET: u16 = u16::MAX - 1;

/// Actions from each stage and place until a task is satisfied.
#[derive(Clone, Debug)]
pub(super) struct Itinerary {
    n_places: usize,
    left: Vec<u16>,
}

impl Itinerary {
    /// That of a task from a place; `holds` says which guards hold at each, `opens` whether it can ever be entered. The
    /// monitor comes to know all stages on the way.
    ///
    /// # Errors
    /// [`TooMany`] when the task comes to too many stages; the monitor is then as far as it came.
    pub(super) fn new(
        layout: &Layout,
        opens: impl Fn(Place) -> bool,
        (start, holds): (Place, &[Valuation]),
        monitor: &mut Monitor,
    ) -> Result<Self, TooMany> {
        let n_places = layout.len();
        let at = |stage: Residual, place: Place| stage.index() * n_places + usize::from(place);
        let first = monitor.step(Monitor::START, holds[usize::from(start)])?;
        let mut left = vec![UNMET; (first.index() + 1) * n_places];
        left[at(first, start)] = NEVER;
        let mut met = vec![(first, start)];
        // Where the task is satisfied, and for all else from where it is reached.
        let (mut reached, mut before) = (Vec::new(), Vec::new());
        let mut next = 0;
        while let Some(&(stage, place)) = met.get(next) {
            next += 1;
            let here = at(stage, place);
            if monitor.satisfies(stage) {
                left[here] = 0;
                reached.push(here);
                continue;
            }
            // An action may also lead nowhere.
            let beside = layout.neighbours(place).into_iter();
            let beside = beside.filter(|&to| to != NOWHERE && opens(to));
            for to in beside.chain([place]) {
                let then = monitor.step(stage, holds[usize::from(to)])?;
                if monitor.fails(then) {
                    continue;
                }
                let there = at(then, to);
                if left.len() <= there {
                    left.resize((then.index() + 1) * n_places, UNMET);
                }
                if left[there] == UNMET {
                    left[there] = NEVER;
                    met.push((then, to));
                }
                before.push((there, here));
            }
        }
        before.sort_unstable();
        let mut next = 0;
        while let Some(&to) = reached.get(next) {
            next += 1;
            let more = left[to].saturating_add(1).min(UNMET - 1);
            let begin = before.partition_point(|&(end, _)| end < to);
            for &(_, from) in before[begin..].iter().take_while(|&&(end, _)| end == to) {
                if left[from] == NEVER {
                    left[from] = more;
                    reached.push(from);
                }
            }
        }
        Ok(Itinerary { n_places, left })
    }

    /// A lower bound on the actions that are left at a place and stage; `None` when no number suffices.
    pub(super) fn least(&self, place: Place, stage: usize) -> Option<u32> {
        match self.left.get(stage * self.n_places + usize::from(place)) {
            Some(&NEVER) => None,
            Some(&UNMET) | None => Some(0),
            Some(&left) => Some(u32::from(left)),
        }
    }
}
