//! Words heard through their misspelling: "chiar" is read as the known word next to it, and a noun in the plural as in the
//! singular. A word that the lexicon knows is never changed otherwise, so what is learned of a spelling goes before; nor is
//! a word of its own that a general resource knows. Nothing is heard as a word that means nothing; of words that are as
//! near, one that turns round is heard first.

use super::closed::{Kind, closed, closed_words};
use super::lexicon::{EntryId, Lexicon, Origin, boxed};
use super::model::Model;
use super::word_kind::{is, is_noun};
use crate::logic::order;

/// Letters below which a word is taken as it stands: too many short words are one letter apart.
const SHORTEST: usize = 4;
/// Letters below which not even a word that turns round is heard.
const SHORTEST_TURN: usize = 3;
/// Letters from which a word may be two edits away.
const LONG: usize = 8;
/// Letters from which a word that is only offered may be.
const LONGER: usize = 6;

/// The words as the lexicon knows them: unknown ones are replaced by the nearest known word that one insertion,
/// deletion, substitution or swap of neighbours makes of them (two in long words); where there are several, one that
/// turns round, or else the first of the alphabet.
pub(super) fn heard(model: &Model, words: &[String]) -> Vec<String> {
    let hear = |(at, closed): (usize, Option<_>)| {
        let word = &words[at];
        let other = closed.is_none().then(|| {
            let one = singular(model, word).filter(|_| !is_within_phrase(model, words, at));
            one.or_else(|| nearest(model, word))
        });
        other.flatten().unwrap_or_else(|| word.clone())
    };
    closed(words).into_iter().enumerate().map(hear).collect()
}

/// The noun of the seed that a word is the plural of, if nothing else is known that it means: "objects" never means nothing.
fn singular(model: &Model, word: &str) -> Option<String> {
    let one = word.strip_suffix('s').filter(|one| is(model, one, is_noun))?;
    (!model.lexicon.has_meaning(word)).then(|| one.to_owned())
}

/// Whether the word belongs to several that the lexicon knows together: "all things".
fn is_within_phrase(model: &Model, words: &[String], at: usize) -> bool {
    let longest = model.lexicon.longest();
    (at.saturating_sub(longest - 1)..=at).any(|start| {
        let ends = at + 1..=(start + longest).min(words.len());
        ends.filter(|end| end - start > 1)
            .any(|end| !model.lexicon.entries_for(&boxed(&words[start..end])).is_empty())
    })
}

fn nearest(model: &Model, word: &str) -> Option<String> {
    let (lexicon, length) = (&model.lexicon, word.chars().count());
    if length < SHORTEST_TURN || lexicon.knows(word) || model.general().is_word(word) {
        return None;
    }
    let bound = if length < LONG { 1 } else { 2 };
    let words = lexicon.vocabulary().map(|known| (known, false));
    let known = words.chain(closed_words().map(|known| (known, true)));
    let near = known.filter_map(|(known, is_closed)| {
        // The distance is never less than the difference in length.
        if known.chars().count().abs_diff(length) > bound {
            return None;
        }
        let distance = strsim::damerau_levenshtein(word, known);
        if distance > bound || !is_closed && !lexicon.has_meaning(known) {
            return None;
        }
        let turns = closed(&[known]) == [Some(Kind::Turns)];
        let is_long = length.min(known.chars().count()) >= SHORTEST;
        (is_long || turns && is_slip(word, known)).then_some((distance, !turns, known))
    });
    near.min().map(|(.., known)| known.to_owned())
}

/// Whether a word looks like a short one that turns round, written in haste: "nto", "nott", "dnt". Unheard, it would be
/// skipped.
fn is_slip(word: &str, turn: &str) -> bool {
    let sorted = |text: &str| {
        let mut letters: Vec<char> = text.chars().collect();
        order::sort_by_key(&mut letters, |&letter| letter);
        letters
    };
    let undoubled = |text: &str| {
        let mut letters: Vec<char> = text.chars().collect();
        letters.dedup();
        letters
    };
    let is_without_vowels = turn.replace(['a', 'e', 'i', 'o', 'u'], "") == word;
    turn.chars().count() >= SHORTEST_TURN
        && (is_without_vowels || sorted(word) == sorted(turn) || undoubled(word) == undoubled(turn))
}

/// Known words that are spelt somewhat like an unknown one, nearest first, to be offered to whoever wrote it: two that were
/// run together ("goto"), and words with a meaning, one letter away, or two in longer words. All are of the seed, since
/// others may have misspelt what they taught.
pub fn alike(lexicon: &Lexicon, word: &str) -> Vec<String> {
    let length = word.chars().count();
    let bound = if length < LONGER { 1 } else { 2 };
    let is_seed = |known: &str| {
        let means =
            |&id: &EntryId| lexicon.origin(id) == Origin::Seed && !lexicon.is_empty_entry(id);
        lexicon.entries_for_word(known).iter().any(means)
    };
    let mut near: Vec<(usize, &str)> = lexicon
        .vocabulary()
        .filter(|known| is_seed(known))
        .map(|known| (strsim::damerau_levenshtein(word, known), known))
        .filter(|&(distance, known)| distance <= bound && distance < known.chars().count())
        .filter(|_| length >= 2)
        .collect();
    order::sort_by_key(&mut near, |&one| one);
    let splits = word.char_indices().map(|(at, _)| word.split_at(at));
    let apart = splits
        .filter(|(one, other)| one.len() > 1 && other.len() > 1 && is_seed(one) && is_seed(other));
    let apart = apart.map(|(one, other)| format!("{one} {other}"));
    apart.chain(near.into_iter().map(|(_, known)| known.to_owned())).collect()
}
