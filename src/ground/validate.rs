//! Validation-driven learning's question (Artzi and Zettlemoyer 2013): is a form false before and true after
//! every demonstration? Properties and relations are bitsets over the entities of a pair, compiled once per
//! pair; phrases are looked up by term, answers by term and pair. Agrees with [`Goal`] on every term.

use super::class::Class;
use super::denote::{Env, lookup};
use super::goal::Goal;
use super::predicate::{Meaning, Measure, Property, Relation, predicate};
use super::thing::Thing;
use crate::domain::{Color, State};
use crate::logic::{ConstantId, Node, TermId, Terms};
use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap};

/// A set of entities. Pairs with more entities are left to [`Goal`].
type Bits = u128;
const MAX_ENTITIES: usize = Bits::BITS as usize;
/// Evaluations of open terms that one answer may take.
const MAX_STEPS: u32 = 1_000_000;

/// A demonstration that the validator has compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PairId(u32);

/// One state of a pair, by the places that the entities have in the state before.
#[derive(Debug)]
struct View {
    present: Bits,
    properties: [Bits; Property::COUNT],
    /// For each spatial relation and entity: what stands in it to the entity, and to what the entity does.
    to: [Vec<Bits>; 4],
    from: [Vec<Bits>; 4],
    sizes: Vec<Option<i64>>,
    colors: Vec<Option<Color>>,
}

/// The two views of a pair; `None` when it has too many entities.
type Views = Option<(View, View)>;

/// A validator for the terms of one arena. Equal pairs are compiled once.
#[derive(Debug, Default)]
pub struct Validator {
    pairs: IndexSet<(State, State), FxBuildHasher>,
    views: Vec<Views>,
    meanings: FxHashMap<ConstantId, Option<Meaning>>,
    /// The referents of closed phrases in the state before.
    referents: FxHashMap<(TermId, PairId), Option<u8>>,
    answers: FxHashMap<(TermId, PairId), bool>,
}

impl Validator {
    /// A validator that knows no pair.
    pub fn new() -> Self {
        Validator::default()
    }

    /// Compiles a demonstration, or finds it again.
    pub fn pair(&mut self, pre: &State, post: &State) -> PairId {
        let (at, new) = self.pairs.insert_full((pre.clone(), post.clone()));
        if new {
            self.views.push(compile(pre, post));
        }
        PairId(u32::try_from(at).unwrap_or(u32::MAX))
    }

    /// The state before a pair.
    pub fn pre(&self, pair: PairId) -> Option<&State> {
        self.pairs.get_index(pair.0 as usize).map(|(pre, _)| pre)
    }

    /// Whether a term is false before and true after each of the pairs, its phrases bound before. A term
    /// that is no goal is not, and without pairs nothing is.
    pub fn valid(&mut self, terms: &Terms, term: TermId, pairs: &[PairId]) -> bool {
        !pairs.is_empty() && pairs.iter().all(|&pair| self.valid_on(terms, term, pair))
    }

    fn valid_on(&mut self, terms: &Terms, term: TermId, pair: PairId) -> bool {
        if let Some(&known) = self.answers.get(&(term, pair)) {
            return known;
        }
        let answer = self.holds(terms, term, pair, Side::Pre) == Some(false)
            && self.holds(terms, term, pair, Side::Post) == Some(true);
        self.answers.insert((term, pair), answer);
        answer
    }

    /// Whether a goal holds in one state of a pair; `None` for a term that is no goal.
    pub fn holds(&mut self, terms: &Terms, term: TermId, pair: PairId, side: Side) -> Option<bool> {
        let Validator { pairs, views, meanings, referents, .. } = self;
        let at = pair.0 as usize;
        match views.get(at)? {
            Some((pre, post)) => {
                if terms.ty(term) != crate::logic::ty::TRUTH || terms.free(term) > 0 {
                    return None;
                }
                let mut evaluator =
                    Evaluator { terms, pre, post, pair, meanings, referents, steps: 0 };
                evaluator.truth(term, side, &mut Vec::new())
            }
            None => {
                let (pre, post) = pairs.get_index(at)?;
                let goal = Goal::new(terms, term, pre).ok()?;
                Some(goal.holds(if side == Side::Pre { pre } else { post }))
            }
        }
    }

    /// Whether a phrase can be part of what was meant: a closed term of type `e` refers before each of the pairs,
    /// a property is something's. Other terms always can.
    pub fn denotes(&mut self, terms: &Terms, term: TermId, pairs: &[PairId]) -> bool {
        pairs.iter().all(|&pair| self.denotes_in(terms, term, pair).unwrap_or(true))
    }

    fn denotes_in(&mut self, terms: &Terms, term: TermId, pair: PairId) -> Option<bool> {
        let Validator { views, meanings, referents, .. } = self;
        let (pre, post) = views.get(pair.0 as usize)?.as_ref()?;
        let mut evaluator = Evaluator { terms, pre, post, pair, meanings, referents, steps: 0 };
        if terms.ty(term) == crate::logic::ty::ENTITY {
            Some(evaluator.referent(term, &mut Vec::new())?.is_some())
        } else {
            Some(evaluator.extension(term, Side::Pre, &mut Vec::new())? != 0)
        }
    }
}

/// A state of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "before and after")]
pub enum Side {
    Pre,
    Post,
}

fn compile(pre: &State, post: &State) -> Views {
    let (before, after) = (Thing::all(pre), Thing::all(post));
    let mut known: Vec<Thing<'_>> = before.clone();
    let is_new = |thing: &Thing<'_>| !before.iter().any(|other| other.is(&thing.entity()));
    known.extend(after.iter().copied().filter(is_new));
    if known.len() > MAX_ENTITIES {
        return None;
    }
    let place = |thing: &Thing<'_>| known.iter().position(|other| other.is(&thing.entity()));
    let here: Vec<Option<Thing<'_>>> = (0..known.len()).map(|at| before.get(at).copied()).collect();
    let mut there: Vec<Option<Thing<'_>>> = vec![None; known.len()];
    for &thing in &after {
        if let Some(slot) = place(&thing).and_then(|at| there.get_mut(at)) {
            slot.get_or_insert(thing);
        }
    }
    Some((View::new(&here), View::new(&there)))
}

impl View {
    fn new(things: &[Option<Thing<'_>>]) -> View {
        let set = |holds: &dyn Fn(Thing<'_>) -> bool| -> Bits {
            let bit = |(at, thing): (usize, &Option<Thing<'_>>)| {
                Bits::from(thing.is_some_and(holds)) << at
            };
            things.iter().enumerate().map(bit).fold(0, |all, bit| all | bit)
        };
        let mut properties = [0; Property::COUNT];
        for property in Property::all() {
            if let Some(slot) = properties.get_mut(property.index()) {
                *slot = set(&|thing| property.holds(thing));
            }
        }
        let table = |row: &dyn Fn(Thing<'_>) -> Bits| {
            things.iter().map(|thing| thing.map_or(0, row)).collect::<Vec<Bits>>()
        };
        let to = |relation: Relation| table(&|b| set(&|a| relation.holds(a, b)));
        let from = |relation: Relation| table(&|a| set(&|b| relation.holds(a, b)));
        View {
            present: set(&|_| true),
            properties,
            to: Relation::SPATIAL.map(to),
            from: Relation::SPATIAL.map(from),
            sizes: things.iter().map(|thing| thing.and_then(Thing::size)).collect(),
            colors: things.iter().map(|thing| thing.and_then(Thing::color)).collect(),
        }
    }

    /// The entities `a` with `relation(a, b)`.
    fn to(&self, relation: Relation, b: usize) -> Bits {
        row(&self.to, relation, b).unwrap_or(self.present & bit(b))
    }

    /// The entities `b` with `relation(a, b)`.
    fn from(&self, relation: Relation, a: usize) -> Bits {
        row(&self.from, relation, a).unwrap_or(self.present & bit(a))
    }

    fn property(&self, property: Property) -> Bits {
        self.properties.get(property.index()).copied().unwrap_or(0)
    }

    fn number(&self, measure: Measure, at: usize) -> Option<i64> {
        match measure {
            Measure::Size => self.sizes.get(at).copied().flatten(),
            Measure::Shade(shade) => Some(shade.likeness(self.colors.get(at).copied().flatten()?)),
        }
    }
}

/// A row of a spatial relation; `None` for equality.
fn row(tables: &[Vec<Bits>; 4], relation: Relation, at: usize) -> Option<Bits> {
    let table = Relation::SPATIAL.iter().position(|spatial| *spatial == relation)?;
    Some(tables.get(table).and_then(|rows| rows.get(at)).copied().unwrap_or(0))
}

fn bit(at: usize) -> Bits {
    u32::try_from(at).ok().and_then(|at| Bits::from(1u8).checked_shl(at)).unwrap_or(0)
}

fn members(mut set: Bits) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let at = set.trailing_zeros();
        set &= set.checked_sub(1)?;
        Some(at as usize)
    })
}

/// A term at work on one pair. `None` stands for a term that is no goal.
struct Evaluator<'a> {
    terms: &'a Terms,
    pre: &'a View,
    post: &'a View,
    pair: PairId,
    meanings: &'a mut FxHashMap<ConstantId, Option<Meaning>>,
    referents: &'a mut FxHashMap<(TermId, PairId), Option<u8>>,
    steps: u32,
}

impl<'a> Evaluator<'a> {
    fn view(&self, side: Side) -> &'a View {
        if side == Side::Pre { self.pre } else { self.post }
    }

    fn meaning(&mut self, term: TermId) -> Option<(Meaning, &'a [TermId])> {
        let terms = self.terms;
        let args = match terms.node(term) {
            Node::Apply { args, .. } => args,
            _ => &[],
        };
        let constant = terms.head_constant(term)?;
        let known = self.meanings.entry(constant).or_insert_with(|| {
            let predicate = predicate(terms.name(constant))?;
            let ty = terms.types.print(terms.constant_ty(constant));
            (ty == predicate.ty).then_some(predicate.meaning)
        });
        Some(((*known)?, args))
    }

    fn truth(&mut self, term: TermId, side: Side, env: &mut Env) -> Option<bool> {
        self.steps += 1;
        if self.steps > MAX_STEPS {
            return None;
        }
        Some(match self.meaning(term)? {
            (Meaning::True, _) => true,
            (Meaning::False, _) => false,
            (Meaning::And, all) => {
                let mut truth = true;
                for &arg in all {
                    truth &= self.truth(arg, side, env)?;
                }
                truth
            }
            (Meaning::Or, any) => {
                let mut truth = false;
                for &arg in any {
                    truth |= self.truth(arg, side, env)?;
                }
                truth
            }
            (Meaning::Not, &[arg]) => !self.truth(arg, side, env)?,
            (Meaning::Exists, &[property]) => self.extension(property, side, env)? != 0,
            (Meaning::Property(property), &[of]) => {
                let of = self.referent(of, env)?;
                of.is_some_and(|of| self.view(side).property(property) & bit(of) != 0)
            }
            (Meaning::Relation(relation), &[a, b]) => {
                match (self.referent(a, env)?, self.referent(b, env)?) {
                    (Some(a), Some(b)) => self.view(side).from(relation, a) & bit(b) != 0,
                    _ => false,
                }
            }
            _ => return None,
        })
    }

    /// The entities of one state of which a term of type `<e,t>` holds.
    fn extension(&mut self, term: TermId, side: Side, env: &mut Env) -> Option<Bits> {
        match self.terms.node(term) {
            Node::Lambda { body, .. } => Some(self.set(body, side, env)? & self.view(side).present),
            _ => None,
        }
    }

    /// The entities that variable 0 may stand for to make `body` true; the others are in `env`. Entities
    /// that the state lacks may be in it too.
    fn set(&mut self, body: TermId, side: Side, env: &mut Env) -> Option<Bits> {
        let all_or_none = |truth: bool| if truth { Bits::MAX } else { 0 };
        let view = self.view(side);
        Some(match self.meaning(body)? {
            (Meaning::True, _) => Bits::MAX,
            (Meaning::False, _) => 0,
            (Meaning::And, all) => {
                let mut set = Bits::MAX;
                for &arg in all {
                    set &= self.set(arg, side, env)?;
                }
                set
            }
            (Meaning::Or, any) => {
                let mut set = 0;
                for &arg in any {
                    set |= self.set(arg, side, env)?;
                }
                set
            }
            (Meaning::Not, &[arg]) => !self.set(arg, side, env)?,
            (Meaning::Property(property), &[of]) => match self.argument(of, env)? {
                Argument::Own => view.property(property),
                Argument::Fixed(of) => {
                    all_or_none(of.is_some_and(|of| view.property(property) & bit(of) != 0))
                }
                Argument::Dependent => self.one_by_one(body, side, env)?,
            },
            (Meaning::Relation(relation), &[a, b]) => {
                match (self.argument(a, env)?, self.argument(b, env)?) {
                    (Argument::Own, Argument::Fixed(b)) => b.map_or(0, |b| view.to(relation, b)),
                    (Argument::Fixed(a), Argument::Own) => a.map_or(0, |a| view.from(relation, a)),
                    (Argument::Fixed(a), Argument::Fixed(b)) => all_or_none(
                        a.zip(b).is_some_and(|(a, b)| view.from(relation, a) & bit(b) != 0),
                    ),
                    _ => self.one_by_one(body, side, env)?,
                }
            }
            (Meaning::Exists, _) => self.one_by_one(body, side, env)?,
            _ => return None,
        })
    }

    fn one_by_one(&mut self, body: TermId, side: Side, env: &mut Env) -> Option<Bits> {
        let mut set = 0;
        for at in members(self.view(side).present) {
            env.push(Some(at));
            let truth = self.truth(body, side, env);
            env.pop();
            set |= if truth? { bit(at) } else { 0 };
        }
        Some(set)
    }

    fn argument(&mut self, term: TermId, env: &mut Env) -> Option<Argument> {
        Some(match self.terms.node(term) {
            Node::Variable(0) => Argument::Own,
            Node::Variable(index) => Argument::Fixed(lookup(env, index - 1)),
            _ if self.terms.free(term) == 0 => Argument::Fixed(self.referent(term, env)?),
            _ => Argument::Dependent,
        })
    }

    /// What a term of type `e` refers to before; the inner `None` when nothing.
    fn referent(&mut self, term: TermId, env: &mut Env) -> Option<Option<usize>> {
        if let Node::Variable(index) = self.terms.node(term) {
            return Some(lookup(env, index));
        }
        if self.terms.free(term) > 0 {
            return self.determine(term, env);
        }
        if let Some(&known) = self.referents.get(&(term, self.pair)) {
            return Some(known.map(usize::from));
        }
        let found = self.determine(term, &mut Vec::new())?;
        let small = found.and_then(|at| u8::try_from(at).ok());
        self.referents.insert((term, self.pair), small);
        Some(found)
    }

    fn determine(&mut self, term: TermId, env: &mut Env) -> Option<Option<usize>> {
        let (meaning, args) = self.meaning(term)?;
        let mut candidates = self.extension(*args.first()?, Side::Pre, env)?;
        let sign = match meaning {
            Meaning::The if candidates.count_ones() == 1 => {
                return Some(members(candidates).next());
            }
            Meaning::The => return Some(None),
            Meaning::Argmax => 1,
            Meaning::Argmin => -1,
            _ => return None,
        };
        if sign > 0
            && let Node::Lambda { body, .. } = self.terms.node(*args.get(1)?)
            && let (Meaning::Measure(Measure::Shade(_)), _) = self.meaning(body)?
        {
            // Only what is like the shade at all can be the most like it, and that may be a single thing.
            for at in members(candidates) {
                env.push(Some(at));
                let value = self.number(body, env);
                env.pop();
                if value?.is_none_or(|value| value <= 0) {
                    candidates &= !(1 << at);
                }
            }
            if candidates.count_ones() == 1 {
                return Some(members(candidates).next());
            }
        }
        let classes = [Class::Agent, Class::Room, Class::Door, Class::Object];
        let one_class = classes
            .iter()
            .any(|class| candidates & !self.pre.property(Property::Class(*class)) == 0);
        if candidates.count_ones() < 2 || !one_class {
            return Some(None);
        }
        let Node::Lambda { body, .. } = self.terms.node(*args.get(1)?) else { return None };
        let (mut best, mut most, mut tie) = (None, i64::MIN, false);
        for at in members(candidates) {
            env.push(Some(at));
            let value = self.number(body, env);
            env.pop();
            let Some(value) = value? else { return Some(None) };
            let value = sign * value;
            tie = value == most || (tie && value < most);
            if value > most {
                (best, most) = (Some(at), value);
            }
        }
        Some(best.filter(|_| !tie))
    }

    fn number(&mut self, term: TermId, env: &mut Env) -> Option<Option<i64>> {
        match self.meaning(term)? {
            (Meaning::Measure(measure), &[of]) => {
                let of = self.referent(of, env)?;
                Some(of.and_then(|of| self.pre.number(measure, of)))
            }
            _ => None,
        }
    }
}

/// What an argument is to the variable at hand.
enum Argument {
    /// The variable itself.
    Own,
    /// The same whatever the variable stands for; `None` when it does not refer.
    Fixed(Option<usize>),
    /// A phrase that hangs on the variable.
    Dependent,
}
