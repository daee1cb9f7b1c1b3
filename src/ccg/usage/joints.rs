//! Usage of words that join, and of those that name again what was named before them.

use super::standing::{Rule, Standing};
use crate::ccg::anaphora::{is_pronoun, is_within_or_out};
use crate::ccg::closed::Kind;
use crate::ccg::context::{MODALS, says};
use crate::ccg::syntax::{Atom, SyntaxId};
use crate::ccg::word_kind::{is, is_preposition};

pub(super) const RULES: &[Rule] = &[
    clause,
    two_of_one,
    two_clauses,
    at_once,
    goes_then,
    next_to,
    as_well,
    was_brought,
    both_are_there,
    or_is_and,
    named_again,
    there,
];

/// A word between clauses joins none where no clause begins behind it.
fn clause(s: &Standing) -> bool {
    let clause = s.syntaxes().joined(s.syntax());
    clause.is_some_and(|clause| s.context.goes_on(s.item.end - 1, clause == SyntaxId::T))
}

/// Of what should be somewhere there may be two.
fn two_of_one(s: &Standing) -> bool {
    s.text == "S\\NP\\(S\\NP/NP)\\NP/NP" && !says(s.so_far, &MODALS)
}

/// "The chair should be here and the block shouldn't" are two clauses, of which the first says where.
fn two_clauses(s: &Standing) -> bool {
    s.does(Kind::Joins) && s.text.ends_with("\\NP)\\NP/NP") && says(s.so_far, &MODALS)
}

/// "And put the chair in it" is done where one goes, not after that.
fn at_once(s: &Standing) -> bool {
    let [.., within, it] = s.rest else { return false };
    s.says(&["and"]) && s.text == "T\\T/T" && is_pronoun(it) && is_within_or_out(within)
}

/// "Then to the red room" goes on with where a thing is brought; where one goes, it is another place.
fn goes_then(s: &Standing) -> bool {
    let then = s.own.iter().any(|word| word == "then");
    s.text == "PP\\PP/NP" && then && !s.context.moves_thing(s.item.start)
}

/// "And next to the block" is no next step.
fn next_to(s: &Standing) -> bool {
    let is_next = s.own.last().is_some_and(|last| last == "next");
    s.syntaxes().joined(s.syntax()) == Some(SyntaxId::T) && is_next && s.next() == Some("to")
}

/// What is said of a thing beside another is of that thing, where it is said to be so as well.
fn as_well(s: &Standing) -> bool {
    let mut around = s.own.iter().chain(s.rest);
    s.text == "LIST\\(S/PP/NP)\\NP\\PP/NP"
        && s.own[0] == "and"
        && !s.does(Kind::Turns)
        && !around.any(|word| matches!(&**word, "too" | "well" | "also" | "so"))
}

/// What was brought somewhere is a clause of its own: "put the chair in the red room and stand next to it".
fn was_brought(s: &Standing) -> bool {
    s.text == "LIST\\NP/AP" && s.context.brings_somewhere(s.item.start)
}

/// "The room with the chair and the block in it" has both: nothing is done to the second.
fn both_are_there(s: &Standing) -> bool {
    let is_thing = || s.text.ends_with("\\NP/NP") && !s.text.starts_with("N\\N");
    let is_done = || {
        (s.text.ends_with("/AP") || s.text.ends_with("/(S\\NP)"))
            && s.opens_phrase()
            && !s.has_verb_behind()
    };
    s.does(Kind::Joins) && (is_thing() || is_done()) && s.context.has(s.item.start)
}

/// To keep one thing or another out is to keep both.
fn or_is_and(s: &Standing) -> bool {
    s.text == "S/PP\\(S/PP/NP)\\NP/NP"
        && s.own[0] == "or"
        && says(s.so_far, &["keep"])
        && s.will(Kind::Turns)
}

/// Beside what was named, "it" is that, where a clause is joined.
fn named_again(s: &Standing) -> bool {
    s.text == "NP"
        && s.word().is_some_and(is_pronoun)
        && s.before().is_some_and(|word| is(s.model(), word, is_preposition))
        && s.did(Kind::Joins)
}

/// Behind a clause "there" is where that one led, not where one was: "push it into the red room, then get out of there".
fn there(s: &Standing) -> bool {
    s.syntaxes().is(s.syntax(), Atom::PP)
        && s.own.last().is_some_and(|word| word == "there")
        && s.first().is_some()
        && (s.did(Kind::Joins) || s.did(Kind::Orders))
}
