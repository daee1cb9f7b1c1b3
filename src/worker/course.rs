//! A task over time on its way to a plan: how many of its steps are done along the run, and what else could be done where
//! what it demands on the way leaves none.

use super::protocol::{Instead, Reading};
use super::read::plain;
use super::solving::{STEPS, solver};
use crate::domain::{Rules, State};
use crate::ground::relax::{after, demands, once, without};
use crate::ground::{Course, Goal, GoalError, Undertaking, claim};
use crate::logic::{TermId, Terms};
use crate::mdp::{Mdp, Outcome, Solver};
use crate::solve::Planner;
use std::rc::Rc;

/// Demands of which each is tried without, before all are.
const MOST_DEMANDS: usize = 4;

/// A task over time in the world that it is said in.
pub(super) struct Timed {
    terms: Terms,
    /// What is left of it.
    task: TermId,
    /// How many of its steps are done.
    done: usize,
    pub(super) course: Course,
    /// Selections of what it demands that were not tried yet, the last first.
    left: Vec<Vec<TermId>>,
    /// What is tried without some, as it is solved.
    trying: Option<(Vec<TermId>, Planner)>,
}

impl Timed {
    pub(super) fn new(terms: Terms, task: TermId, state: &State) -> Result<Timed, GoalError> {
        let course = Course::new(&terms, task, state)?;
        let all = demands(&terms, task)?;
        let single = all.iter().take(MOST_DEMANDS).map(|&demand| vec![demand]);
        let mut left: Vec<Vec<TermId>> = single.collect();
        if all.len() > 1 {
            left.push(all);
        }
        left.reverse();
        Ok(Timed { terms, task, done: 0, course, left, trying: None })
    }

    /// Whether some phrase of it stands for nothing that there is.
    pub(super) fn is_lost(&self) -> bool {
        self.course.guards().iter().any(|goal| !goal.failures().is_empty())
    }

    /// Of a run so many of its steps were done in each state: what could be done instead is of what is left then.
    pub(super) fn come_to(&mut self, done: &[u8]) {
        let done = done.last().map_or(0, |&done| usize::from(done));
        if let Ok(rest) = after(&mut self.terms, self.task, done.saturating_sub(self.done)) {
            (self.task, self.done) = (rest, done);
        }
    }

    /// Does a bounded part of looking for the least demand without which there is a way: whether that is over, with what
    /// could be done instead.
    pub(super) fn relax(&mut self, state: &State, rules: Rules) -> Option<Option<Box<Instead>>> {
        if let Some((demands, mut solver)) = self.trying.take() {
            match solver.step(STEPS) {
                None => self.trying = Some((demands, solver)),
                Some(Outcome::Solved) => return Some(self.instead(&demands, state, without)),
                Some(_) => {}
            }
            return None;
        }
        let Some(demands) = self.left.pop() else { return Some(None) };
        let task = without(&mut self.terms, self.task, &demands).ok();
        let course = task.and_then(|task| Course::new(&self.terms, task, state).ok());
        let undertaking = course.and_then(|one| Undertaking::course(&one, state, rules).ok());
        self.trying = undertaking.map(|undertaking| {
            let undertaking = Rc::new(undertaking);
            let start = undertaking.initial();
            (demands, solver(&undertaking, start))
        });
        None
    }

    /// The rest of the task from a state in which something is so that it demands not to be: once that is over, not again.
    pub(super) fn once_out(&mut self, state: &State) -> Option<Box<Instead>> {
        let all = demands(&self.terms, self.task).ok()?;
        let is_broken = |&demand: &TermId| {
            Goal::new(&self.terms, demand, state).is_ok_and(|goal| !goal.holds(state))
        };
        let broken: Vec<TermId> = all.into_iter().filter(is_broken).collect();
        self.instead(&broken, state, once)
    }

    fn instead(
        &mut self,
        demands: &[TermId],
        state: &State,
        make: impl Fn(&mut Terms, TermId, &[TermId]) -> Result<TermId, crate::logic::LogicError>,
    ) -> Option<Box<Instead>> {
        let task = make(&mut self.terms, self.task, demands).ok()?;
        let claims = demands.iter().map(|&demand| claim(&self.terms, demand)).collect();
        let reading: Reading = plain(&self.terms, task, state);
        Some(Box::new(Instead { demands: claims, reading }))
    }
}
