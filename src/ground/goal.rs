//! A goal bound to the world it is said in: its determiners are resolved in the initial state, once and for
//! all (invariant 4); what is left is a formula over entities that is asked of any later state.

use super::denote::{Denotation, Env, Failure, meaning};
use super::predicate::{Meaning, Measure, PREDICATES, Property, Relation, predicate};
use super::thing::{Entity, Thing};
use crate::domain::State;
use crate::logic::{Node, TIME, TermId, Terms};

/// Nodes that a formula may have.
const MAX_NODES: usize = 200_000;

/// What a goal asks of the current state. Entities that the current state lacks have no property and stand
/// in no relation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// All of them; true when there is none.
    And(Vec<Formula>),
    /// One of them; false when there is none.
    Or(Vec<Formula>),
    /// Not so.
    Not(Box<Formula>),
    /// An entity has a property.
    Property(Property, Entity),
    /// Two entities stand in a relation.
    Relation(Relation, Entity, Entity),
    /// An entity of the current state is a witness.
    Exists {
        /// The entities of the initial state, each with what it must fulfil (and it must still be there).
        known: Vec<(Entity, Formula)>,
        /// What an entity that the initial state lacks must fulfil, as [`Entity::Stranger`] of this depth.
        stranger: Box<Formula>,
        /// The number of `exists` around this one.
        depth: usize,
    },
}

/// A goal, bound to its initial state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Goal {
    formula: Formula,
    failures: Vec<(TermId, Failure)>,
    denies_nothing: bool,
}

/// Why a term is no goal.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GoalError {
    /// Its type is another.
    #[error("a goal has type t, or p where it speaks of time; this term has type {0}")]
    NotATruthValue(String),
    /// It speaks of a variable that nothing binds.
    #[error("the term has a variable that no lambda binds")]
    Open,
    /// A constant is none of Cleanup World's.
    #[error("unknown constant {name}: use one of {known}")]
    Unknown {
        /// The constant's name.
        name: String,
        /// Those that are known.
        known: String,
    },
    /// A constant's type is not Cleanup World's.
    #[error("{name} has type {expected}, not {found}")]
    WrongType {
        /// The constant's name.
        name: String,
        /// The type it should have.
        expected: &'static str,
        /// The type it has.
        found: String,
    },
    /// Its nested quantifiers would take too long.
    #[error("the goal's phrases are nested too deeply for this world")]
    TooLarge,
}

/// Whether a term is a goal at all: closed, of type `t`, over the known constants.
///
/// # Errors
/// The first thing that is wrong.
pub fn check(terms: &Terms, term: TermId) -> Result<(), GoalError> {
    let ty = terms.types.print(terms.ty(term));
    if ty != "t" {
        return Err(GoalError::NotATruthValue(ty));
    }
    if terms.free(term) > 0 {
        return Err(GoalError::Open);
    }
    check_constants(terms, term)
}

fn check_constants(terms: &Terms, term: TermId) -> Result<(), GoalError> {
    match terms.node(term) {
        Node::Variable(_) => Ok(()),
        Node::Lambda { body, .. } => check_constants(terms, body),
        Node::Apply { head, args } => {
            check_constants(terms, head)?;
            args.iter().try_for_each(|&arg| check_constants(terms, arg))
        }
        Node::Constant(constant) => {
            let name = terms.name(constant);
            let found = terms.types.print(terms.constant_ty(constant));
            // Who takes a shade for a property is told which colours there are.
            let known = predicate(name).filter(|known| {
                known.ty == found || !matches!(known.meaning, Meaning::Measure(Measure::Shade(_)))
            });
            let Some(known) = known else {
                return Err(GoalError::Unknown { name: name.to_owned(), known: known_names() });
            };
            if found == known.ty {
                return Ok(());
            }
            Err(GoalError::WrongType { name: name.to_owned(), expected: known.ty, found })
        }
    }
}

/// The constants that a goal, or a task over time, may hold.
pub(super) fn known_names() -> String {
    let names = PREDICATES.iter().map(|known| known.name).chain(TIME.iter().map(|(name, _)| *name));
    names.collect::<Vec<_>>().join(" ")
}

impl Goal {
    /// Binds a term to the state in which it is said.
    ///
    /// # Errors
    /// Why the term is no goal; that a phrase does not refer is no error.
    pub fn new(terms: &Terms, term: TermId, initial: &State) -> Result<Goal, GoalError> {
        check(terms, term)?;
        let denotation = Denotation::new(terms, initial);
        let mut binder = Binder {
            terms,
            denotation,
            names: Vec::new(),
            failures: Vec::new(),
            is_denied: false,
            denies_nothing: false,
            nodes: 0,
        };
        let formula = binder.formula(term, &mut Vec::new())?;
        if binder.denotation.exhausted() {
            return Err(GoalError::TooLarge);
        }
        let Binder { failures, denies_nothing, .. } = binder;
        Ok(Goal { formula, failures, denies_nothing })
    }

    /// Whether a state earns the reward.
    pub fn holds(&self, current: &State) -> bool {
        self.formula.holds(&Thing::all(current), &mut Vec::new())
    }

    /// What it asks of the current state.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// Its outermost phrases that do not refer in the initial state; each makes its relation false.
    pub fn failures(&self) -> &[(TermId, Failure)] {
        &self.failures
    }

    /// Whether what it denies speaks of a thing that there is not: what is so by that alone, nobody asked for.
    pub const fn denies_nothing(&self) -> bool {
        self.denies_nothing
    }
}

impl Formula {
    /// What is true, or false, whatever the state.
    pub const fn constant(value: bool) -> Formula {
        if value { Formula::And(Vec::new()) } else { Formula::Or(Vec::new()) }
    }

    fn holds(&self, things: &[Thing<'_>], strangers: &mut Vec<usize>) -> bool {
        match self {
            Formula::And(all) => all.iter().all(|part| part.holds(things, strangers)),
            Formula::Or(any) => any.iter().any(|part| part.holds(things, strangers)),
            Formula::Not(part) => !part.holds(things, strangers),
            Formula::Property(property, of) => {
                find(of, things, strangers).is_some_and(|thing| property.holds(thing))
            }
            Formula::Relation(relation, a, b) => {
                match (find(a, things, strangers), find(b, things, strangers)) {
                    (Some(a), Some(b)) => relation.holds(a, b),
                    _ => false,
                }
            }
            Formula::Exists { known, stranger, depth } => {
                things.iter().enumerate().any(|(at, thing)| {
                    strangers.truncate(*depth);
                    strangers.push(at);
                    let body = known.iter().find(|(entity, _)| thing.is(entity));
                    body.map_or(&**stranger, |(_, body)| body).holds(things, strangers)
                })
            }
        }
    }
}

fn find<'s>(entity: &Entity, things: &[Thing<'s>], strangers: &[usize]) -> Option<Thing<'s>> {
    match entity {
        Entity::Stranger(depth) => strangers.get(*depth).and_then(|&at| things.get(at)).copied(),
        _ => things.iter().find(|thing| thing.is(entity)).copied(),
    }
}

/// The outer part of a goal, on its way to a formula.
struct Binder<'a> {
    terms: &'a Terms,
    denotation: Denotation<'a>,
    /// What each variable stands for, beside the environment of places, innermost last.
    names: Vec<Entity>,
    failures: Vec<(TermId, Failure)>,
    /// Whether what is being bound stands below an odd number of `not`.
    is_denied: bool,
    denies_nothing: bool,
    nodes: usize,
}

impl Binder<'_> {
    fn formula(&mut self, term: TermId, env: &mut Env) -> Result<Formula, GoalError> {
        self.nodes += 1;
        if self.nodes > MAX_NODES || self.denotation.exhausted() {
            return Err(GoalError::TooLarge);
        }
        let Some((meaning, args)) = meaning(self.terms, term) else {
            return Ok(Formula::constant(false));
        };
        Ok(match (meaning, args) {
            (Meaning::True, _) => Formula::constant(true),
            (Meaning::And, all) => Formula::And(self.each(all, env)?),
            (Meaning::Or, any) => Formula::Or(self.each(any, env)?),
            (Meaning::Not, &[arg]) => {
                self.is_denied = !self.is_denied;
                let denied = self.formula(arg, env)?;
                self.is_denied = !self.is_denied;
                Formula::Not(Box::new(denied))
            }
            (Meaning::Exists, &[property]) => self.exists(property, env)?,
            (Meaning::Property(property), &[of]) => match self.entity(of, env) {
                Some(of) => Formula::Property(property, of),
                None => Formula::constant(false),
            },
            (Meaning::Relation(relation), &[a, b]) => {
                match (self.entity(a, env), self.entity(b, env)) {
                    (Some(a), Some(b)) => Formula::Relation(relation, a, b),
                    _ => Formula::constant(false),
                }
            }
            _ => Formula::constant(false),
        })
    }

    fn each(&mut self, terms: &[TermId], env: &mut Env) -> Result<Vec<Formula>, GoalError> {
        terms.iter().map(|&term| self.formula(term, env)).collect()
    }

    fn exists(&mut self, property: TermId, env: &mut Env) -> Result<Formula, GoalError> {
        let Node::Lambda { body, .. } = self.terms.node(property) else {
            return Ok(Formula::constant(false));
        };
        let depth = env.len();
        let mut with = |this: &mut Self, place: Option<usize>, name: Entity| {
            env.push(place);
            this.names.push(name);
            let formula = this.formula(body, env);
            this.names.pop();
            env.pop();
            formula
        };
        let mut known = Vec::new();
        for at in 0..self.denotation.things.len() {
            let entity = self.denotation.entity(at);
            known.push((entity.clone(), with(self, Some(at), entity)?));
        }
        let stranger = Box::new(with(self, None, Entity::Stranger(depth))?);
        Ok(Formula::Exists { known, stranger, depth })
    }

    fn entity(&mut self, term: TermId, env: &mut Env) -> Option<Entity> {
        if let Node::Variable(index) = self.terms.node(term) {
            let at = self.names.len().checked_sub(usize::try_from(index).ok()? + 1)?;
            return self.names.get(at).cloned();
        }
        match self.denotation.referent(term, env) {
            Ok(at) => Some(self.denotation.entity(at)),
            Err(failure) => {
                if self.terms.free(term) == 0 {
                    self.denies_nothing |= self.is_denied;
                    if !self.failures.iter().any(|(t, _)| *t == term) {
                        self.failures.push((term, failure));
                    }
                }
                None
            }
        }
    }
}
