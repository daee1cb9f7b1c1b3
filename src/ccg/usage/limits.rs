//! Usage of words that limit, count or order: only, both, one, first.

use super::standing::{Rule, Standing};
use crate::ccg::closed::Kind;
use crate::ccg::context::{STATES, says};
use crate::ccg::word_kind::is_adjective;

pub(super) const RULES: &[Rule] =
    &[only_has, only_there, only_phrase, only_done, both, one, other, first, first_alone];

/// "The room that only has a chair" has nothing else.
fn only_has(s: &Standing) -> bool {
    s.text == "N/N" && limits(s) && s.next().is_some_and(|next| STATES.contains(&next))
}

/// Of what is there, and at the beginning, "only" says that nothing else is; of what is done that is so anyway.
fn only_there(s: &Standing) -> bool {
    let is_all = || s.opens_phrase() && s.has_place_behind();
    matches!(s.text, "N/N" | "NP/NP" | "NP\\NP")
        && limits(s)
        && s.before().map_or_else(is_all, |word| STATES.contains(&word))
}

/// "Only the chair in the red room" begins with that.
fn only_phrase(s: &Standing) -> bool {
    s.text == "S/PP/NP" && limits(s) && (s.before().is_some() || !s.opens_phrase())
}

/// "Only go there" is no more than that; "only the chair" is said of what is there.
fn only_done(s: &Standing) -> bool {
    s.text == "S/S" && s.word().is_some() && s.does(Kind::Limits) && !s.opens_clause()
}

/// Both of two things that are named, or all that there are.
fn both(s: &Standing) -> bool {
    let joins_others = s.did(Kind::Joins) || s.will(Kind::Joins);
    says(s.own, &["both"])
        && match s.text {
            "NP/NP" => !joins_others,
            "S/PP/N" | "S/PP\\(S/PP/NP)/N" | "S/ADJ\\(S/ADJ/NP)/N" | "N\\N/N" => joins_others,
            _ => false,
        }
}

/// "And one in the blue room" is another thing, no room.
fn one(s: &Standing) -> bool {
    s.says(&["one"]) && s.kind_before().is_some() && s.opens_place()
}

/// "The other red room" is a red one, not any but this red one.
fn other(s: &Standing) -> bool {
    matches!(s.text, "PP\\(PP/NP)/N" | "S\\(S/NP)/N")
        && s.own.last().is_some_and(|word| matches!(&**word, "other" | "another" | "different"))
        && s.next().is_some_and(|next| is_adjective(s.model(), next))
}

/// "The first block" is one of several, not what is done first.
fn first(s: &Standing) -> bool {
    s.word().is_some()
        && s.does(Kind::Orders)
        && s.before() == Some("the")
        && (s.syntaxes().is_in_time(s.syntax()) || s.text == "NP/NP")
}

/// What comes first of what is not said is that alone.
fn first_alone(s: &Standing) -> bool {
    let is_silent = |at: usize| s.context.empty[at].is_some();
    s.text == "LIST\\S"
        && s.first() == Some(Kind::Orders)
        && (!(s.item.end..s.context.words.len()).all(is_silent)
            || s.context.closed[..s.item.start].iter().any(Option::is_some))
}

/// Whether a word limits to one thing.
fn limits(s: &Standing) -> bool {
    s.first() == Some(Kind::Limits) || s.own[0] == "nothing"
}
