//! Words that name again what was named before: pronouns, and "the room" and no more.

use super::closed::Kind;
use super::model::Model;
use super::word_kind::is_place_word;

/// Stand for a thing or a place.
const PRONOUNS: [&str; 2] = ["it", "them"];

/// Stand for a noun.
const NOUNS: [&str; 2] = ["one", "ones"];

/// Said alone of a place.
const WITHIN_OR_OUT: [&str; 4] = ["in", "inside", "out", "outside"];

/// Whether a word stands for what was named before.
pub(super) fn is_pronoun(word: &str) -> bool {
    PRONOUNS.contains(&word)
}

/// Whether a word stands for a place or thing that was named before.
pub(super) fn names_phrase(word: &str) -> bool {
    is_pronoun(word) || word == "there"
}

/// Whether a word stands for a noun that was said before.
pub(super) fn names_noun(word: &str) -> bool {
    NOUNS.contains(&word)
}

/// Whether a word says alone where something is, seen from a place that was named before: "and stay out".
pub(super) fn is_within_or_out(word: &str) -> bool {
    WITHIN_OR_OUT.contains(&word)
}

/// Whether behind a preposition begins what names a place again: a pronoun, or "the room" and no more.
pub(super) fn names_place(
    model: &Model,
    words: &[String],
    closed: &[Option<Kind>],
    at: usize,
) -> bool {
    let ends = |at: usize| closed.get(at).is_none_or(Option::is_some);
    let is_room = || words.get(at + 1).is_some_and(|next| next == "room") && ends(at + 2);
    let is_named = is_pronoun(&words[at]) || matches!(&*words[at], "the" | "that") && is_room();
    is_named && at > 0 && is_place_word(model, &words[at - 1])
}
