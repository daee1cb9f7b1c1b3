//! What was learned just now, for a person who watches: the command, its best forms and which of them are valid, the
//! entries that it added and the features that it moved most.

use crate::ccg::{EntryText, FeatureId, Kinds, Model, Vector};
use crate::logic::{TermId, print};
use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// Forms that are shown.
const MOST_FORMS: usize = 5;
/// Features that are shown.
const MOST_FEATURES: usize = 8;
/// Entries that are shown.
const MOST_ENTRIES: usize = 20;

/// What training did with its last command.
pub(super) struct Last {
    /// The place of the command.
    pub(super) at: usize,
    /// Its readings, the best first.
    pub(super) readings: Vec<(TermId, Rc<Vector>)>,
    /// For each of its examples which readings are valid.
    pub(super) judged: Vec<Vec<bool>>,
    /// How far each reading was followed, once for every example that there was something to learn from.
    pub(super) steps: Vec<Vec<f64>>,
    /// Entries of the lexicon before.
    pub(super) entries: usize,
}

/// What was learned from a command.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Look {
    /// The command's words.
    pub command: String,
    /// Examples that have it.
    pub examples: usize,
    /// Examples with a valid form.
    pub valid: usize,
    /// Forms that it can mean.
    pub n_forms: usize,
    /// Those that were best.
    pub forms: Vec<Form>,
    /// Entries that it added.
    pub added: Vec<EntryText>,
    /// Features that it moved, those that it moved most first.
    pub moved: Vec<Moved>,
}

/// A form that a command can mean.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Form {
    /// The goal as an s-expression.
    pub form: String,
    /// What it scores now.
    pub score: f64,
    /// Examples for which it is valid.
    pub valid: usize,
}

/// A feature whose weight has moved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Moved {
    /// The feature as a model file names it.
    pub feature: String,
    /// By how much.
    pub by: f64,
    /// Its weight now.
    pub weight: f64,
}

impl Last {
    /// What there is to see of it; features of the kinds `without` did not move.
    pub(super) fn look(
        &self,
        model: &Model,
        words: &[String],
        examples: usize,
        without: Kinds,
    ) -> Look {
        let valid =
            |at: usize| self.judged.iter().filter(move |valid| valid.get(at) == Some(&true));
        let form = |(at, (form, vector)): (usize, &(TermId, Rc<Vector>))| Form {
            form: print(&model.grammar.terms, *form),
            score: model.features.dot(vector),
            valid: valid(at).count(),
        };
        let added = model.lexicon.entries().iter().skip(self.entries).take(MOST_ENTRIES);
        Look {
            command: words.join(" "),
            examples,
            valid: self.judged.iter().filter(|valid| valid.contains(&true)).count(),
            n_forms: self.readings.len(),
            forms: self.readings.iter().enumerate().take(MOST_FORMS).map(form).collect(),
            added: added.map(|&id| EntryText::of(model, id)).collect(),
            moved: self.moved(model, without),
        }
    }

    fn moved(&self, model: &Model, without: Kinds) -> Vec<Moved> {
        let mut by: FxHashMap<FeatureId, f64> = FxHashMap::default();
        for steps in &self.steps {
            for ((_, vector), step) in self.readings.iter().zip(steps) {
                for (id, value) in vector.iter().filter(|_| *step != 0.0) {
                    *by.entry(id).or_default() += step * value;
                }
            }
        }
        let mut by: Vec<(FeatureId, f64)> = by.into_iter().collect();
        by.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()).then(a.0.cmp(&b.0)));
        let moved = |(id, by): (FeatureId, f64)| {
            let feature = model.features.feature(id);
            let moves = feature.is_learned() && !without.has(feature) && by.abs() > 1e-6;
            moves.then(|| Moved {
                feature: model.feature_text(feature).trim_end().replace('\t', " "),
                by,
                weight: model.features.weight(feature),
            })
        };
        by.into_iter().filter_map(moved).take(MOST_FEATURES).collect()
    }
}
