//! Solvers that are not generic. Generic code is compiled where its types are put in, and this crate is the one that is
//! made for speed: so whoever solves tasks for the page takes these.

use crate::domain::{Action, Packed};
use crate::ground::Undertaking;
use crate::mdp::{Outcome, Policy, Progress, Settings, Solver, StartingAt};
use crate::plan::{Auto, ValueIteration, Why};
use std::rc::Rc;

/// A task, shared by its solvers, begun in a state.
type Problem = StartingAt<Rc<Undertaking>>;

/// A solver that suits the task (`Auto`).
pub struct Planner(Auto<Problem>);

/// All states of a task worked out (`ValueIteration`).
pub struct AllStates(ValueIteration<Problem>);

impl Planner {
    /// A solver for the task begun in a state.
    #[must_use]
    pub fn new(task: Rc<Undertaking>, start: Packed, settings: Settings) -> Self {
        Self(Auto::new(StartingAt::new(task, start), settings))
    }

    /// Why the present solver was chosen.
    #[must_use]
    pub const fn why(&self) -> Why {
        self.0.why()
    }
}

impl AllStates {
    /// All states that can come about from a state of the task.
    #[must_use]
    pub fn new(task: Rc<Undertaking>, start: Packed, settings: Settings) -> Self {
        Self(ValueIteration::whole(StartingAt::new(task, start), settings))
    }

    /// Whether the budget ended before all states were known.
    #[must_use]
    pub fn is_partial(&self) -> bool {
        self.0.is_partial()
    }
}

/// A solver that another one does the work of.
macro_rules! solves {
    ($($solver:ty),*) => {$(
        impl Policy<Packed, Action> for $solver {
            fn action(&self, state: Packed) -> Option<Action> {
                self.0.action(state)
            }
            fn value(&self, state: Packed) -> Option<f64> {
                self.0.value(state)
            }
        }

        impl Solver<Packed, Action> for $solver {
            fn name(&self) -> &'static str {
                self.0.name()
            }
            fn step(&mut self, n: usize) -> Option<Outcome> {
                self.0.step(n)
            }
            fn progress(&self) -> Progress {
                self.0.progress()
            }
        }
    )*};
}

solves!(Planner, AllStates);
