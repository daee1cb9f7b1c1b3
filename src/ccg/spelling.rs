//! Words heard through their misspelling: "chiar" is read as the known word next to it. A word that the lexicon knows
//! is never changed, so what is learned of a spelling goes before.

use super::closed::closed;
use super::lexicon::Lexicon;

/// Letters below which a word is taken as it stands: too many short words are one letter apart.
const SHORTEST: usize = 4;
/// Letters from which a word may be two edits away.
const LONG: usize = 8;

/// The words as the lexicon knows them: unknown ones are replaced by the nearest known word that one insertion,
/// deletion, substitution or swap of neighbours makes of them (two in long words), the first of the alphabet where
/// there are several.
pub fn heard(lexicon: &Lexicon, words: &[String]) -> Vec<String> {
    let hear = |(word, closed): (&String, Option<_>)| match closed {
        Some(_) => word.clone(),
        None => nearest(lexicon, word).unwrap_or(word).to_owned(),
    };
    words.iter().zip(closed(words)).map(hear).collect()
}

fn nearest<'a>(lexicon: &'a Lexicon, word: &str) -> Option<&'a str> {
    let length = word.chars().count();
    if length < SHORTEST || lexicon.knows(word) {
        return None;
    }
    let bound = if length < LONG { 1 } else { 2 };
    let near = lexicon.vocabulary().filter_map(|known| {
        let distance = strsim::damerau_levenshtein(word, known);
        (distance <= bound && known.chars().count() >= SHORTEST).then_some((distance, known))
    });
    near.min().map(|(_, known)| known)
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
