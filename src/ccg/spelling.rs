//! Words heard through their misspelling: "chiar" is read as the known word next to it. A word that the lexicon knows
//! is never changed, so what is learned of a spelling goes before; nor is a word of its own that a general resource knows.
//! Nothing is heard as a word that means nothing.

use super::closed::{closed, closed_words};
use super::lexicon::Lexicon;
use super::model::Model;

/// Letters below which a word is taken as it stands: too many short words are one letter apart.
const SHORTEST: usize = 4;
/// Letters from which a word may be two edits away.
const LONG: usize = 8;

/// The words as the lexicon knows them: unknown ones are replaced by the nearest known word that one insertion,
/// deletion, substitution or swap of neighbours makes of them (two in long words), the first of the alphabet where
/// there are several.
pub(super) fn heard(model: &Model, words: &[String]) -> Vec<String> {
    let hear = |(word, closed): (&String, Option<_>)| match closed {
        Some(_) => word.clone(),
        None => nearest(model, word).unwrap_or_else(|| word.clone()),
    };
    words.iter().zip(closed(words)).map(hear).collect()
}

fn nearest(model: &Model, word: &str) -> Option<String> {
    let (lexicon, length) = (&model.lexicon, word.chars().count());
    if length < SHORTEST || lexicon.knows(word) || model.general().is_word(word) {
        return None;
    }
    let bound = if length < LONG { 1 } else { 2 };
    let mut known: Vec<&str> = lexicon.vocabulary().collect();
    known.retain(|known| lexicon.has_meaning(known));
    known.extend(closed_words().map(|word| -> &str { word }));
    let near = known.into_iter().filter_map(|known| {
        let distance = strsim::damerau_levenshtein(word, known);
        (distance <= bound && known.chars().count() >= SHORTEST).then_some((distance, known))
    });
    near.min().map(|(_, known)| known.to_owned())
}

/// Up to `most` known words that are spelt somewhat like an unknown one, nearest first: less alike than what is heard
/// without asking, to be offered to whoever wrote it.
pub fn alike(lexicon: &Lexicon, word: &str, most: usize) -> Vec<String> {
    let length = word.chars().count();
    let bound = 1 + length / SHORTEST;
    let mut near: Vec<(usize, &str)> = lexicon
        .vocabulary()
        .map(|known| (strsim::damerau_levenshtein(word, known), known))
        .filter(|&(distance, known)| distance <= bound && distance < known.chars().count())
        .filter(|_| length >= 2)
        .collect();
    near.sort_unstable();
    near.into_iter().take(most).map(|(_, known)| known.to_owned()).collect()
}
