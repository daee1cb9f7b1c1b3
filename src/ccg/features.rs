//! Features and their weights. A key is interned to a dense index; weights lie in one array beside the keys.
//! Scales are the reference's (Williams et al.; METHOD in the guide): they say how much one occurrence counts.

use super::combinator::RuleId;
use super::lexicon::{EntryId, LexemeId, TemplateId};
use crate::logic::order;
use crate::logic::{ConstantId, Node, Sorts, TermId, Terms, ty};
use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};

/// What a parse can be scored by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Feature {
    /// A lexeme is used.
    Lexeme(LexemeId),
    /// A template is used.
    Template(TemplateId),
    /// A lexeme is used in this template.
    Entry(EntryId),
    /// A rule is used.
    Rule(RuleId),
    /// A word is skipped.
    Skip,
    /// A word goes without meaning although the lexicon has constants for it.
    Dropped,
    /// A step leaves out a predicate that words brought in: an afterthought, a clause that sets no goal.
    Lost,
    /// A word is taken for another that a general resource has it near: once a step.
    Far,
    /// A word is taken for a measure, such as a shade.
    Measure,
    /// Two different predicates occur anywhere in the goal (Williams et al., Section IV-B-1: it tells `in` from
    /// `near` when the words do not). The first name is the smaller.
    Pair(ConstantId, ConstantId),
    /// Two predicates are conjoined on one argument. The first name is the smaller.
    Conjoined(ConstantId, ConstantId),
    /// A phrase says nothing of what it stands for but this.
    Alone(ConstantId),
    /// A relation has an argument, counted from 0, with this head noun.
    Head(ConstantId, u8, ConstantId),
    /// A relation's two arguments have these head nouns.
    Heads(ConstantId, ConstantId),
    /// What is to be so first is said of something with this head noun, and what is next of one with that; or the places
    /// have these.
    Then(ConstantId, ConstantId),
    /// Of one thing a relation is said twice, to be so at once: a thing is seldom in two places.
    Twice(ConstantId),
    /// Of one thing two adjectives are said, to be so at once: a thing seldom has two colours.
    Adjectives,
}

impl Feature {
    /// Whether training moves its weight. What is said is meant, in any corpus: what it costs to leave words out
    /// is a price set once, else what the trained tasks can do without is left out of those never seen.
    pub fn is_learned(self) -> bool {
        !matches!(
            self,
            Feature::Skip | Feature::Dropped | Feature::Lost | Feature::Far | Feature::Measure
        )
    }

    /// Its kind, if learning can do without it.
    pub fn kind(self) -> Option<Kind> {
        Some(match self {
            Feature::Lexeme(_) => Kind::Lexeme,
            Feature::Template(_) => Kind::Template,
            Feature::Entry(_) => Kind::Entry,
            Feature::Rule(_) => Kind::Rule,
            Feature::Pair(..) => Kind::Pair,
            Feature::Conjoined(..) | Feature::Adjectives => Kind::Conjoined,
            Feature::Alone(_) => Kind::Alone,
            Feature::Head(..) | Feature::Heads(..) | Feature::Then(..) | Feature::Twice(_) => {
                Kind::Head
            }
            Feature::Skip | Feature::Dropped | Feature::Lost | Feature::Far | Feature::Measure => {
                return None;
            }
        })
    }

    /// How much one occurrence counts.
    pub fn scale(self) -> f64 {
        match self {
            Feature::Template(_) => 0.1,
            // What goals are usually about says little of the next one: the words are to decide.
            Feature::Pair(..) | Feature::Head(..) | Feature::Heads(..) => 0.2,
            Feature::Rule(_) => 0.5,
            Feature::Lexeme(_)
            | Feature::Entry(_)
            | Feature::Skip
            | Feature::Dropped
            | Feature::Lost
            | Feature::Far
            | Feature::Measure
            | Feature::Conjoined(..)
            | Feature::Alone(_)
            | Feature::Then(..)
            | Feature::Twice(_)
            | Feature::Adjectives => 1.0,
        }
    }
}

/// A kind of features that learning can do without, to see what they are good for. What it costs to leave words out is
/// none: without it nothing would be said.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "as of `Feature`; all of heads are one")]
pub enum Kind {
    Lexeme,
    Template,
    Entry,
    Rule,
    Pair,
    Conjoined,
    Alone,
    Head,
}

impl Kind {
    /// All kinds, by name.
    pub const ALL: [(&'static str, Kind); 8] = [
        ("lexeme", Kind::Lexeme),
        ("template", Kind::Template),
        ("entry", Kind::Entry),
        ("rule", Kind::Rule),
        ("pair", Kind::Pair),
        ("conjoined", Kind::Conjoined),
        ("alone", Kind::Alone),
        ("head", Kind::Head),
    ];

    /// The kind of this name.
    pub fn named(name: &str) -> Option<Kind> {
        Kind::ALL.iter().find(|(known, _)| *known == name).map(|(_, kind)| *kind)
    }

    /// The name.
    pub fn name(self) -> &'static str {
        Kind::ALL.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }
}

/// Some kinds of features.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kinds(u8);

impl Kinds {
    /// None.
    pub const NONE: Kinds = Kinds(0);

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether a feature is of one of them.
    pub fn has(self, feature: Feature) -> bool {
        self.0 != 0 && feature.kind().is_some_and(|kind| self.0 & 1 << kind as u8 != 0)
    }

    /// The kinds, in their order.
    pub fn iter(self) -> impl Iterator<Item = Kind> {
        let kinds = Kind::ALL.into_iter().map(|(_, kind)| kind);
        kinds.filter(move |&kind| self.0 & 1 << kind as u8 != 0)
    }
}

impl FromIterator<Kind> for Kinds {
    fn from_iter<T: IntoIterator<Item = Kind>>(kinds: T) -> Kinds {
        Kinds(kinds.into_iter().fold(0, |bits, kind| bits | 1 << kind as u8))
    }
}

/// An interned feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FeatureId(u32);

/// φ: scaled counts by feature, in the features' order, so that sums run in one order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vector(Vec<(FeatureId, f64)>);

impl Vector {
    /// Features and their counts, in order, each once.
    pub fn iter(&self) -> impl Iterator<Item = (FeatureId, f64)> {
        self.0.iter().copied()
    }
}

/// Interned features with their weights θ, in the order they were first seen. While training, each weight has a
/// drift beside it: the sum of its changes, each times the moment it was made. What the weight was on average
/// follows from both (Freund and Schapire 1999; the bookkeeping is Daumé's).
#[derive(Clone, Debug, Default)]
pub struct Features {
    index: FxHashMap<Feature, FeatureId>,
    keys: Vec<Feature>,
    weights: Vec<f64>,
    drifts: Vec<f64>,
}

impl Features {
    /// The id of a feature; a new one has weight 0.
    pub fn intern(&mut self, feature: Feature) -> FeatureId {
        let next = FeatureId(self.keys.len() as u32);
        *self.index.entry(feature).or_insert_with(|| {
            self.keys.push(feature);
            self.weights.push(0.0);
            self.drifts.push(0.0);
            next
        })
    }

    /// The id of a feature, if it has one.
    pub(super) fn id(&self, feature: Feature) -> Option<FeatureId> {
        self.index.get(&feature).copied()
    }

    /// The weight of a feature by its id.
    pub(super) fn weight_at(&self, id: FeatureId) -> f64 {
        self.weights[id.0 as usize]
    }

    /// What one occurrence of the feature adds to a score: its weight times its scale.
    pub fn value(&self, feature: Feature) -> f64 {
        self.index.get(&feature).map_or(0.0, |&id| self.weights[id.0 as usize] * feature.scale())
    }

    /// The feature behind an id.
    pub fn feature(&self, id: FeatureId) -> Feature {
        self.keys[id.0 as usize]
    }

    /// Sets the weights of some kinds to 0.
    pub fn silence(&mut self, kinds: Kinds) {
        for (&key, weight) in self.keys.iter().zip(&mut self.weights) {
            if kinds.has(key) {
                *weight = 0.0;
            }
        }
    }

    /// The weight of a feature, 0 for one never seen.
    pub fn weight(&self, feature: Feature) -> f64 {
        self.index.get(&feature).map_or(0.0, |&id| self.weights[id.0 as usize])
    }

    /// Sets a weight.
    pub fn set(&mut self, feature: Feature, weight: f64) {
        let id = self.intern(feature);
        self.weights[id.0 as usize] = weight;
    }

    /// Sets a drift.
    pub fn set_drift(&mut self, feature: Feature, drift: f64) {
        let id = self.intern(feature);
        self.drifts[id.0 as usize] = drift;
    }

    /// θ += `by` · φ, at a moment counted from 0.
    pub fn add(&mut self, vector: &Vector, by: f64, moment: f64) {
        self.add_where(vector, by, moment, |_| true);
    }

    /// The same for those features alone that `moves` holds of.
    pub fn add_where(
        &mut self,
        vector: &Vector,
        by: f64,
        moment: f64,
        moves: impl Fn(Feature) -> bool,
    ) {
        for (id, value) in vector.iter().filter(|(id, _)| moves(self.keys[id.0 as usize])) {
            self.weights[id.0 as usize] += by * value;
            self.drifts[id.0 as usize] += moment * by * value;
        }
    }

    /// Replaces every weight by its mean over so many moments, and forgets the drifts.
    pub fn average(&mut self, moments: f64) {
        for (weight, drift) in self.weights.iter_mut().zip(&mut self.drifts) {
            *weight -= *drift / moments;
            *drift = 0.0;
        }
    }

    /// θ · φ, summed in the features' order.
    pub fn dot(&self, vector: &Vector) -> f64 {
        vector.iter().fold(0.0, |sum, (id, value)| sum + self.weights[id.0 as usize] * value)
    }

    /// φ of what occurs, each feature as often as it does.
    pub fn vector(&mut self, occurring: &[Feature]) -> Vector {
        let mut counts: Vec<(FeatureId, f64)> =
            occurring.iter().map(|&feature| (self.intern(feature), feature.scale())).collect();
        order::sort_by_key(&mut counts, |&(id, _)| id);
        counts.dedup_by(|(next, more), (id, count)| {
            let same = next == id;
            *count += if same { *more } else { 0.0 };
            same
        });
        Vector(counts)
    }

    /// All features with weight and drift, in order. Order is kept even for weights of 0: sums run in it.
    pub fn iter(&self) -> impl Iterator<Item = (Feature, f64, f64)> {
        let values = self.weights.iter().zip(&self.drifts);
        self.keys.iter().zip(values).map(|(&key, (&weight, &drift))| (key, weight, drift))
    }
}

/// The features of a goal as a whole.
pub fn root_features(terms: &Terms, sorts: &Sorts, form: TermId) -> Vec<Feature> {
    let mut found = Occurring { terms, sorts, predicates: Vec::new(), features: Vec::new() };
    found.collect(form);
    let Occurring { mut predicates, mut features, .. } = found;
    terms.sort_by_name(&mut predicates);
    predicates.dedup();
    for (place, &first) in predicates.iter().enumerate() {
        features.extend(predicates[place + 1..].iter().map(|&second| Feature::Pair(first, second)));
    }
    features
}

/// What a goal is seen to be made of.
struct Occurring<'a> {
    terms: &'a Terms,
    sorts: &'a Sorts,
    /// Every constant that is applied to entities; connectives, quantifiers and determiners are none.
    predicates: Vec<ConstantId>,
    features: Vec<Feature>,
}

impl Occurring<'_> {
    fn collect(&mut self, term: TermId) {
        match self.terms.node(term) {
            Node::Constant(_) | Node::Variable(_) => {}
            Node::Lambda { body, .. } => {
                self.collect_conjoined(body);
                self.collect(body);
            }
            Node::Apply { head, args } => {
                if let Node::Constant(constant) = self.terms.node(head)
                    && args.iter().all(|&arg| self.terms.ty(arg) == ty::ENTITY)
                {
                    self.predicates.push(constant);
                    self.collect_heads(constant, args);
                }
                if let &[_, reach, then] = args
                    && self.terms.ty(term) == ty::RUN
                {
                    let steps = [reach, then].map(|step| self.first(step));
                    self.features.extend((0..2).filter_map(|place| {
                        let [first, next] = steps.map(|step| step[place]);
                        Some(Feature::Then(first?, next?))
                    }));
                }
                if self.is_and(head) {
                    self.collect_twice(args);
                }
                args.iter().for_each(|&arg| self.collect(arg));
            }
        }
    }

    /// What some conjuncts say of one thing that one of those before says of it, too.
    fn collect_twice(&mut self, conjuncts: &[TermId]) {
        let all: Vec<(ConstantId, TermId)> =
            conjuncts.iter().filter_map(|&part| self.relation_of(part)).collect();
        let twice = all.iter().enumerate().filter(|(at, one)| all[..*at].contains(one));
        self.features.extend(twice.map(|(_, &(relation, _))| Feature::Twice(relation)));
    }

    /// What a conjunct says of which thing, if it says one relation of it: either way, where it is an alternative.
    fn relation_of(&self, conjunct: TermId) -> Option<(ConstantId, TermId)> {
        let Node::Apply { head, args } = self.terms.node(conjunct) else { return None };
        let Node::Constant(relation) = self.terms.node(head) else { return None };
        match *args {
            [thing, _] if self.terms.ty(thing) == ty::ENTITY => Some((relation, thing)),
            [first, ref others @ ..] if self.terms.name(relation) == "or" => {
                let said = self.relation_of(first)?;
                others.iter().all(|&part| self.relation_of(part) == Some(said)).then_some(said)
            }
            _ => None,
        }
    }

    /// The pairs of predicates in a conjunction, each on what the conjunction is about.
    fn collect_conjoined(&mut self, body: TermId) {
        let mut predicates = self.conjuncts(body);
        self.terms.sort_by_name(&mut predicates);
        if let [only] = predicates[..] {
            self.features.push(Feature::Alone(only));
        }
        for (place, &first) in predicates.iter().enumerate() {
            let pairs = predicates[place + 1..].iter().map(|&b| Feature::Conjoined(first, b));
            self.features.extend(pairs);
        }
        predicates.dedup();
        let adjectives =
            predicates.iter().filter(|&&one| self.sorts.is_quality(self.terms.name(one))).count();
        self.features.extend((1..adjectives).map(|_| Feature::Adjectives));
    }

    /// The predicates that are claimed of the innermost variable.
    fn conjuncts(&self, body: TermId) -> Vec<ConstantId> {
        let about = |term: &TermId| {
            let Node::Apply { head, args } = self.terms.node(*term) else { return None };
            let own = args.iter().any(|&arg| self.terms.node(arg) == Node::Variable(0));
            match self.terms.node(head) {
                Node::Constant(constant) if own => Some(constant),
                _ => None,
            }
        };
        match self.terms.node(body) {
            Node::Apply { head, args } if self.is_and(head) => {
                args.iter().filter_map(about).collect()
            }
            _ => about(&body).into_iter().collect(),
        }
    }

    fn is_and(&self, head: TermId) -> bool {
        matches!(self.terms.node(head), Node::Constant(c) if self.terms.name(c) == "and")
    }

    fn collect_heads(&mut self, relation: ConstantId, args: &[TermId]) {
        if args.len() < 2 {
            return;
        }
        let heads: Vec<Option<ConstantId>> = args.iter().map(|&arg| self.head(arg)).collect();
        let places = (0..).zip(&heads);
        let features =
            places.filter_map(|(place, &head)| Some(Feature::Head(relation, place, head?)));
        self.features.extend(features);
        if let [Some(a), Some(b)] = heads[..] {
            self.features.push(Feature::Heads(a, b));
        }
    }

    /// The nouns of what a goal, or the first step of a task, is said of, and of the place that it is to be in.
    fn first(&self, term: TermId) -> [Option<ConstantId>; 2] {
        let Node::Apply { args, .. } = self.terms.node(term) else { return [None; 2] };
        match *args {
            [_, reach, _] if self.terms.ty(term) == ty::RUN => self.first(reach),
            // What begins to be forbidden after a step is no next step.
            _ if self.terms.ty(term) == ty::RUN => [None; 2],
            [thing, place] if self.terms.ty(thing) == ty::ENTITY => {
                [thing, place].map(|phrase| self.head(phrase))
            }
            _ => {
                let parts = args.iter().map(|&arg| self.first(arg));
                parts.fold([None; 2], |found, part| [0, 1].map(|at| found[at].or(part[at])))
            }
        }
    }

    /// The noun of a phrase.
    fn head(&self, phrase: TermId) -> Option<ConstantId> {
        let Node::Apply { args, .. } = self.terms.node(phrase) else { return None };
        let Node::Lambda { body, .. } = self.terms.node(*args.first()?) else { return None };
        let is_noun = |c: &ConstantId| self.sorts.is_noun(self.terms.name(*c));
        self.conjuncts(body).into_iter().find(is_noun)
    }
}
