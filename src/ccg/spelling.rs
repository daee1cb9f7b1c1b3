//! Words heard through their misspelling: "chiar" is read as the known word next to it. A word that the lexicon knows
//! is never changed, so what is learned of a spelling goes before.

use super::lexicon::Lexicon;

/// Letters below which a word is taken as it stands: too many short words are one letter apart.
const SHORTEST: usize = 4;
/// Letters from which a word may be two edits away.
const LONG: usize = 8;

/// The words as the lexicon knows them: unknown ones are replaced by the nearest known word that one insertion,
/// deletion, substitution or swap of neighbours makes of them (two in long words), the first of the alphabet where
/// there are several.
pub fn heard(lexicon: &Lexicon, words: &[String]) -> Vec<String> {
    let hear = |word: &String| nearest(lexicon, word).unwrap_or(word).to_owned();
    words.iter().map(hear).collect()
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
