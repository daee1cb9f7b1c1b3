//! Looking words up: the categories that the lexicon gives to the spans of a sentence. An entry that speaks for a closed
//! word must be of the seed and throw no argument away.

use super::category::Category;
use super::chart::Lexical;
use super::closed::{Kind, closed};
use super::lexicon::{EntryId, Origin, boxed};
use super::model::Model;

/// The lexicon's categories for every span of the words.
pub fn lexical_items(model: &Model, words: &[String]) -> Vec<Lexical> {
    let words = boxed(words);
    let mut items = Vec::new();
    let closed = closed(&words);
    for start in 0..words.len() {
        let longest = (start + model.lexicon.longest()).min(words.len());
        for end in start + 1..=longest {
            let is_closed = closed[start..end].iter().any(Option::is_some);
            if closed[start..end].contains(&Some(Kind::Bars)) {
                continue;
            }
            for &entry in model.lexicon.entries_for(&words[start..end]) {
                if model.lexicon.is_empty_entry(entry) || is_closed && !keeps(model, entry) {
                    continue;
                }
                items.push(lexical_item(model, entry, start, end));
            }
        }
    }
    items
}

/// Whether an entry may speak for a closed word: the seed says what the word means, and all that it takes counts.
fn keeps(model: &Model, entry: EntryId) -> bool {
    let Category { syntax, meaning } = model.lexicon.category(entry);
    model.lexicon.origin(entry) == Origin::Seed
        && (0..model.grammar.syntaxes.arity(syntax)).all(|at| !model.grammar.throws(meaning, at))
}

/// An entry over a span.
pub fn lexical_item(model: &Model, entry: EntryId, start: usize, end: usize) -> Lexical {
    let (category, score) = (model.lexicon.category(entry), model.entry_score(entry));
    Lexical { start, end, own: (start, end), category, score, item: entry.item() }
}
