//! Validation-driven learning's question (Artzi and Zettlemoyer 2013): does every demonstration show a form? A pair does
//! if it is false before and true after. A run does if the whole of it satisfies the form, no beginning of it does, and
//! no contrast, nor a beginning of one (www/guide/time.md). Properties and relations are bitsets over the entities;
//! phrases are looked up by term, answers by term and demonstration. Agrees with [`Goal`] and
//! [`Course`](super::Course) on every term.

use super::class::Class;
use super::denote::{Env, lookup};
use super::goal::Goal;
use super::outline::{Outline, Part, Valuation};
use super::predicate::{Meaning, Measure, Property, predicate};
use super::run::Beginnings;
use super::stretch::Stretch;
use super::view::{Bits, View, bit, compile, members};
use crate::domain::{State, Way};
use crate::logic::ty::{ENTITY, RUN, TRUTH};
use crate::logic::{ConstantId, Node, TermId, Terms};
use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::rc::Rc;

/// Evaluations of open terms that one answer may take.
const MAX_STEPS: u32 = 1_000_000;
/// Runs whose states are kept compiled: those of the command at work, and some more.
const MOST_OPEN: usize = 48;
/// The view that binds phrases.
const FIRST: usize = 0;

/// A demonstration that the validator knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PairId(u32);

/// What was shown.
type Shown = (State, State, Option<Way>);

/// A validator for the terms of one arena. Equal pairs are compiled once, runs when they are asked of.
#[derive(Debug, Default)]
pub struct Validator {
    shown: IndexSet<Shown, FxBuildHasher>,
    /// The two views of each pair; `None` when it has too many entities, and for runs.
    views: Vec<Option<Vec<View>>>,
    /// Compiled runs, the last one used at the end.
    open: Vec<(PairId, Rc<Stretch>)>,
    outlines: FxHashMap<TermId, Option<Rc<Outline>>>,
    meanings: FxHashMap<ConstantId, Option<Meaning>>,
    /// The referents of closed phrases in the state before.
    referents: FxHashMap<(TermId, PairId), Option<u8>>,
    answers: FxHashMap<(TermId, PairId), bool>,
    /// In which of its states a goal holds, a bit each; `None` where it is none.
    guards: FxHashMap<(TermId, PairId), Option<Rc<[u64]>>>,
}

impl Validator {
    /// A validator that knows no demonstration.
    pub fn new() -> Self {
        Validator::default()
    }

    /// Compiles a pair of states, or finds it again.
    pub fn pair(&mut self, pre: &State, post: &State) -> PairId {
        self.shown(pre, post, None)
    }

    /// Takes in a demonstration, or finds it again: a pair of states, and how one came to the other if that is known.
    pub fn shown(&mut self, pre: &State, post: &State, way: Option<&Way>) -> PairId {
        let (at, new) = self.shown.insert_full((pre.clone(), post.clone(), way.cloned()));
        if new {
            let pair = way.is_none().then(|| compile([pre, post]));
            self.views.push(pair.flatten());
        }
        PairId(u32::try_from(at).unwrap_or(u32::MAX))
    }

    /// The state before a demonstration.
    pub fn pre(&self, pair: PairId) -> Option<&State> {
        self.shown.get_index(pair.0 as usize).map(|(pre, ..)| pre)
    }

    /// Whether each of the demonstrations shows a term, its phrases bound before. None shows a term that is no goal and
    /// no task, and without demonstrations nothing is shown.
    pub fn valid(&mut self, terms: &Terms, term: TermId, pairs: &[PairId]) -> bool {
        !pairs.is_empty() && pairs.iter().all(|&pair| self.valid_on(terms, term, pair))
    }

    fn valid_on(&mut self, terms: &Terms, term: TermId, pair: PairId) -> bool {
        if let Some(&known) = self.answers.get(&(term, pair)) {
            return known;
        }
        let answer = match self.is_run(pair) {
            true => self.valid_on_run(terms, term, pair).unwrap_or(false),
            false => self.valid_on_pair(terms, term, pair),
        };
        self.answers.insert((term, pair), answer);
        answer
    }

    /// A pair shows a task over time that is to reach a goal, and no other.
    fn valid_on_pair(&mut self, terms: &Terms, term: TermId, pair: PairId) -> bool {
        let reached = if terms.ty(term) == RUN { self.reached(terms, term) } else { Some(term) };
        reached.is_some_and(|goal| {
            self.holds(terms, goal, pair, Side::Pre) == Some(false)
                && self.holds(terms, goal, pair, Side::Post) == Some(true)
        })
    }

    fn reached(&mut self, terms: &Terms, term: TermId) -> Option<TermId> {
        let outline = self.outline(terms, term)?;
        match *outline.parts() {
            [Part::Done, Part::Until { hold, reach, then: 0 }]
                if outline.guards()[hold] == terms.truth() =>
            {
                Some(outline.guards()[reach])
            }
            _ => None,
        }
    }

    fn valid_on_run(&mut self, terms: &Terms, term: TermId, pair: PairId) -> Option<bool> {
        let outline = self.outline(terms, term)?;
        let stretch = self.stretch(pair)?;
        let mut guards = Vec::with_capacity(outline.guards().len());
        for &guard in outline.guards() {
            guards.push(self.guard(terms, guard, pair)?);
        }
        let so = |state: usize| -> Valuation {
            let is_so = |guard: &Rc<[u64]>| guard[state / 64] >> (state % 64) & 1;
            guards.iter().enumerate().fold(0, |all, (at, guard)| all | is_so(guard) << at)
        };
        let so: Vec<Valuation> = (0..stretch.len()).map(so).collect();
        let first = |way: &[u16]| {
            let way: Vec<Valuation> = way.iter().map(|&state| so[usize::from(state)]).collect();
            Beginnings::of(&outline, &way).first()
        };
        let (run, contrasts) = stretch.ways().split_first()?;
        let is_shown = first(run) == Some(run.len() - 1);
        Some(is_shown && contrasts.iter().all(|contrast| first(contrast).is_none()))
    }

    fn outline(&mut self, terms: &Terms, term: TermId) -> Option<Rc<Outline>> {
        let known = self.outlines.entry(term);
        known.or_insert_with(|| Outline::new(terms, term).ok().map(Rc::new)).clone()
    }

    /// Whether a demonstration is a run: it is known how one state came to the other.
    pub fn is_run(&self, pair: PairId) -> bool {
        self.shown.get_index(pair.0 as usize).is_some_and(|(.., way)| way.is_some())
    }

    /// The states of a run; `None` for a pair.
    fn stretch(&mut self, pair: PairId) -> Option<Rc<Stretch>> {
        let known = self.open.iter().rposition(|(known, _)| *known == pair);
        let stretch = match known {
            Some(at) => return Some(Rc::clone(&self.open[at].1)),
            None => {
                let (start, _, way) = self.shown.get_index(pair.0 as usize)?;
                Rc::new(Stretch::of(start, way.as_ref()?)?)
            }
        };
        if self.open.len() == MOST_OPEN {
            self.open.remove(0);
        }
        self.open.push((pair, Rc::clone(&stretch)));
        Some(stretch)
    }

    /// In which states of a run a goal holds.
    fn guard(&mut self, terms: &Terms, goal: TermId, pair: PairId) -> Option<Rc<[u64]>> {
        if let Some(known) = self.guards.get(&(goal, pair)) {
            return known.clone();
        }
        let stretch = self.stretch(pair)?;
        let mut holds = vec![0; stretch.len().div_ceil(64)];
        let mut is_goal = true;
        for at in 0..stretch.len() {
            match self.holds_at(terms, goal, pair, &stretch, at) {
                Some(true) => holds[at / 64] |= 1 << (at % 64),
                Some(false) => {}
                None => is_goal = false,
            }
        }
        let holds: Option<Rc<[u64]>> = is_goal.then(|| holds.into());
        self.guards.insert((goal, pair), holds.clone());
        holds
    }

    fn holds_at(
        &mut self,
        terms: &Terms,
        goal: TermId,
        pair: PairId,
        stretch: &Stretch,
        at: usize,
    ) -> Option<bool> {
        match stretch.views() {
            Some(views) => self.truth(terms, goal, (pair, views), at),
            None => {
                let states = stretch.states();
                let goal = Goal::new(terms, goal, states.first()?).ok()?;
                Some(goal.holds(states.get_index(at)?))
            }
        }
    }

    /// Whether a goal holds in the first or the last state of a demonstration; `None` for a term that is no goal.
    pub fn holds(&mut self, terms: &Terms, term: TermId, pair: PairId, side: Side) -> Option<bool> {
        if let Some(stretch) = self.stretch(pair) {
            let last = usize::from(*stretch.ways().first()?.last()?);
            let at = if side == Side::Pre { FIRST } else { last };
            return self.holds_at(terms, term, pair, &stretch, at);
        }
        let Some(views) = self.views.get_mut(pair.0 as usize)?.take() else {
            let (pre, post, _) = self.shown.get_index(pair.0 as usize)?;
            let goal = Goal::new(terms, term, pre).ok()?;
            return Some(goal.holds(if side == Side::Pre { pre } else { post }));
        };
        let at = if side == Side::Pre { FIRST } else { 1 };
        let truth = self.truth(terms, term, (pair, &views), at);
        self.views[pair.0 as usize] = Some(views);
        truth
    }

    fn truth(
        &mut self,
        terms: &Terms,
        goal: TermId,
        (pair, views): (PairId, &[View]),
        at: usize,
    ) -> Option<bool> {
        if terms.ty(goal) != TRUTH || terms.free(goal) > 0 {
            return None;
        }
        let Validator { meanings, referents, .. } = self;
        let mut evaluator = Evaluator { terms, views, pair, meanings, referents, steps: 0 };
        evaluator.truth(goal, at, &mut Vec::new())
    }

    /// Whether a phrase can be part of what was meant: a closed term of type `e` refers before each of the pairs,
    /// a property is something's. Other terms always can.
    pub fn denotes(&mut self, terms: &Terms, term: TermId, pairs: &[PairId]) -> bool {
        pairs.iter().all(|&pair| self.denotes_in(terms, term, pair).unwrap_or(true))
    }

    fn denotes_in(&mut self, terms: &Terms, term: TermId, pair: PairId) -> Option<bool> {
        let stretch = self.stretch(pair);
        let Validator { views, meanings, referents, .. } = self;
        let views = match &stretch {
            Some(stretch) => stretch.views()?,
            None => views.get(pair.0 as usize)?.as_ref()?,
        };
        let mut evaluator = Evaluator { terms, views, pair, meanings, referents, steps: 0 };
        if terms.ty(term) == ENTITY {
            Some(evaluator.referent(term, &mut Vec::new())?.is_some())
        } else {
            Some(evaluator.extension(term, FIRST, &mut Vec::new())? != 0)
        }
    }
}

/// The first or the last state of a demonstration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "before and after")]
pub enum Side {
    Pre,
    Post,
}

/// A term at work on one pair. `None` stands for a term that is no goal.
struct Evaluator<'a> {
    terms: &'a Terms,
    /// The states of the demonstration, the first of which binds phrases.
    views: &'a [View],
    pair: PairId,
    meanings: &'a mut FxHashMap<ConstantId, Option<Meaning>>,
    referents: &'a mut FxHashMap<(TermId, PairId), Option<u8>>,
    steps: u32,
}

impl<'a> Evaluator<'a> {
    fn view(&self, state: usize) -> &'a View {
        &self.views[state]
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

    fn truth(&mut self, term: TermId, state: usize, env: &mut Env) -> Option<bool> {
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
                    truth &= self.truth(arg, state, env)?;
                }
                truth
            }
            (Meaning::Or, any) => {
                let mut truth = false;
                for &arg in any {
                    truth |= self.truth(arg, state, env)?;
                }
                truth
            }
            (Meaning::Not, &[arg]) => !self.truth(arg, state, env)?,
            (Meaning::Exists, &[property]) => self.extension(property, state, env)? != 0,
            (Meaning::Property(property), &[of]) => {
                let of = self.referent(of, env)?;
                of.is_some_and(|of| self.view(state).property(property) & bit(of) != 0)
            }
            (Meaning::Relation(relation), &[a, b]) => {
                match (self.referent(a, env)?, self.referent(b, env)?) {
                    (Some(a), Some(b)) => self.view(state).from(relation, a) & bit(b) != 0,
                    _ => false,
                }
            }
            _ => return None,
        })
    }

    /// The entities of one state of which a term of type `<e,t>` holds.
    fn extension(&mut self, term: TermId, state: usize, env: &mut Env) -> Option<Bits> {
        match self.terms.node(term) {
            Node::Lambda { body, .. } => {
                Some(self.set(body, state, env)? & self.view(state).present)
            }
            _ => None,
        }
    }

    /// The entities that variable 0 may stand for to make `body` true; the others are in `env`. Entities
    /// that the state lacks may be in it too.
    fn set(&mut self, body: TermId, state: usize, env: &mut Env) -> Option<Bits> {
        let all_or_none = |truth: bool| if truth { Bits::MAX } else { 0 };
        let view = self.view(state);
        Some(match self.meaning(body)? {
            (Meaning::True, _) => Bits::MAX,
            (Meaning::False, _) => 0,
            (Meaning::And, all) => {
                let mut set = Bits::MAX;
                for &arg in all {
                    set &= self.set(arg, state, env)?;
                }
                set
            }
            (Meaning::Or, any) => {
                let mut set = 0;
                for &arg in any {
                    set |= self.set(arg, state, env)?;
                }
                set
            }
            (Meaning::Not, &[arg]) => !self.set(arg, state, env)?,
            (Meaning::Property(property), &[of]) => match self.argument(of, env)? {
                Argument::Own => view.property(property),
                Argument::Fixed(of) => {
                    all_or_none(of.is_some_and(|of| view.property(property) & bit(of) != 0))
                }
                Argument::Dependent => self.one_by_one(body, state, env)?,
            },
            (Meaning::Relation(relation), &[a, b]) => {
                match (self.argument(a, env)?, self.argument(b, env)?) {
                    (Argument::Own, Argument::Fixed(b)) => b.map_or(0, |b| view.to(relation, b)),
                    (Argument::Fixed(a), Argument::Own) => a.map_or(0, |a| view.from(relation, a)),
                    (Argument::Fixed(a), Argument::Fixed(b)) => all_or_none(
                        a.zip(b).is_some_and(|(a, b)| view.from(relation, a) & bit(b) != 0),
                    ),
                    _ => self.one_by_one(body, state, env)?,
                }
            }
            (Meaning::Exists, _) => self.one_by_one(body, state, env)?,
            _ => return None,
        })
    }

    fn one_by_one(&mut self, body: TermId, state: usize, env: &mut Env) -> Option<Bits> {
        let mut set = 0;
        for at in members(self.view(state).present) {
            env.push(Some(at));
            let truth = self.truth(body, state, env);
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
        let mut candidates = self.extension(*args.first()?, FIRST, env)?;
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
            .any(|class| candidates & !self.view(FIRST).property(Property::Class(*class)) == 0);
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
                Some(of.and_then(|of| self.view(FIRST).number(measure, of)))
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
