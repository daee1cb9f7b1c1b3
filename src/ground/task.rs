//! A goal in a world as a problem for a planner: packed states, the goal as a test on them, and the bound
//! that leads a search. States that neither goal nor actions can tell apart are one
//! ([`Dynamics::quotient`]); [`Task::replay`] gives the real states back.

use super::compile::Compiled;
use super::goal::Goal;
use crate::domain::{Action, Dynamics, PackError, Packed, Rules, State, StateError};
use crate::mdp::Mdp;

/// A goal to be earned from an initial state, under the rules of a world.
#[derive(Clone, Debug)]
pub struct Task {
    dynamics: Dynamics,
    goal: Compiled,
    start: Packed,
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
        Ok(Self { dynamics, goal, start })
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
        let from = out.len();
        self.dynamics.outcomes(state, action, out);
        let mut kept = from;
        for at in from..out.len() {
            let (packed, probability) = out[at];
            let packed = self.dynamics.quotient(packed);
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

    fn is_terminal(&self, state: Packed) -> bool {
        self.goal.holds(&self.dynamics, state)
    }

    fn heuristic(&self, state: Packed) -> Option<u32> {
        self.goal.bound(&self.dynamics, state)
    }

    fn most(&self, state: Packed, discount: f64) -> f64 {
        self.goal.most(&self.dynamics, state, discount)
    }
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
