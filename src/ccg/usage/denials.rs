//! Usage of words that turn round: not, no, nothing, but, without, out.

use super::standing::{Rule, Standing};
use crate::ccg::anaphora::{is_pronoun, is_within_or_out};
use crate::ccg::closed::Kind;
use crate::ccg::context::{AWAY, EXCEPT, HOLDS, LEAVES, PLACES, UNTIL, WHILE, says};
use crate::ccg::word_kind::{
    begins_phrase, brings_thing, is, is_adjective, is_determiner, is_noun, is_place_word,
};

pub(super) const RULES: &[Rule] = &[
    adjective,
    phrase,
    again,
    has_neither,
    more,
    no_room,
    nothing,
    no_goal,
    but_clause,
    but_thing,
    but_place,
    denied_both,
    without,
    goes_out,
    stays_out,
    no_longer_out,
    harmless,
    elsewhere,
    until,
    along,
];

/// Verbs by which a state lasts.
const STAYS: [&str; 3] = ["stay", "remain", "wait"];

/// Verbs by which something goes on, and nothing is done.
const LASTS: [&str; 3] = ["stay", "keep", "remain"];

/// What begins another clause without a verb that means anything of its own.
const FRAMED: [&str; 3] = ["make", "ensure", "see"];

/// Behind "not" these say that it is more.
const SOLELY: [&str; 4] = ["only", "just", "merely", "simply"];

/// An adjective is denied where one stands: "not the red room" is no room that is not red.
fn adjective(s: &Standing) -> bool {
    s.text == "N/N/(N/N)"
        && s.first() == Some(Kind::Turns)
        && s.next().is_some_and(|word| is_determiner(s.model(), word))
}

/// What is denied stands behind "not", and no phrase of which no verb says what becomes; "the not red block" is another one.
fn phrase(s: &Standing) -> bool {
    let determines = |word: Option<&str>| word.is_some_and(|word| is_determiner(s.model(), word));
    let is_phrase = || {
        determines(s.before())
            || determines(s.next()) && s.has_place_behind() && !s.has_verb_behind()
    };
    let of_place = || s.text == "PP/PP" && determines(s.next());
    s.says(&["not"])
        && (s.rest.is_empty() || of_place() || s.text.starts_with("NEG/") && is_phrase())
}

/// What is denied twice is denied both times: "somewhere that is not red and is not blue" is no place that is in no blue room.
fn again(s: &Standing) -> bool {
    let is_joined = s.kind_before() == Some(Kind::Joins) || s.before() == Some("is");
    s.text == "N/N/(N/N)" && s.says(&["not"]) && is_joined && s.did(Kind::Turns)
}

/// In "the room that has neither a chair nor a block" that is what the room has, not where one goes.
fn has_neither(s: &Standing) -> bool {
    s.says(&["neither"])
        && s.before().is_some_and(|word| HOLDS.contains(&word))
        && !(s.text.starts_with("N\\N") || s.text.starts_with("S\\NP"))
}

/// "Not only" is said as one.
fn more(s: &Standing) -> bool {
    let solely = |word: Option<&str>| word.is_some_and(|word| SOLELY.contains(&word));
    s.says(&["not"]) && solely(s.next()) || solely(s.word()) && s.before() == Some("not")
}

/// "The red room and no block" is no room without one, if none was said to have anything.
fn no_room(s: &Standing) -> bool {
    s.says(&["and", "no"]) && s.text.starts_with("N\\N") && !says(s.so_far, &HOLDS)
}

/// "Nothing red" is no red thing, not a red place where nothing is.
fn nothing(s: &Standing) -> bool {
    let ends = s.own.last().is_some_and(|last| matches!(&**last, "nothing" | "anything"));
    let describes = |next: &str| is_adjective(s.model(), next) || EXCEPT.contains(&next);
    ends && s.text == "N\\N" && s.next().is_some_and(describes)
}

/// "No block out of the red room" leaves there what is there: that is no goal of all blocks.
fn no_goal(s: &Standing) -> bool {
    let Some(last) = s.own.last() else { return false };
    let denies = matches!(&**last, "no" | "none" | "nothing");
    let is_any = matches!(&**last, "any" | "anything") && s.did(Kind::Turns);
    s.text.starts_with("S/PP") && (denies || is_any) && says(s.rest, &AWAY)
}

/// "But make sure" is another clause.
fn but_clause(s: &Standing) -> bool {
    begins_except(s)
        && s.text == "N\\N/NP"
        && (s.opens_clause() || s.next().is_some_and(|next| FRAMED.contains(&next)))
}

/// "The block but the bag" is one thing instead of another, and so is "not the red room but the blue one".
fn but_thing(s: &Standing) -> bool {
    let begins_not =
        || s.so_far.windows(2).any(|pair| pair[0] == "not" && begins_phrase(s.model(), &pair[1]));
    match s.text {
        "N\\N/NP" => {
            begins_except(s)
                && s.own.len() == 1
                && (s.context.is_one_thing(s.item.start) || begins_not())
        }
        "N\\N\\(N\\N)/N" => begins_except(s) && says(s.so_far, &["nothing", "anything"]),
        _ => false,
    }
}

fn begins_except(s: &Standing) -> bool {
    s.own.first().is_some_and(|but| EXCEPT.contains(&&**but))
}

/// "But to the blue room" is where to go instead, no other clause.
fn but_place(s: &Standing) -> bool {
    s.text == "T\\NEG/T" && s.own[0] == "but" && (s.opens_phrase() || s.opens_place())
}

/// What stands behind "but", or is done besides, is not denied with the place before it: "do not go to the red room but near the
/// block".
fn denied_both(s: &Standing) -> bool {
    let is_place =
        |at: usize| s.context.words.get(at).is_some_and(|word| is_place_word(s.model(), word));
    let denies =
        |at: usize| s.context.closed[at] == Some(Kind::Turns) && !is_place(at) && !is_place(at + 1);
    s.text == "PP\\PP/PP" && s.own[0] != "or" && (0..s.item.start).any(denies)
}

/// Not to leave a place without a thing is no place without it.
fn without(s: &Standing) -> bool {
    let turns = |kind: &&Option<Kind>| **kind == Some(Kind::Turns);
    s.says(&["without"])
        && s.text == "N\\N/NP"
        && says(s.so_far, &LEAVES)
        && s.context.closed[..s.item.start].iter().filter(turns).count() > 1
}

/// Behind what was brought to a place, it goes out of that one, not of where it was.
fn goes_out(s: &Standing) -> bool {
    s.text == "PP"
        && says(s.own, &["out", "away"])
        && s.before().is_some_and(is_pronoun)
        && s.context.brings_somewhere(s.item.start)
}

/// Behind a clause "stay out" is of where that one led.
fn stays_out(s: &Standing) -> bool {
    s.text == "PP"
        && s.before().is_some_and(|word| STAYS.contains(&word))
        && s.rest.is_empty()
        && is_within_or_out(&s.own[0])
        && s.did(Kind::Joins)
}

/// "And stay out" adds nothing to leaving.
fn no_longer_out(s: &Standing) -> bool {
    s.text == "S\\S"
        && says(s.own, &AWAY)
        && says(s.own, &LASTS)
        && !LEAVES.contains(&&*s.context.words[0])
}

/// What is harmless at the end says nothing of what stands behind it: "and don't move the chair".
fn harmless(s: &Standing) -> bool {
    s.text == "S\\S" && s.does(Kind::Turns) && (s.opens_phrase() || s.opens_place())
}

/// Where a thing is brought somewhere instead, that one is not to be elsewhere, not the robot.
fn elsewhere(s: &Standing) -> bool {
    let brings = |word: &String| is(s.model(), word, brings_thing) && !LEAVES.contains(&&**word);
    let mut nouns = s.rest.iter().filter(|word| is(s.model(), word, is_noun)).skip(1);
    let of_robot = s.text == "LIST/S/NP" || s.text == "LIST/S/S" && s.opens_phrase();
    of_robot
        && !says(s.own, &AWAY)
        && (s.rest.iter().any(brings)
            || nouns.next().is_some_and(|noun| !PLACES.contains(&&**noun)))
}

/// What is not to be done until something is so is not to be so; where one stays until something is so, or while, one is all
/// that time, not once.
fn until(s: &Standing) -> bool {
    let stays = || says(s.so_far, &STAYS);
    match s.text {
        "S/S" => says(s.own, &UNTIL) && s.did(Kind::Turns),
        "T\\T/T" if says(s.own, &UNTIL) => stays(),
        "T\\T/T" => says(s.own, &WHILE) && (stays() || says(s.so_far, &["keep"])),
        "T\\(S/NP)\\NP/(S\\NP)" => says(s.own, &UNTIL) && stays(),
        "NEG/PP" => !says(s.rest, &UNTIL) && !says(s.rest, &WHILE),
        _ => false,
    }
}

/// Along the way no bare phrase is forbidden ("take the block without the chair to the red room"), nor is the robot where a
/// sentence is about a thing; and what the robot is not to do says nothing of where a thing is not to be ("take it to the red
/// room but not the blue").
fn along(s: &Standing) -> bool {
    let (syntaxes, syntax) = (s.syntaxes(), s.syntax());
    let forbids_along = syntaxes.forbids_along(syntax);
    let forbids_place = syntaxes.forbids_place(syntax);
    let is_bare = || s.opens_phrase() && !s.has_verb_behind();
    let is_said_of = || matches!(s.before(), Some("is" | "are" | "be"));
    let of_thing = || s.context.begins_with_thing(s.item.start) || is_said_of();
    let is_place = |next: &str| syntaxes.is_in_time(syntax) || is_place_word(s.model(), next);
    let of_moved = || s.next().is_some_and(is_place) && s.context.moves_thing(s.item.start);
    forbids_along && is_bare()
        || (forbids_along || forbids_place) && of_thing()
        || forbids_place && of_moved()
}
