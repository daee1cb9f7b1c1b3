//! Words that mean nothing here, such as "please": their neighbour absorbs them. Which they are is learned like any
//! meaning, by entries of category EMPTY (after the skipping entries of Artzi and Zettlemoyer's SPF); skipping a word
//! that no entry calls empty is the same at a price. There is one way to absorb a word, so readings do not multiply.
//! A closed word never goes without meaning; nor, behind one that turns round, does what it may speak of.

use super::anaphora::{is_pronoun, is_within_or_out};
use super::chart::Lexical;
use super::closed::{Kind, closed};
use super::features::Feature;
use super::lexicon::EntryId;
use super::model::Model;
use super::word_kind::{
    begins_phrase, brings_thing, is, is_bare_noun, is_noun, is_place_word, is_preposition,
    is_verb_word, takes_place, takes_thing,
};

/// Before a pronoun these often say nothing: "the room with the chair in it".
const WITHIN: [&str; 6] = ["in", "into", "inside", "within", "with", "of"];

/// What is wanted somewhere is a thing.
const WANTS: [&str; 4] = ["want", "need", "like", "see"];

/// With these begins what is said of something besides.
const ANEW: [&str; 14] = [
    "is", "are", "be", "has", "have", "with", "that", "which", "who", "stay", "remain", "wait",
    "stand", "rest",
];

/// Which words may go without meaning.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Leniency {
    /// Those with an entry that says they are empty.
    Learned,
    /// Those and the words that the lexicon does not know.
    Unknown,
    /// Any but closed ones, and those that one of them turns.
    Any,
}

/// For every word the entry by which it means nothing, if the lexicon has one and the word may be silent.
pub fn empty_entries(model: &Model, words: &[String]) -> Vec<Option<EntryId>> {
    let empty = |(word, may_be_silent): (&String, _)| {
        let entries = model.lexicon.entries_for_word(word);
        let is_empty = |&entry: &EntryId| model.lexicon.is_empty_entry(entry);
        entries.iter().copied().find(is_empty).filter(|_| may_be_silent)
    };
    words.iter().zip(may_be_silent(model, words)).map(empty).collect()
}

/// For every word whether it may go without meaning. Behind a word that turns round, a verb that begins another clause may
/// not: silent, it would have that denied, too. A preposition next to the turning word says what is turned ("not to the red
/// room but to the blue one"). Nor may a pronoun that is all a verb is done to ("take it to the red room"), or that stands
/// behind a preposition in what orders or sets a condition ("until the chair is in it"), or that is gone away from ("get out
/// of there"), or that one is to be beside in a clause that is joined ("and stand next to it"); nor the verb that brings what
/// stands behind it ("and bring it to the red room" brings no robot there).
fn may_be_silent(model: &Model, words: &[String]) -> Vec<bool> {
    let closed = closed(words);
    let clauses = clauses_behind(model, words, &closed);
    let is_turned = |at: usize| {
        at > 0 && closed[at - 1] == Some(Kind::Turns) && is(model, &words[at], is_preposition)
    };
    let first_noun = words.iter().position(|word| is(model, word, is_noun)).unwrap_or(words.len());
    let orders = closed.iter().position(|&kind| kind == Some(Kind::Orders)).unwrap_or(words.len());
    let is_thing = |at: usize| {
        let is_done_to = || {
            (1..first_noun).contains(&at) && is(model, &words[at - 1], takes_thing)
                || at > 0
                    && (is(model, &words[at - 1], brings_thing) || WANTS.contains(&&*words[at - 1]))
        };
        let is_in_condition = || at > orders && is(model, &words[at - 1], is_preposition);
        // "Then it into the blue room": what is brought there is said, with no verb.
        let is_brought = || {
            at > 0
                && matches!(closed[at - 1], Some(Kind::Joins | Kind::Orders))
                && words.get(at + 1).is_some_and(|next| is_place_word(model, next))
        };
        is_pronoun(&words[at]) && (is_done_to() || is_in_condition() || is_brought())
    };
    // What is denied first is said, where another clause begins behind it ("don't go there, go to the blue room").
    let is_denied = |at: usize| {
        !clauses.is_empty()
            && at > 0
            && closed[at - 1] == Some(Kind::Turns)
            && is_verb_word(model, &words[at])
    };
    let turns = |at: usize| closed[at] == Some(Kind::Turns);
    let is_left = |at: usize| {
        let is_behind = at > 1 && matches!(&*words[at - 1], "of" | "from") && turns(at - 2);
        is_behind && (is_pronoun(&words[at]) || words[at] == "there")
    };
    // Beside what one is to be in a clause that is joined: where its place begins, and the pronoun behind it.
    let joined = closed.iter().position(|&kind| kind == Some(Kind::Joins)).unwrap_or(words.len());
    let is_place = |at: usize| at > joined && is_place_word(model, &words[at]);
    let beside = (joined + 1..words.len()).find_map(|end| {
        let start = (0..end).rev().take_while(|&at| is_place(at)).last()?;
        (is_pronoun(&words[end]) && !WITHIN.contains(&&*words[end - 1])).then_some((start, end))
    });
    let is_beside = |at: usize| {
        let goes = || is(model, &words[at], takes_place) && is_place_word(model, &words[at + 1]);
        beside.is_some_and(|(start, end)| {
            at == end
                || (start..end).contains(&at) && words[at] != "to"
                || at + 1 < joined && goes()
        })
    };
    // "Bring it there and stay out of it" does not say "and be out of it in the end".
    let stays = |at: usize| matches!(&*words[at], "stay" | "keep" | "remain");
    let stays_out = |at: usize| {
        stays(at)
            && (closed.get(at + 1) == Some(&Some(Kind::Turns))
                || at > joined && at + 3 < words.len() && is_left(at + 3))
    };
    let is_turned_one = |at: usize| at > 0 && turns(at - 1) && is_pronoun(&words[at]);
    // What was done in the clause before is done first: "go to the blue room and get out of it".
    let joins = |&at: &usize| matches!(closed[at], Some(Kind::Joins | Kind::Orders));
    let left = (0..words.len()).find(|&at| is_left(at)).unwrap_or(0);
    let before = (0..left).rev().find(joins).unwrap_or(0);
    let is_before = |at: usize| {
        let has_more = || {
            let next = &words[at + 1];
            begins_phrase(model, next) || is(model, next, is_preposition)
        };
        at + 1 < before && is_verb_word(model, &words[at]) && has_more()
    };
    let is_said_again = |at: usize| words[at..].iter().any(|word| is_pronoun(word));
    let moves_thing = |at: usize| {
        let noun = words[at + 1..].iter().find(|word| is_bare_noun(model, word));
        words[at] == "move"
            && noun.is_some_and(|noun| !matches!(&**noun, "room" | "robot" | "door"))
    };
    let brings = |at: usize| {
        is(model, &words[at], brings_thing)
            && (!is(model, &words[at], takes_place) || moves_thing(at))
            && words.get(at + 1).is_some_and(|next| {
                is_pronoun(next) || begins_phrase(model, next) && !is_said_again(at + 1)
            })
    };
    // Where one goes is said behind the verb; alone, the place would be a thing's ("go to the room that has the bag").
    let goes = |at: usize| {
        words[at] == "go"
            && is(model, &words[at], takes_place)
            && words.get(at + 1).is_some_and(|next| is_place_word(model, next))
    };
    // "Have the chair in and the block out"; "then move it back in".
    let is_cut_off = |at: usize| {
        let is_back = || at > 0 && (is_pronoun(&words[at - 1]) || words[at - 1] == "back");
        is_within_or_out(&words[at])
            && closed.get(at + 1).map_or_else(is_back, |next| *next == Some(Kind::Joins))
    };
    // "With you" the robot is brought, too.
    let is_with_you = |at: usize| {
        let stands =
            |at: usize| words[at] == "with" && words.get(at + 1).is_some_and(|w| w == "you");
        (stands(at) || at > 0 && stands(at - 1))
            && words[..at].iter().any(|word| is(model, word, brings_thing))
    };
    // What is joined to what is denied begins anew, if not with the same word ("not in red or in blue"): "without the chair and
    // with the block", "out of red and in blue", "that is not red and has the chair".
    let begins_anew = |at: usize| {
        let word = &*words[at];
        let joins =
            |at: usize| closed[at] == Some(Kind::Joins) || matches!(&*words[at], "then" | "but");
        let is_joined = at > 0 && joins(at - 1);
        let is_again = || (1..at - 1).any(|turn| turns(turn - 1) && words[turn] == word);
        is_joined
            && closed.get(at + 1).is_some_and(|next| *next != Some(Kind::Turns))
            && (0..at - 1).any(turns)
            && (ANEW.contains(&word)
                || is(model, word, is_preposition)
                || is_verb_word(model, word))
            && !is_again()
    };
    // "Drop off the chair" does not say to keep off it.
    let drops = |at: usize| words[at] == "drop" && words.get(at + 1).is_some_and(|w| w == "off");
    // Who cleans a room does not just go there.
    let clears = |at: usize| matches!(&*words[at], "clean" | "tidy");
    let speaks = |at: usize| {
        let goes_on = || is_turned(at) || is_thing(at) || is_denied(at);
        closed[at].is_some()
            || goes_on()
            || is_left(at)
            || is_beside(at)
            || stays_out(at)
            || is_turned_one(at)
            || is_before(at)
            || brings(at)
            || goes(at)
            || is_cut_off(at)
            || is_with_you(at)
            || clears(at)
            || drops(at)
            || begins_anew(at)
    };
    (0..words.len()).map(|at| !speaks(at) && !clauses.contains(&at)).collect()
}

/// Where other clauses begin behind a word that turns round or orders, whose own verb is itself, the next or one before it
/// ("don't go to the red room, go to the blue one", "keep away from the chair, stay in the blue room"). Verbs next to one
/// another are one ("go get").
pub(super) fn clauses_behind(
    model: &Model,
    words: &[String],
    closed: &[Option<Kind>],
) -> Vec<usize> {
    let turns = |kind: &Option<Kind>| matches!(kind, Some(Kind::Turns | Kind::Orders));
    let Some(turn) = closed.iter().position(turns) else { return Vec::new() };
    let acts = |at: usize| is_verb_word(model, &words[at]);
    let lasts = |at: usize| matches!(&*words[at], "remain" | "wait");
    let own = is(model, &words[turn], takes_thing).then_some(turn);
    // Behind a verb before it another begins a clause of its own where nothing joins them.
    let is_first = own.is_none() && closed[turn] == Some(Kind::Turns);
    let first = (0..turn).rev().find(|&at| is_first && acts(at));
    let behind = (turn + 1..words.len())
        .filter(|&at| (acts(at) || lasts(at)) && (first.is_none() || closed[at - 1].is_none()));
    let verbs: Vec<usize> = own.or(first).into_iter().chain(behind).collect();
    let begins = verbs.windows(2).filter(|pair| pair[0] + 1 < pair[1]);
    begins.map(|pair| pair[1]).collect()
}

/// What it adds to a score to leave each word without meaning, by the entry given for that if there is one; `None`
/// where that may not be.
pub fn absorption(
    model: &Model,
    words: &[String],
    empty: &[Option<EntryId>],
    leniency: Leniency,
) -> Vec<Option<f64>> {
    let costs = absorbed(model, words, empty, leniency).into_iter();
    costs.map(|features| features.map(|features| model.value(&features))).collect()
}

/// By what it is scored to leave each word without meaning; `None` where that may not be.
pub fn absorbed(
    model: &Model,
    words: &[String],
    empty: &[Option<EntryId>],
    leniency: Leniency,
) -> Vec<Option<Vec<Feature>>> {
    let features = |((word, &empty), may_be_silent): ((&String, &Option<EntryId>), bool)| {
        let may = match leniency {
            _ if !may_be_silent => false,
            Leniency::Any => true,
            Leniency::Unknown => empty.is_some() || !model.lexicon.knows(word),
            Leniency::Learned => empty.is_some(),
        };
        may.then(|| model.absorption_features(word, empty))
    };
    words.iter().zip(empty).zip(may_be_silent(model, words)).map(features).collect()
}

/// The items, each also over the empty words to its right; those at the beginning of the sentence are absorbed by
/// the item that follows. So there is one way to absorb a word. What nothing can stand beside is left out: a word that
/// can only be absorbed costs no more than that.
pub fn absorbing(items: Vec<Lexical>, costs: &[Option<f64>]) -> Vec<Lexical> {
    // What it adds to leave all words before a place without meaning.
    let mut leading = vec![Some(0.0)];
    let mut sum = Some(0.0);
    leading.extend(costs.iter().map(|cost| {
        sum = sum.zip(*cost).map(|(sum, cost)| sum + cost);
        sum
    }));
    let (begins, ends) = neighbours(&items, costs);
    let mut all = Vec::with_capacity(items.len());
    for item in items {
        let mut starts = Vec::new();
        if item.start == 0 || ends[item.start] {
            starts.push((item.start, 0.0));
        }
        starts.extend(leading[item.start].filter(|_| item.start > 0).map(|cost| (0, cost)));
        for (start, before) in starts {
            let mut score = item.score + before;
            let mut add = |end: usize, score: f64| {
                if begins[end] {
                    all.push(Lexical { start, end, score, ..item });
                }
            };
            add(item.end, score);
            for (end, cost) in (item.end + 1..).zip(&costs[item.end..]) {
                let Some(cost) = cost else { break };
                score += cost;
                add(end, score);
            }
        }
    }
    all
}

/// For every place whether an item begins there, as if one did at the end; and whether one ends there with what it
/// absorbs.
fn neighbours(items: &[Lexical], costs: &[Option<f64>]) -> (Vec<bool>, Vec<bool>) {
    let mut begins = vec![false; costs.len() + 1];
    let mut ends = begins.clone();
    begins[costs.len()] = true;
    for item in items {
        begins[item.start] = true;
        ends[item.end] = true;
    }
    for (at, cost) in costs.iter().enumerate() {
        ends[at + 1] |= ends[at] && cost.is_some();
    }
    (begins, ends)
}
