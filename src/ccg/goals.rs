//! What there is to know of a goal as a whole, whatever its derivation and the weights: worked out once for whoever asks
//! of it again and again, as training does.

use super::combinator::Grammar;
use super::features::{Feature, FeatureId, Features, root_features};
use super::sense::denied;
use crate::logic::{ConstantId, Node, TermId, Terms, print};
use rustc_hash::FxHashMap;
use std::cell::{Cell, OnceCell};
use std::rc::Rc;

/// A goal.
#[derive(Debug)]
pub struct Goal {
    /// The goal itself.
    pub form: TermId,
    /// What it shares with goals that are the same up to the order of the arguments of commutative relations.
    pub key: TermId,
    /// Its features.
    pub features: Vec<Feature>,
    /// Where their weights are, as far as that is known.
    places: Vec<Cell<Option<FeatureId>>>,
    printed: OnceCell<String>,
}

impl Goal {
    /// What its features add to a derivation's score.
    pub fn scored(&self, features: &Features, score: f64) -> f64 {
        let both = self.features.iter().zip(&self.places);
        both.fold(score, |sum, (&feature, place)| {
            if place.get().is_none() {
                place.set(features.id(feature));
            }
            sum + place.get().map_or(0.0, |id| features.weight_at(id) * feature.scale())
        })
    }

    /// Its text, by which ties break.
    pub fn printed(&self, terms: &Terms) -> &str {
        self.printed.get_or_init(|| print(terms, self.form))
    }
}

/// Goals of one arena, scored by the features of one model.
#[derive(Debug, Default)]
pub struct Goals(FxHashMap<TermId, Rc<Goal>>);

impl Goals {
    /// What there is to know of a goal, or of what a clause of time asks for by itself.
    pub fn get(&mut self, grammar: &mut Grammar, meaning: TermId) -> Rc<Goal> {
        let Grammar { terms, sorts, commutative, .. } = grammar;
        let goal = self.0.entry(meaning).or_insert_with(|| {
            let form = terms.ended(meaning);
            let form = denied(terms, form).unwrap_or(form);
            let features = root_features(terms, sorts, form);
            let key = commuted(terms, commutative, form);
            let places = vec![Cell::new(None); features.len()];
            Rc::new(Goal { form, key, features, places, printed: OnceCell::new() })
        });
        Rc::clone(goal)
    }
}

/// The form with the arguments of commutative relations in canonical order: what two equal readings share.
fn commuted(terms: &mut Terms, commutative: &[ConstantId], term: TermId) -> TermId {
    let result = match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => return term,
        Node::Lambda { parameter, body } => {
            let body = commuted(terms, commutative, body);
            terms.lambda(parameter, body)
        }
        Node::Apply { head, args } => {
            let mut args = args.to_vec();
            args.iter_mut().for_each(|arg| *arg = commuted(terms, commutative, *arg));
            if let Node::Constant(constant) = terms.node(head)
                && commutative.contains(&constant)
            {
                terms.sort(&mut args);
            }
            terms.apply_head(head, &args)
        }
    };
    result.unwrap_or(term)
}
