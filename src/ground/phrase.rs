//! The phrases of a goal that stand for something in the world, and what each refers to, or why to nothing.

use super::claim::measured;
use super::denote::{Denotation, Failure, meaning};
use super::goal::{GoalError, check};
use super::outline::Outline;
use super::predicate::{Meaning, Measure};
use super::shade::Shade;
use super::thing::Entity;
use crate::domain::{Color, State};
use crate::logic::ty::RUN;
use crate::logic::{Node, TermId, Terms};

/// A phrase that stands for something in the world: `the`, `argmax` or `argmin` of something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phrase {
    /// The phrase.
    pub term: TermId,
    /// What it refers to. A phrase around one that fails has no fault of its own: [`Failure::Inner`].
    pub referent: Result<Entity, Failure>,
    /// For a phrase that names a shade and refers: the shade, and the colour that was taken for it.
    pub taken: Option<(Shade, Color)>,
}

/// The closed phrases of a goal, or of a task over time, each once, in the order of the goal, inner ones before those around them, and what
/// they refer to in the initial state.
///
/// # Errors
/// Why the term is no goal.
pub fn phrases(terms: &Terms, goal: TermId, initial: &State) -> Result<Vec<Phrase>, GoalError> {
    if terms.ty(goal) == RUN {
        Outline::new(terms, goal)?.guards().iter().try_for_each(|&guard| check(terms, guard))?;
    } else {
        check(terms, goal)?;
    }
    let mut denotation = Denotation::new(terms, initial);
    let mut found = Vec::new();
    visit(terms, goal, &mut denotation, &mut found);
    if denotation.exhausted() { Err(GoalError::TooLarge) } else { Ok(found) }
}

/// The shade that a phrase picks the most like.
fn shade(terms: &Terms, phrase: TermId) -> Option<Shade> {
    match meaning(terms, phrase)? {
        (Meaning::Argmax, &[_, measure]) => match measured(terms, measure)? {
            Measure::Shade(shade) => Some(shade),
            Measure::Size => None,
        },
        _ => None,
    }
}

/// Whether some phrase at or below `term` fails; all are put into `found`.
fn visit(
    terms: &Terms,
    term: TermId,
    denotation: &mut Denotation<'_>,
    found: &mut Vec<Phrase>,
) -> bool {
    let (args, below) = match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => return false,
        Node::Lambda { body, .. } => (&[][..], Some(body)),
        Node::Apply { args, .. } => (args, None),
    };
    let mut fails = false;
    for &part in args.iter().chain(&below) {
        fails |= visit(terms, part, denotation, found);
    }
    let is_phrase = meaning(terms, term).is_some_and(|(meaning, _)| {
        matches!(meaning, Meaning::The | Meaning::Argmax | Meaning::Argmin)
    });
    if !is_phrase || terms.free(term) > 0 {
        return fails;
    }
    let referent = match fails {
        true => Err(Failure::Inner),
        false => denotation.referent(term, &mut Vec::new()),
    };
    let thing = referent.as_ref().ok().and_then(|&at| denotation.things.get(at));
    let taken = shade(terms, term).zip(thing.and_then(|thing| thing.color()));
    let referent = referent.map(|at| denotation.entity(at));
    fails = referent.is_err();
    if !found.iter().any(|known| known.term == term) {
        found.push(Phrase { term, referent, taken });
    }
    fails
}
