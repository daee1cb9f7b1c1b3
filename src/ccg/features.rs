//! Features and their weights. A key is interned to a dense index; weights lie in one array beside the keys.
//! Scales are the reference's (Williams et al.; METHOD in the guide): they say how much one occurrence counts.

use super::combinator::RuleId;
use super::lexicon::{EntryId, LexemeId, TemplateId};
use crate::logic::{ConstantId, Node, TermId, Terms};
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

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
    /// Two different predicates occur anywhere in the goal (Williams et al., Section IV-B-1: it tells `in` from
    /// `near` when the words do not). The first name is the smaller.
    Pair(ConstantId, ConstantId),
}

impl Feature {
    /// How much one occurrence counts.
    pub fn scale(self) -> f64 {
        match self {
            Feature::Template(_) => 0.1,
            Feature::Rule(_) => 0.5,
            Feature::Lexeme(_) | Feature::Entry(_) | Feature::Skip | Feature::Pair(..) => 1.0,
        }
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

    /// ‖self − other‖₁, summed in the features' order.
    pub fn l1_distance(&self, other: &Vector) -> f64 {
        let (mut a, mut b) = (self.0.as_slice(), other.0.as_slice());
        let mut sum = 0.0;
        loop {
            match (a, b) {
                ([], rest) | (rest, []) => {
                    return rest.iter().fold(sum, |sum, (_, x)| sum + x.abs());
                }
                ([(i, x), a_rest @ ..], [(j, y), b_rest @ ..]) => {
                    sum += match i.cmp(j) {
                        Ordering::Less => x.abs(),
                        Ordering::Equal => (x - y).abs(),
                        Ordering::Greater => y.abs(),
                    };
                    (a, b) = (if i <= j { a_rest } else { a }, if j <= i { b_rest } else { b });
                }
            }
        }
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

    /// What one occurrence of the feature adds to a score: its weight times its scale.
    pub fn value(&self, feature: Feature) -> f64 {
        self.index.get(&feature).map_or(0.0, |&id| self.weights[id.0 as usize] * feature.scale())
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
        for (id, value) in vector.iter() {
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
        counts.sort_by_key(|&(id, _)| id);
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
pub fn root_features(terms: &Terms, form: TermId) -> Vec<Feature> {
    let mut predicates = Vec::new();
    predicates_of(terms, form, &mut predicates);
    predicates.sort_by(|&a, &b| terms.name(a).cmp(terms.name(b)));
    predicates.dedup();
    let mut pairs = Vec::with_capacity(predicates.len() * predicates.len() / 2);
    for (place, &first) in predicates.iter().enumerate() {
        pairs.extend(predicates[place + 1..].iter().map(|&second| Feature::Pair(first, second)));
    }
    pairs
}

/// Every constant that is applied to entities; connectives, quantifiers and determiners are none.
fn predicates_of(terms: &Terms, term: TermId, found: &mut Vec<ConstantId>) {
    match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => {}
        Node::Lambda { body, .. } => predicates_of(terms, body, found),
        Node::Apply { head, args } => {
            if let Node::Constant(constant) = terms.node(head)
                && args.iter().all(|&arg| terms.ty(arg) == crate::logic::ty::ENTITY)
            {
                found.push(constant);
            }
            args.iter().for_each(|&arg| predicates_of(terms, arg, found));
        }
    }
}
