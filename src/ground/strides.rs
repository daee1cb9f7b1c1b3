//! What a robot with a task over time can do next in compass form: walk as long as the task's stage stays as it is, and then
//! enter a place where it does not, move an object by one cell, or try a door. Like the leaps of a goal of states
//! (`Task`), of which the places that change the stage are the end.

use super::outline::Valuation;
use super::task::merged;
use crate::domain::layout::Place;
use crate::domain::{Action, Dynamics, Entry, Form, Packed, Walks};
use crate::mdp::Leaps;
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// The stages of a task over time.
pub(super) trait Stages {
    /// The stage once a state is seen.
    fn seen(&self, stage: u8, state: Packed) -> u8;
    /// What holds in a state of all but the robot; nothing if that cannot be told apart.
    fn of_others(&self, state: Packed) -> Option<Valuation>;
    /// The stage once the robot is seen at a place where that holds.
    fn seen_at(&self, stage: u8, place: Place, others: Valuation) -> u8;
}

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
    pub(super) fn of(dynamics: &Dynamics, start: Packed) -> Option<Self> {
        let chances = dynamics.rules().chances;
        let has_any = dynamics.rules().form == Form::Compass && chances.slip() < 1.0;
        let is_sure =
            dynamics.is_deterministic(start) && [chances.slip(), chances.loss()] == [0.0; 2];
        let bars = FxHashMap::default();
        has_any.then(|| Strides { walks: Walks::new(dynamics), is_sure, bars })
    }

    /// Appends the leaps from a state that bears its stage; whether there are such.
    pub(super) fn leaps(
        &mut self,
        dynamics: &Dynamics,
        stages: &impl Stages,
        state: Packed,
        out: &mut Leaps<Packed>,
    ) -> bool {
        let Some(bars) = self.explore(dynamics, stages, state) else { return false };
        let (at, stage) = (state.unmarked(), state.mark());
        let slip = dynamics.rules().chances.slip();
        let seen = |next: Packed| next.marked(stages.seen(stage, next));
        for (number, carry) in self.walks.carries(dynamics, at) {
            let here = if self.is_sure {
                out.ends.push((seen(carry.state), 1.0));
                state
            } else {
                let stand = self.walks.stand(dynamics, at, carry);
                let mut ends = Vec::new();
                merged(dynamics, stand, carry.action, &mut ends);
                out.ends.extend(ends.into_iter().map(|(next, p)| (seen(next), p)));
                dynamics.quotient(stand).marked(stage)
            };
            out.close(number, carry.cost, slip, here);
        }
        for (number, Entry { place, side, cost }) in self.entries(dynamics, &bars) {
            let Some(there) = dynamics.with_agent(at, place, side) else { continue };
            out.ends.push((seen(dynamics.quotient(there)), 1.0 - slip));
            if slip > 0.0 {
                out.ends.push((state, slip));
            }
            out.close(usize::from(number), cost, slip, state);
        }
        true
    }

    /// Appends the actions of the leap of this number; whether there are leaps.
    pub(super) fn way(
        &mut self,
        dynamics: &Dynamics,
        stages: &impl Stages,
        (from, number): (Packed, u16),
        out: &mut Vec<Action>,
    ) -> bool {
        let Some(bars) = self.explore(dynamics, stages, from) else { return false };
        let mut entries = self.entries(dynamics, &bars).into_iter();
        if let Some((_, entry)) = entries.find(|(own, _)| *own == number) {
            self.walks.enter(dynamics, entry, out);
        } else if let Some(carry) =
            self.walks.numbered(dynamics, from.unmarked(), usize::from(number))
        {
            self.walks.carry(dynamics, carry, out);
        }
        true
    }

    /// Looks for what can be done next. Nothing if a robot that stays where it is comes to another stage.
    fn explore(
        &mut self,
        dynamics: &Dynamics,
        stages: &impl Stages,
        state: Packed,
    ) -> Option<Rc<[Place]>> {
        let (at, stage) = (state.unmarked(), state.mark());
        if stages.seen(stage, at) != stage {
            return None;
        }
        let places = dynamics.layout().places();
        let bars = match stages.of_others(at) {
            Some(others) => {
                let changes = |&place: &Place| stages.seen_at(stage, place, others) != stage;
                let bars = self.bars.entry((stage, others));
                bars.or_insert_with(|| places.filter(changes).collect()).clone()
            }
            None => {
                let there = |place| dynamics.posed(at, place, dynamics.heading(at));
                places.filter(|&place| stages.seen(stage, there(place)) != stage).collect()
            }
        };
        self.walks.explore_within(dynamics, at, &bars);
        Some(bars)
    }

    /// The ways to enter a place that changes the stage, each with its number; where the heading does not matter, a
    /// shortest one for each place.
    fn entries(&self, dynamics: &Dynamics, bars: &[Place]) -> Vec<(u16, Entry)> {
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
