//! What a task over time forbids on the way, part by part, and the task without some of it: so that one can be told what
//! stands in the way.

use super::course::Course;
use super::goal::Goal;
use super::outline::{Outline, Part};
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
