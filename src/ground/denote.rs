//! What a term denotes in one state: entities, truth values, numbers. Everything below a determiner is
//! evaluated here, in the initial state; a goal's outer part is not (see [`super::goal`]).
//! Referents of closed phrases are found once.

use super::predicate::{Meaning, Measure, predicate};
use super::thing::{Entity, Thing};
use crate::domain::State;
use crate::logic::{Node, TermId, Terms};
use rustc_hash::FxHashMap;

/// Evaluations of subterms that one goal may take; a goal beyond it has some five nested dependent phrases.
const MAX_STEPS: u32 = 5_000_000;

/// Why a phrase has no referent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// Nothing is like that.
    None,
    /// Several things are: `the` cannot tell which.
    Several(Vec<Entity>),
    /// These come first together under `argmax` or `argmin`.
    Tie(Vec<Entity>),
    /// There is a single candidate, and comparing takes two.
    Single(Entity),
    /// The candidates are of several kinds, or have no size or colour: they cannot be compared.
    Mixed(Vec<Entity>),
    /// A phrase inside it has no referent, or the variable it hangs on stands for nothing here.
    Inner,
}

/// The entities that the variables stand for, innermost binder last; `None` for what the state lacks.
pub(super) type Env = Vec<Option<usize>>;

/// An evaluator for one state.
pub(super) struct Denotation<'a> {
    terms: &'a Terms,
    pub(super) things: Vec<Thing<'a>>,
    referents: FxHashMap<TermId, Result<usize, Failure>>,
    steps: u32,
}

impl<'a> Denotation<'a> {
    /// An evaluator for `state`. Terms must have passed [`super::goal::check`].
    pub(super) fn new(terms: &'a Terms, state: &'a State) -> Self {
        let things = Thing::all(state);
        Denotation { terms, things, referents: FxHashMap::default(), steps: 0 }
    }

    /// Whether the budget ran out; answers since then mean nothing.
    pub(super) fn exhausted(&self) -> bool {
        self.steps >= MAX_STEPS
    }

    /// The entity, by its place in `things`, that a term of type `e` refers to.
    pub(super) fn referent(&mut self, term: TermId, env: &mut Env) -> Result<usize, Failure> {
        if let Node::Variable(index) = self.terms.node(term) {
            return lookup(env, index).ok_or(Failure::Inner);
        }
        if self.terms.free(term) > 0 {
            return self.determine(term, env);
        }
        if let Some(known) = self.referents.get(&term) {
            return known.clone();
        }
        let found = self.determine(term, &mut Vec::new());
        self.referents.insert(term, found.clone());
        found
    }

    fn determine(&mut self, term: TermId, env: &mut Env) -> Result<usize, Failure> {
        let (meaning, args) = meaning(self.terms, term).ok_or(Failure::Inner)?;
        let candidates = args.first().map(|&p| self.extension(p, env)).unwrap_or_default();
        let order = match (meaning, args.get(1)) {
            (Meaning::The, _) => {
                return match candidates.as_slice() {
                    [] => Err(Failure::None),
                    [only] => Ok(*only),
                    _ => Err(Failure::Several(self.entities(&candidates))),
                };
            }
            (Meaning::Argmax, Some(&measure)) => (measure, 1),
            (Meaning::Argmin, Some(&measure)) => (measure, -1),
            _ => return Err(Failure::Inner),
        };
        self.best(&candidates, order, env)
    }

    /// The single candidate that is first by a measure.
    fn best(
        &mut self,
        candidates: &[usize],
        (measure, sign): (TermId, i64),
        env: &mut Env,
    ) -> Result<usize, Failure> {
        let measured = |body| match meaning(self.terms, body)? {
            (Meaning::Measure(measure), _) => Some(measure),
            _ => None,
        };
        if sign > 0
            && let Node::Lambda { body, .. } = self.terms.node(measure)
            && let Some(Measure::Shade(_)) = measured(body)
        {
            // Only what is like the shade at all can be the most like it, and that may be a single thing.
            let mut alike = Vec::new();
            for &at in candidates {
                env.push(Some(at));
                alike.extend(self.number(body, env).filter(|&value| value > 0).map(|_| at));
                env.pop();
            }
            return match alike.as_slice() {
                [only] => Ok(*only),
                [] => Err(Failure::None),
                _ => self.first(&alike, (measure, sign), env),
            };
        }
        self.first(candidates, (measure, sign), env)
    }

    /// The single candidate that is first by a measure, of at least two.
    fn first(
        &mut self,
        candidates: &[usize],
        (measure, sign): (TermId, i64),
        env: &mut Env,
    ) -> Result<usize, Failure> {
        match candidates {
            [] => return Err(Failure::None),
            [only] => return Err(Failure::Single(self.entity(*only))),
            _ => {}
        }
        let class = |at: &usize| self.things.get(*at).map(|thing| thing.class());
        if candidates.windows(2).any(|two| two.first().map(class) != two.last().map(class)) {
            return Err(Failure::Mixed(self.entities(candidates)));
        }
        let Node::Lambda { body, .. } = self.terms.node(measure) else {
            return Err(Failure::Mixed(self.entities(candidates)));
        };
        let mut best: Vec<usize> = Vec::new();
        let mut most = i64::MIN;
        for &at in candidates {
            env.push(Some(at));
            let value = self.number(body, env);
            env.pop();
            let Some(value) = value.map(|value| sign * value) else {
                return Err(Failure::Mixed(self.entities(candidates)));
            };
            if value > most {
                best.clear();
                most = value;
            }
            if value == most {
                best.push(at);
            }
        }
        match best.as_slice() {
            [only] => Ok(*only),
            _ => Err(Failure::Tie(self.entities(&best))),
        }
    }

    /// The entities of which a term of type `<e,t>` holds, in the order of `things`.
    pub(super) fn extension(&mut self, term: TermId, env: &mut Env) -> Vec<usize> {
        let Node::Lambda { body, .. } = self.terms.node(term) else { return Vec::new() };
        let n_things = self.things.len();
        let holds = |at: &usize| {
            env.push(Some(*at));
            let holds = self.truth(body, env);
            env.pop();
            holds
        };
        (0..n_things).filter(holds).collect()
    }

    /// The truth value of a term of type `t`.
    fn truth(&mut self, term: TermId, env: &mut Env) -> bool {
        if self.exhausted() {
            return false;
        }
        self.steps += 1;
        let Some((meaning, args)) = meaning(self.terms, term) else { return false };
        match (meaning, args) {
            (Meaning::True, _) => true,
            (Meaning::And, all) => all.iter().all(|&arg| self.truth(arg, env)),
            (Meaning::Or, any) => any.iter().any(|&arg| self.truth(arg, env)),
            (Meaning::Not, &[arg]) => !self.truth(arg, env),
            (Meaning::Exists, &[property]) => !self.extension(property, env).is_empty(),
            (Meaning::Property(property), &[of]) => {
                self.thing(of, env).is_some_and(|thing| property.holds(thing))
            }
            (Meaning::Relation(relation), &[a, b]) => {
                match (self.thing(a, env), self.thing(b, env)) {
                    (Some(a), Some(b)) => relation.holds(a, b),
                    _ => false,
                }
            }
            _ => false,
        }
    }

    fn number(&mut self, term: TermId, env: &mut Env) -> Option<i64> {
        match meaning(self.terms, term)? {
            (Meaning::Measure(measure), &[of]) => measure.of(self.thing(of, env)?),
            _ => None,
        }
    }

    fn thing(&mut self, term: TermId, env: &mut Env) -> Option<Thing<'a>> {
        let at = self.referent(term, env).ok()?;
        self.things.get(at).copied()
    }

    /// What the thing at a place is known by.
    pub(super) fn entity(&self, at: usize) -> Entity {
        self.things.get(at).map_or(Entity::Agent, |thing| thing.entity())
    }

    fn entities(&self, places: &[usize]) -> Vec<Entity> {
        places.iter().map(|&at| self.entity(at)).collect()
    }
}

/// What the variable of a de Bruijn index stands for.
pub(super) fn lookup(env: &Env, index: u32) -> Option<usize> {
    let from_end = usize::try_from(index).ok()?.checked_add(1)?;
    env.len().checked_sub(from_end).and_then(|at| env.get(at)).copied().flatten()
}

/// The meaning of a term's head constant, and its arguments.
pub(super) fn meaning(terms: &Terms, term: TermId) -> Option<(Meaning, &[TermId])> {
    let args = match terms.node(term) {
        Node::Apply { args, .. } => args,
        _ => &[],
    };
    let constant = terms.head_constant(term)?;
    Some((predicate(terms.name(constant))?.meaning, args))
}
