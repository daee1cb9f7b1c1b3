//! Usage of verbs, and of what stands where one would.

use super::standing::{Rule, Standing};
use crate::ccg::closed::Kind;
use crate::ccg::context::{HOLDS, MODALS, PLACES};
use crate::ccg::syntax::SyntaxId;
use crate::ccg::word_kind::{
    begins_phrase, brings_thing, is, is_bare_noun, is_place_word, is_verb_word,
};

pub(super) const RULES: &[Rule] = &[
    passes,
    ends_elsewhere,
    moves_thing,
    sends_none,
    leaves_thing,
    leaves,
    contains,
    brings_first,
    any_room,
    has_own,
    is_where,
];

/// What one passes is told from where one goes, which is said behind it: "go past the chair to the blue room".
fn passes(s: &Standing) -> bool {
    let kinds = &s.context.closed[s.item.end..];
    let mut clause = s.rest.iter().zip(kinds).map_while(|(word, kind)| {
        (!matches!(kind, Some(Kind::Joins | Kind::Orders))).then_some(&**word)
    });
    s.text == "T/NP" && clause.any(|word| matches!(word, "to" | "into"))
}

/// What one passes is not where one ends, though it is where one must not be: "do not pass the red room".
fn ends_elsewhere(s: &Standing) -> bool {
    s.text == "S/NP" && matches!(s.word(), Some("pass" | "passing")) && !s.did(Kind::Turns)
}

/// One moves along a way, or moves a thing.
fn moves_thing(s: &Standing) -> bool {
    matches!(s.text, "T/T/(T/T)" | "T\\T/(T\\T)")
        && s.word().is_some_and(|verb| is(s.model(), verb, brings_thing))
        && s.opens_phrase()
}

/// "The block should go to the red room" sends no robot there, nor does "the block must not be in red and be in blue".
fn sends_none(s: &Standing) -> bool {
    let is_said = |word: &str| MODALS.contains(&word);
    let is_joined = || {
        s.word() == Some("be")
            && s.kind_before() == Some(Kind::Joins)
            && s.context.says_of_thing(s.item.start)
    };
    s.text == "S/PP"
        && s.word().is_some()
        && (s.before().is_some_and(is_said) && s.context.begins_with_thing(s.item.start)
            || is_joined())
}

/// One leaves a place; to leave a thing is to let it be.
fn leaves_thing(s: &Standing) -> bool {
    let noun = s.rest.iter().position(|word| is_bare_noun(s.model(), word));
    s.text == "S/NP"
        && matches!(s.word(), Some("leave" | "leaving"))
        && noun.is_some_and(|at| {
            let names_room = |word: &String| matches!(&**word, "room" | "'s");
            !PLACES.contains(&&*s.rest[at]) && !s.rest.get(at + 1).is_some_and(names_room)
        })
}

/// "Leave" is said of the place where one is; with more behind it, something else is left.
fn leaves(s: &Standing) -> bool {
    let Some(next) = s.next().filter(|_| s.syntax() == SyntaxId::LIST) else { return false };
    let joins = matches!(s.context.closed[s.item.end], Some(Kind::Joins | Kind::Orders));
    let is_silent = s.context.empty[s.item.end].is_some();
    !joins && (!is_silent || begins_phrase(s.model(), next))
}

/// "The red room should contain the chair" says what is to be there, not which room is meant.
fn contains(s: &Standing) -> bool {
    s.text.starts_with("N\\N")
        && s.word().is_some_and(|word| HOLDS.contains(&word))
        && s.before().is_some_and(|word| MODALS.contains(&word))
}

/// Where a thing is brought stands first, if not behind it: "into the red room push the chair".
fn brings_first(s: &Standing) -> bool {
    let clause = s.context.closed[..s.item.start].iter().rposition(Option::is_some);
    let before = &s.so_far[clause.map_or(0, |at| at + 1)..];
    s.text == "S/NP\\PP"
        && s.word().is_some()
        && before.iter().any(|word| is_verb_word(s.model(), word))
}

/// "The chair's in the green room" says where it is, and "the chair's room" whose.
fn has_own(s: &Standing) -> bool {
    s.text == "NP/N\\NP" && s.says(&["'s"]) && s.opens_place()
}

/// "Any room" is a command by itself, but not behind a preposition: "by any room".
fn any_room(s: &Standing) -> bool {
    s.text == "S/N" && s.before().is_some_and(|word| word == "of" || is_place_word(s.model(), word))
}

/// "The red room is where the chair should be" says so, and tells no red room by it.
fn is_where(s: &Standing) -> bool {
    s.text.starts_with("N\\N") && s.says(&["where"]) && s.before() == Some("is")
}
