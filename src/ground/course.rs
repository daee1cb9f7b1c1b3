//! A task over time (`p`), bound to the world it is said in: its guards are goals, whose phrases are resolved in the first
//! state once and for all (invariant 4); its outline says when they must hold.

use super::goal::{Goal, GoalError};
use super::outline::{Outline, Valuation};
use super::run::Beginnings;
use crate::domain::State;
use crate::logic::{TermId, Terms};

/// A task over time in the world that it is said in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Course {
    outline: Outline,
    guards: Vec<Goal>,
}

impl Course {
    /// Binds a task to the state in which it is said. A goal of states is the task to reach it.
    ///
    /// # Errors
    /// Why the term is no task; that a phrase does not refer is no error.
    pub fn new(terms: &Terms, term: TermId, initial: &State) -> Result<Course, GoalError> {
        let outline = Outline::new(terms, term)?;
        let guards = outline.guards().iter().map(|&guard| Goal::new(terms, guard, initial));
        Ok(Course { guards: guards.collect::<Result<_, _>>()?, outline })
    }

    /// A task whose guards are bound already.
    pub(super) const fn bound(outline: Outline, guards: Vec<Goal>) -> Course {
        Course { outline, guards }
    }

    /// When its guards must hold.
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// What it asks of single states, in the outline's order.
    pub fn guards(&self) -> &[Goal] {
        &self.guards
    }

    /// Which of its guards hold in a state.
    pub fn valuation(&self, state: &State) -> Valuation {
        let holds = self.guards.iter().map(|goal| goal.holds(state));
        holds.enumerate().fold(0, |bits, (at, holds)| bits | Valuation::from(holds) << at)
    }

    /// Which beginnings of a run satisfy it.
    pub fn beginnings<'s>(&self, run: impl IntoIterator<Item = &'s State>) -> Beginnings {
        let run: Vec<Valuation> = run.into_iter().map(|state| self.valuation(state)).collect();
        Beginnings::of(&self.outline, &run)
    }
}
