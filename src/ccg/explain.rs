//! Why a reading has its score: which entries, rules and features it used and what each added. What they add, summed
//! from the first to the last, is the score to the last bit.

use super::category::Category;
use super::features::Feature;
use super::hearing::Hearing;
use super::lexicon::{EntryId, Origin};
use super::model::Model;
use super::parse::{Parse, Reading};
use crate::logic::print;
use serde::{Deserialize, Serialize};

/// What a reading's score is made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Explanation {
    /// The sum of what the parts add, in their order. The chart sums the same along the derivation, so that its score
    /// may differ from this in the last digits.
    pub score: f64,
    /// The features that occurred, each once, in the order in which they first did.
    pub parts: Vec<Part>,
    /// The entries that were used, from left to right: first those with a meaning, then those of words without one.
    pub entries: Vec<EntryText>,
}

/// A feature's share of a score.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// The feature as a model file names it, its fields parted by blanks.
    pub feature: String,
    /// How often it occurs.
    pub count: usize,
    /// Its weight.
    pub weight: f64,
    /// What it adds: count times scale times weight.
    pub adds: f64,
}

/// An entry of the lexicon as text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct EntryText {
    /// Its words.
    pub words: String,
    /// Its syntactic category.
    pub syntax: String,
    /// Its meaning.
    pub meaning: String,
    /// Whether it was learned, and is no part of the seed.
    pub learned: bool,
}

impl EntryText {
    /// The text of an entry.
    pub fn of(model: &Model, id: EntryId) -> Self {
        Self::used(model, id, model.lexicon.category(id))
    }

    /// The text of an entry with the category that it has where it is used: a pronoun means what was named before it.
    fn used(model: &Model, id: EntryId, category: Category) -> Self {
        EntryText {
            words: model.lexicon.lexeme(model.lexicon.entry(id).lexeme).words.join(" "),
            syntax: model.grammar.syntaxes.text(category.syntax).to_owned(),
            meaning: print(&model.grammar.terms, category.meaning),
            learned: model.lexicon.origin(id) != Origin::Seed,
        }
    }
}

impl Explanation {
    /// Explains a reading of a parse that the model made.
    pub fn of(model: &Model, parse: &Parse, reading: Reading) -> Self {
        let Hearing { words, empty, .. } = Hearing::new(model, &parse.words);
        let derivation = parse.derivation(reading);
        let occurring = derivation.features(model, reading.form, &words, &empty);
        let parts = parts(model, &occurring);
        let score = parts.iter().fold(0.0, |sum, part| sum + part.adds);
        let leaves = derivation.leaves().into_iter();
        let used =
            leaves.filter_map(|leaf| Some(EntryText::used(model, leaf.entry()?, leaf.category())));
        let absorbed = derivation.absorbed().into_iter().filter_map(|at| *empty.get(at)?);
        let silent = absorbed.map(|id| EntryText::of(model, id));
        let entries = used.chain(silent).collect();
        Explanation { score, parts, entries }
    }
}

/// Each feature once, as often as it occurs.
fn parts(model: &Model, occurring: &[Feature]) -> Vec<Part> {
    let mut counted: Vec<(Feature, usize)> = Vec::new();
    for &feature in occurring {
        match counted.iter_mut().find(|(known, _)| *known == feature) {
            Some((_, count)) => *count += 1,
            None => counted.push((feature, 1)),
        }
    }
    let part = |(feature, count): (Feature, usize)| {
        let value = model.features.value(feature);
        Part {
            feature: model.feature_text(feature).trim_end().replace('\t', " "),
            count,
            weight: model.features.weight(feature),
            adds: count as f64 * value,
        }
    };
    counted.into_iter().map(part).collect()
}
