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
        let goal = Compiled::new(goal, &dynamics, initial, start);
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

    /// The states that actions lead through from the initial one, which comes first.
    #[must_use]
    pub fn replay(&self, actions: &[Action]) -> Vec<State> {
        let mut packed = self.start;
        let mut states = vec![self.dynamics.unpack(packed)];
        for &action in actions {
            packed = self.dynamics.step(packed, action);
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
        out.push((self.dynamics.quotient(self.dynamics.step(state, action)), 1.0));
    }

    fn is_terminal(&self, state: Packed) -> bool {
        self.goal.holds(&self.dynamics, state)
    }

    fn heuristic(&self, state: Packed) -> Option<u32> {
        self.goal.bound(&self.dynamics, state)
    }
}
