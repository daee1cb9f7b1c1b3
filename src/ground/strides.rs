//! What a robot with a task over time can do next in compass form: walk as long as the task's stage stays as it is, and then
//! enter a place where it does not, move an object by one cell, or try a door. Like the leaps of a goal of states
//! (`Task`), of which the places that change the stage are the end.

use super::errand::Errand;
use super::outline::Valuation;
use crate::domain::layout::Place;
use crate::domain::{Entry, Form, Packed, Walks};
use crate::mdp::{Leaps, Mdp, Watch, each_action};
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// Walks, and what is known of where they end.
#[derive(Clone, Debug)]
pub(super) struct Strides {
    walks: Walks,
    /// Whether nothing goes wrong on them.
    is_sure: bool,
    /// By stage, and by what holds of all but the robot, the places that change the stage.
    bars: FxHashMap<(u8, Valuation), Rc<[Place]>>,
}

impl Strides {
    /// Those of a world, if it has any.
    pub(super) fn of(dynamics: &crate::domain::Dynamics, start: Packed) -> Option<Self> {
        let chances = dynamics.rules().chances;
        let has_any = dynamics.rules().form == Form::Compass && chances.slip() < 1.0;
        let is_sure =
            dynamics.is_deterministic(start) && [chances.slip(), chances.loss()] == [0.0; 2];
        let bars = FxHashMap::default();
        has_any.then(|| Strides { walks: Walks::new(dynamics), is_sure, bars })
    }

    /// Looks for what can be done next. Nothing if a robot that stays where it is comes to another stage.
    fn explore(&mut self, errand: &Errand, state: Packed) -> Option<Rc<[Place]>> {
        let (dynamics, watch) = (errand.problem().dynamics(), errand.watch());
        let (at, stage) = (state.unmarked(), state.mark());
        if watch.step(stage, at) != stage {
            return None;
        }
        let bars = match watch.of_others(at) {
            Some(others) => {
                let bars = self.bars.entry((stage, others));
                let bars = bars.or_insert_with(|| {
                    let changes = |&place: &Place| watch.step_at(stage, place, others) != stage;
                    dynamics.layout().places().filter(changes).collect()
                });
                bars.clone()
            }
            None => {
                let heading = dynamics.heading(at);
                let changes =
                    |&place: &Place| watch.step(stage, dynamics.posed(at, place, heading)) != stage;
                dynamics.layout().places().filter(changes).collect()
            }
        };
        self.walks.explore_within(dynamics, at, &bars);
        Some(bars)
    }

    /// The ways to enter a place that changes the stage, each with its number; where the heading does not matter, a
    /// shortest one for each place.
    fn entries(&self, errand: &Errand, bars: &[Place]) -> Vec<(u16, Entry)> {
        let dynamics = errand.problem().dynamics();
        let mut entries: Vec<Entry> = Vec::new();
        for entry in self.walks.entries(dynamics, bars) {
            match entries.last_mut().filter(|last| last.place == entry.place) {
                Some(last) if !dynamics.rules().pull => {
                    if entry.cost < last.cost {
                        *last = entry;
                    }
                }
                _ => entries.push(entry),
            }
        }
        (0..=u16::MAX).rev().zip(entries).collect()
    }
}

/// Appends the leaps of a task over time from a state that bears its stage.
pub(super) fn leaps(
    errand: &Errand,
    whole: &impl Mdp<State = Packed>,
    state: Packed,
    out: &mut Leaps<Packed>,
) {
    let mut strides = errand.problem().strides();
    let Some(strides) = strides.as_mut() else { return each_action(whole, state, out) };
    let Some(bars) = strides.explore(errand, state) else { return each_action(whole, state, out) };
    let (dynamics, watch) = (errand.problem().dynamics(), errand.watch());
    let (at, stage) = (state.unmarked(), state.mark());
    let slip = dynamics.rules().chances.slip();
    for (number, carry) in strides.walks.carries(dynamics, at) {
        let here = if strides.is_sure {
            out.ends.push((carry.state.marked(watch.step(stage, carry.state)), 1.0));
            state
        } else {
            let stand = strides.walks.stand(dynamics, at, carry);
            let mut ends = Vec::new();
            errand.successors((stand, stage), carry.action, &mut ends);
            out.ends.extend(ends.into_iter().map(|((next, stage), p)| (next.marked(stage), p)));
            dynamics.quotient(stand).marked(stage)
        };
        out.close(number, carry.cost, slip, here);
    }
    for (number, Entry { place, side, cost }) in strides.entries(errand, &bars) {
        let Some(there) = dynamics.with_agent(at, place, side) else { continue };
        let there = dynamics.quotient(there);
        out.ends.push((there.marked(watch.step(stage, there)), 1.0 - slip));
        if slip > 0.0 {
            out.ends.push((state, slip));
        }
        out.close(usize::from(number), cost, slip, state);
    }
}

/// Appends the actions of the leap of this number.
pub(super) fn way(
    errand: &Errand,
    from: Packed,
    number: u16,
    out: &mut Vec<crate::domain::Action>,
) {
    let (dynamics, mut strides) = (errand.problem().dynamics(), errand.problem().strides());
    let explored = strides.as_mut().and_then(|own| own.explore(errand, from).map(|b| (own, b)));
    let Some((strides, bars)) = explored else {
        return out.extend(errand.actions().get(usize::from(number)));
    };
    let entry = strides.entries(errand, &bars).into_iter().find(|(own, _)| *own == number);
    if let Some((_, entry)) = entry {
        strides.walks.enter(dynamics, entry, out);
    } else if let Some(carry) =
        strides.walks.numbered(dynamics, from.unmarked(), usize::from(number))
    {
        strides.walks.carry(dynamics, carry, out);
    }
}
