//! What a task over time forbids on the way, part by part, and the task without some of it: so that one can be told what
//! stands in the way.

use super::course::Course;
use super::goal::Goal;
use super::outline::{Outline, Part};
use super::thing::Entity;
use crate::domain::layout::Layout;
use crate::domain::{Movable, State};
use crate::logic::{TermId, Terms, print};

/// Something that a task demands of every state on the way: the place of the part that says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Constraint(usize);

impl Course {
    /// What it demands of every state on the way, in the order of its parts.
    pub fn constraints(&self, terms: &Terms) -> Vec<Constraint> {
        let binds = |part: &Part| guard(part).is_some_and(|at| self.said(at) != terms.truth());
        let parts = self.outline().parts().iter().enumerate();
        parts.filter(|(_, part)| binds(part)).map(|(at, _)| Constraint(at)).collect()
    }

    /// What a constraint says, as a term: `always(…)`, or what is demanded until something else.
    pub fn says(&self, terms: &Terms, constraint: Constraint) -> String {
        match self.outline().parts().get(constraint.0) {
            Some(Part::Always(at)) => format!("(always:<t,p> {})", print(terms, self.said(*at))),
            Some(Part::Until { hold, .. }) => print(terms, self.said(*hold)),
            _ => String::new(),
        }
    }

    /// The task without some of its constraints.
    #[must_use]
    pub fn without(&self, terms: &Terms, constraints: &[Constraint], initial: &State) -> Course {
        let mut outline = self.outline().clone();
        let mut guards = self.guards().to_vec();
        let is_free = |known: &TermId| *known == terms.truth();
        let free = outline.guards().iter().position(is_free).or_else(|| {
            // The goal that asks for nothing is one in every world.
            guards.push(Goal::new(terms, terms.truth(), initial).ok()?);
            Some(outline.add_guard(terms.truth()))
        });
        let Some(free) = free else { return self.clone() };
        for constraint in constraints {
            outline.replace(constraint.0, |part| match part {
                Part::Always(_) => Part::Done,
                Part::Until { reach, then, .. } => Part::Until { hold: free, reach, then },
                other => other,
            });
        }
        Course::bound(outline, guards)
    }

    /// What its steps are to reach, in their order, where they are one after the other: places among its guards.
    pub fn steps(&self) -> Vec<usize> {
        let parts = self.outline().parts();
        let (mut steps, mut at) = (Vec::new(), parts.len().checked_sub(1));
        while let Some(part) = at.and_then(|at| parts.get(at)) {
            at = match part {
                Part::Until { reach, then, .. } => {
                    steps.push(*reach);
                    Some(*then)
                }
                Part::All(all) => {
                    all.iter().copied().find(|&at| !matches!(parts.get(at), Some(Part::Always(_))))
                }
                _ => None,
            };
        }
        steps
    }

    /// How many of its steps were done at each state of a run.
    pub fn done(&self, run: &[State]) -> Vec<u8> {
        let steps = self.steps();
        let mut done = 0;
        let mut all = Vec::with_capacity(run.len());
        for state in run {
            let is_done = |at: &usize| self.guards().get(*at).is_some_and(|goal| goal.holds(state));
            while steps.get(done).is_some_and(is_done) {
                done += 1;
            }
            all.push(done as u8);
        }
        all
    }

    /// The cells that the robot may not stand in, all else as it is, for something that is demanded on the way.
    pub fn forbidden(&self, terms: &Terms, initial: &State) -> Vec<(i32, i32)> {
        let parts = self.outline().parts().iter().filter_map(guard);
        let binds = |&at: &usize| self.said(at) != terms.truth();
        let guards = parts.filter(binds).filter_map(|at| self.guards().get(at));
        let guards: Vec<&Goal> =
            guards.filter(|goal| goal.mover(initial) == Some(Entity::Agent)).collect();
        if guards.is_empty() {
            return Vec::new();
        }
        let mut there = initial.clone();
        let layout = Layout::new(initial);
        let cells = layout.places().map(|place| layout.cell(place));
        let is_forbidden = |&cell: &(i32, i32)| {
            (there.agent.x, there.agent.y) = cell;
            guards.iter().any(|goal| !goal.holds(&there))
        };
        cells.filter(is_forbidden).collect()
    }

    /// The objects that one of its steps says to move; constraints move nothing.
    pub fn movable(&self, initial: &State) -> Movable {
        let reached = self.outline().parts().iter().filter_map(|part| match part {
            Part::Until { reach, .. } => self.guards().get(*reach),
            _ => None,
        });
        reached.fold(Movable::NONE, |all, goal| all.or(goal.movable(initial)))
    }

    fn said(&self, guard: usize) -> TermId {
        self.outline().guards()[guard]
    }
}

/// The guard that a part demands of every state on the way.
fn guard(part: &Part) -> Option<usize> {
    match part {
        Part::Always(at) | Part::Until { hold: at, .. } => Some(*at),
        _ => None,
    }
}

impl Outline {
    /// Adds a guard that no part asks for yet.
    fn add_guard(&mut self, term: TermId) -> usize {
        self.guards.push(term);
        self.guards.len() - 1
    }

    /// Puts another part in the place of one.
    fn replace(&mut self, at: usize, by: impl FnOnce(Part) -> Part) {
        if let Some(part) = self.parts.get_mut(at) {
            *part = by(std::mem::replace(part, Part::Done));
        }
    }
}
