//! A goal in a world as a problem for a planner: packed states, the goal as a test on them, and the bound
//! that leads a search. States that neither goal nor actions can tell apart are one
//! ([`Dynamics::quotient`]); [`Task::replay`] gives the real states back.

use super::compile::Compiled;
use super::goal::Goal;
use super::pairs::Pairs;
use crate::domain::layout::Place;
use crate::domain::{
    Action, Carry, Dynamics, Form, PackError, Packed, Rules, State, StateError, Walks,
};
use crate::mdp::{Leaps, Mdp, Sharpened, each_action};
use std::cell::RefCell;

/// Sets of robots that are looked at in a part of what makes bounds sharper.
const SETS: usize = 50;

/// The number of the leap that only walks.
const ARRIVE: u16 = u16::MAX;

/// A goal to be earned from an initial state, under the rules of a world.
#[derive(Clone, Debug)]
pub struct Task {
    dynamics: Dynamics,
    goal: Compiled,
    start: Packed,
    /// Whether plans are made of leaps: walks that end in moving an object or in trying a door.
    has_leaps: bool,
    /// Whether nothing goes wrong on them.
    is_sure: bool,
    walks: RefCell<Walks>,
    /// What makes the bound sharper, as far as it is made.
    pairs: Option<RefCell<Pairs>>,
}

/// Why there is no task.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TaskError {
    /// The initial state is illegal.
    #[error(transparent)]
    Illegal(#[from] StateError),
    /// The initial state is too large.
    #[error(transparent)]
    Pack(#[from] PackError),
}

impl Task {
    /// Compiles a goal that was bound to `initial`.
    ///
    /// # Errors
    /// When the state is illegal, or too large to be planned in.
    pub fn new(goal: &Goal, initial: &State, rules: Rules) -> Result<Self, TaskError> {
        initial.check()?;
        let dynamics = Dynamics::new(initial, rules)?;
        let start = dynamics.pack(initial)?;
        let goal = Compiled::new(goal, &dynamics, initial, dynamics.quotient(start));
        let Rules { form, chances, .. } = rules;
        let has_leaps = form == Form::Compass && chances.slip() < 1.0;
        let is_sure = has_leaps
            && dynamics.is_deterministic(start)
            && [chances.slip(), chances.loss()] == [0.0; 2];
        let pairs = if is_sure { goal.pairs(&dynamics, start) } else { None };
        let walks = RefCell::new(Walks::new(&dynamics));
        Ok(Self {
            dynamics,
            goal,
            start,
            has_leaps,
            is_sure,
            walks,
            pairs: pairs.map(RefCell::new),
        })
    }

    /// The world's moves.
    #[must_use]
    pub const fn dynamics(&self) -> &Dynamics {
        &self.dynamics
    }

    /// Whether the goal asks for something that no state of this world has, for want of a referent or
    /// otherwise: nothing needs to be searched.
    #[must_use]
    pub fn is_impossible(&self) -> bool {
        self.goal.is_impossible()
    }

    /// Whether nothing is left to chance: every action has one outcome in every state.
    #[must_use]
    pub fn is_deterministic(&self) -> bool {
        self.dynamics.is_deterministic(self.start)
    }

    /// The same problem with no two states taken for one: what a person watches. A policy for the task is
    /// asked about the [`Dynamics::quotient`] of these states.
    #[must_use]
    pub const fn world(&self) -> World<'_> {
        World(self)
    }

    /// The states that actions lead through from the initial one, which comes first, when each has its
    /// likeliest outcome.
    #[must_use]
    pub fn replay(&self, actions: &[Action]) -> Vec<State> {
        let mut packed = self.start;
        let mut outcomes = Vec::new();
        let mut states = vec![self.dynamics.unpack(packed)];
        for &action in actions {
            outcomes.clear();
            self.dynamics.outcomes(packed, action, &mut outcomes);
            let first = (packed, 0.0);
            packed = outcomes.iter().fold(first, |best, &o| if o.1 > best.1 { o } else { best }).0;
            states.push(self.dynamics.unpack(packed));
        }
        states
    }
}

impl Task {
    /// Appends what may come of the last action of a carry; where it is taken.
    fn ends(
        &self,
        walks: &Walks,
        state: Packed,
        carry: Carry,
        out: &mut Vec<(Packed, f64)>,
    ) -> Packed {
        let chances = self.dynamics.rules().chances;
        if self.is_sure || (chances.loss() == 0.0 && !walks.tries(&self.dynamics, state, carry)) {
            // A slip changes nothing, wherever that is.
            if chances.slip() > 0.0 {
                out.push((state, chances.slip()));
            }
            out.push((carry.state, 1.0 - chances.slip()));
            return state;
        }
        let stand = walks.stand(&self.dynamics, state, carry);
        self.successors(stand, carry.action, out);
        self.dynamics.quotient(stand)
    }

    /// The nearest place to walk to at which the goal holds, and the steps there; never the robot's own.
    fn nearest(&self, walks: &Walks, state: Packed) -> Option<(Place, u32)> {
        if !self.goal.speaks_of_robot() {
            return None;
        }
        let heading = self.dynamics.heading(state);
        let is_end = |&(place, _): &(Place, u32)| {
            let there = self.dynamics.with_agent(state, place, heading);
            there.is_some_and(|there| self.is_terminal(there))
        };
        walks.reached().skip(1).find(is_end)
    }
}

impl Mdp for Task {
    type State = Packed;
    type Action = Action;

    fn initial(&self) -> Packed {
        self.dynamics.quotient(self.start)
    }

    fn actions(&self) -> &[Action] {
        self.dynamics.actions()
    }

    fn successors(&self, state: Packed, action: Action, out: &mut Vec<(Packed, f64)>) {
        merged(&self.dynamics, state, action, out);
    }

    fn is_terminal(&self, state: Packed) -> bool {
        self.goal.holds(&self.dynamics, state)
    }

    fn heuristic(&self, state: Packed) -> Option<u32> {
        match &self.pairs {
            Some(pairs) => self.goal.bound_with(&pairs.borrow(), &self.dynamics, state),
            None => self.goal.bound(&self.dynamics, state),
        }
    }

    fn most(&self, state: Packed, discount: f64) -> f64 {
        self.goal.most(&self.dynamics, state, discount)
    }

    fn sharpen(&self) -> Sharpened {
        self.pairs.as_ref().map_or(Sharpened::Whole, |pairs| pairs.borrow_mut().step(SETS))
    }

    fn estimate(&self, state: Packed) -> Option<u32> {
        self.goal.estimate(&self.dynamics, state)
    }

    fn n_parts(&self) -> usize {
        self.goal.n_parts()
    }

    fn part(&self, index: usize, state: Packed) -> Option<u32> {
        self.goal.part(index, &self.dynamics, state)
    }

    fn parts(&self, state: Packed) -> Vec<(u32, usize)> {
        self.goal.parts(&self.dynamics, state)
    }

    fn leaps(&self, state: Packed, out: &mut Leaps<Packed>) {
        if !self.has_leaps {
            return each_action(self, state, out);
        }
        let slip = self.dynamics.rules().chances.slip();
        let mut walks = self.walks.borrow_mut();
        walks.explore(&self.dynamics, state, self.goal.speaks_of_robot());
        for (number, carry) in walks.carries(&self.dynamics, state) {
            let here = self.ends(&walks, state, carry, &mut out.ends);
            out.close(number, carry.cost, slip, here);
        }
        if let Some((place, cost)) = self.nearest(&walks, state) {
            let there = self.dynamics.with_agent(state, place, self.dynamics.heading(state));
            out.ends.push((self.dynamics.quotient(there.unwrap_or(state)), 1.0 - slip));
            if slip > 0.0 {
                out.ends.push((state, slip));
            }
            out.close(usize::from(ARRIVE), cost, slip, state);
        }
    }

    fn way(&self, from: Packed, number: u16, out: &mut Vec<Action>) {
        if !self.has_leaps {
            return out.extend(self.actions().get(usize::from(number)));
        }
        let mut walks = self.walks.borrow_mut();
        walks.explore(&self.dynamics, from, self.goal.speaks_of_robot());
        if number == ARRIVE {
            if let Some((place, _)) = self.nearest(&walks, from) {
                walks.walk(place, out);
            }
        } else if let Some(carry) = walks.numbered(&self.dynamics, from, usize::from(number)) {
            walks.carry(&self.dynamics, carry, out);
        }
    }
}

/// Appends what may come of an action, states that nothing tells apart as one.
pub(super) fn merged(
    dynamics: &Dynamics,
    state: Packed,
    action: Action,
    out: &mut Vec<(Packed, f64)>,
) {
    let from = out.len();
    dynamics.outcomes(state, action, out);
    let mut kept = from;
    for at in from..out.len() {
        let (packed, probability) = out[at];
        let packed = dynamics.quotient(packed);
        match out[from..kept].iter_mut().find(|o| o.0 == packed) {
            Some(known) => known.1 += probability,
            None => {
                out[kept] = (packed, probability);
                kept += 1;
            }
        }
    }
    out.truncate(kept);
}

/// A task in which every state is told from every other; see [`Task::world`].
#[derive(Clone, Copy, Debug)]
pub struct World<'a>(&'a Task);

impl Mdp for World<'_> {
    type State = Packed;
    type Action = Action;

    fn initial(&self) -> Packed {
        self.0.start
    }

    fn actions(&self) -> &[Action] {
        self.0.actions()
    }

    fn successors(&self, state: Packed, action: Action, out: &mut Vec<(Packed, f64)>) {
        self.0.dynamics.outcomes(state, action, out);
    }

    fn is_terminal(&self, state: Packed) -> bool {
        self.0.is_terminal(state)
    }

    fn heuristic(&self, state: Packed) -> Option<u32> {
        self.0.heuristic(state)
    }

    fn most(&self, state: Packed, discount: f64) -> f64 {
        self.0.most(state, discount)
    }
}
