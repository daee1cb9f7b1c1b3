//! The outline of a task over time (`p`): what it asks of single states, each once, and when these must hold along a run.
//! A run satisfies `until(c, x, k)` when `x` holds in some state of it from which on `k` is satisfied, and `c` in every
//! state before; `always(x)` when `x` holds in every state; `all` and `any` by their parts. Knows no state.

use super::goal::{GoalError, known_names};
use super::predicate::predicate;
use crate::logic::ty::{RUN, TRUTH};
use crate::logic::{Node, TIME, TermId, Terms};
use rustc_hash::FxHashMap;

/// Things that a task may ask of single states: what holds of one is a bit of a [`Valuation`].
pub const MOST_GUARDS: usize = 64;
/// Parts that a task may have.
const MOST_PARTS: usize = 4_096;

/// Which guards of an outline hold in a state, a bit each.
pub type Valuation = u64;

/// A part of a task. It stands behind the parts that it is made of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// Any run will do.
    Done,
    /// None will.
    Failed,
    /// In some state a guard holds, `reach`, and a part is satisfied from there on; in all states before, `hold` does.
    Until {
        /// A guard.
        hold: usize,
        /// A guard.
        reach: usize,
        /// A part.
        then: usize,
    },
    /// A guard holds in every state.
    Always(usize),
    /// All of these parts are satisfied.
    All(Vec<usize>),
    /// One of them is.
    Any(Vec<usize>),
}

/// A task over time, taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    pub(super) guards: Vec<TermId>,
    pub(super) parts: Vec<Part>,
}

impl Outline {
    /// The outline of a task; that of a goal of states is to reach it. Whether its guards are goals is not looked at.
    ///
    /// # Errors
    /// Why the term is no task.
    pub fn new(terms: &Terms, term: TermId) -> Result<Outline, GoalError> {
        let mut outliner =
            Outliner { terms, guards: Vec::new(), parts: Vec::new(), known: FxHashMap::default() };
        match terms.ty(term) {
            TRUTH | RUN if terms.free(term) > 0 => return Err(GoalError::Open),
            TRUTH => {
                let (reach, hold) = (outliner.guard(term)?, outliner.guard(terms.truth())?);
                let then = outliner.push(Part::Done)?;
                outliner.push(Part::Until { hold, reach, then })?;
            }
            RUN => {
                outliner.part(term)?;
            }
            other => return Err(GoalError::NotATruthValue(terms.types.print(other))),
        }
        let Outliner { guards, parts, .. } = outliner;
        Ok(Outline { guards, parts })
    }

    /// Whether no run whatever satisfies it, by its form alone.
    pub fn is_never(&self) -> bool {
        self.parts.last() == Some(&Part::Failed)
    }

    /// Whether it forbids something only once nothing is left to be done: that forbids nothing.
    pub fn forbids_idly(&self) -> bool {
        let is_last = |at: &usize| match self.parts.get(*at) {
            Some(Part::Always(_)) => true,
            Some(Part::All(parts)) => {
                let kind = |at: &usize| self.parts.get(*at);
                parts.iter().all(|at| matches!(kind(at), Some(Part::Always(_) | Part::Done)))
            }
            _ => false,
        };
        self.parts.iter().any(|part| matches!(part, Part::Until { then, .. } if is_last(then)))
    }

    /// What it asks of single states: goals.
    pub fn guards(&self) -> &[TermId] {
        &self.guards
    }

    /// Its parts; the last is the whole.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }
}

/// Whether what a form forbids it forbids only once nothing is left to be done: who said so meant something else.
pub fn forbids_idly(terms: &Terms, form: TermId) -> bool {
    terms.ty(form) == RUN && Outline::new(terms, form).is_ok_and(|task| task.forbids_idly())
}

struct Outliner<'a> {
    terms: &'a Terms,
    guards: Vec<TermId>,
    parts: Vec<Part>,
    known: FxHashMap<TermId, usize>,
}

impl Outliner<'_> {
    fn guard(&mut self, term: TermId) -> Result<usize, GoalError> {
        if let Some(at) = self.guards.iter().position(|&known| known == term) {
            return Ok(at);
        }
        if self.guards.len() == MOST_GUARDS {
            return Err(GoalError::TooLarge);
        }
        self.guards.push(term);
        Ok(self.guards.len() - 1)
    }

    fn push(&mut self, part: Part) -> Result<usize, GoalError> {
        if self.parts.len() == MOST_PARTS {
            return Err(GoalError::TooLarge);
        }
        self.parts.push(part);
        Ok(self.parts.len() - 1)
    }

    fn part(&mut self, term: TermId) -> Result<usize, GoalError> {
        if let Some(&known) = self.known.get(&term) {
            return Ok(known);
        }
        let (head, args) = match self.terms.node(term) {
            Node::Apply { head, args } => (head, args),
            _ => (term, &[][..]),
        };
        let Node::Constant(constant) = self.terms.node(head) else { return Err(GoalError::Open) };
        let name = self.terms.name(constant);
        let found = self.terms.types.print(self.terms.constant_ty(constant));
        let expected = TIME.iter().find(|(known, _)| *known == name).map(|(_, ty)| *ty);
        let expected = expected.or_else(|| predicate(name).map(|known| known.ty));
        match expected {
            None => return Err(GoalError::Unknown { name: name.to_owned(), known: known_names() }),
            Some(expected) if expected != found => {
                return Err(GoalError::WrongType { name: name.to_owned(), expected, found });
            }
            Some(_) => {}
        }
        let part = match (name, args) {
            ("done", []) => Part::Done,
            ("always", &[holds]) => Part::Always(self.guard(holds)?),
            ("until", &[hold, reach, then]) => Part::Until {
                hold: self.guard(hold)?,
                reach: self.guard(reach)?,
                then: self.part(then)?,
            },
            ("all", parts) if !parts.is_empty() => Part::All(self.each(parts)?),
            ("any", parts) if !parts.is_empty() => Part::Any(self.each(parts)?),
            _ => Part::Failed,
        };
        let at = self.push(part)?;
        self.known.insert(term, at);
        Ok(at)
    }

    fn each(&mut self, terms: &[TermId]) -> Result<Vec<usize>, GoalError> {
        terms.iter().map(|&term| self.part(term)).collect()
    }
}
