//! A sentence's words, what is known of each, and what can be told of a place among them by the words around it.

use super::closed::Kind;
use super::lexicon::EntryId;
use super::model::Model;
use super::word_kind::{
    begins_phrase, brings_thing, is, is_bare_noun, is_noun, is_place_word, is_verb_word,
};

/// Verbs that say what is somewhere, not what is done to it.
pub(super) const STATES: [&str; 16] = [
    "leave",
    "leaves",
    "leaving",
    "keep",
    "keeping",
    "have",
    "has",
    "having",
    "contain",
    "contains",
    "containing",
    "hold",
    "holds",
    "holding",
    "with",
    "let",
];

/// Words up to when.
pub(super) const UNTIL: [&str; 2] = ["until", "till"];

/// Words as long as which: "while", "on your way to".
pub(super) const WHILE: [&str; 3] = ["while", "whilst", "way"];

/// Behind a verb that means no more than that what follows is to be so: "make sure".
const FRAMES: [&str; 3] = ["sure", "certain", "careful"];

/// Words that exclude what stands behind them.
pub(super) const EXCEPT: [&str; 3] = ["but", "except", "besides"];

/// Words by which something goes from where it is.
pub(super) const AWAY: [&str; 5] = ["out", "from", "off", "away", "outside"];

/// Verbs of what is to become of something.
pub(super) const MODALS: [&str; 8] =
    ["should", "must", "shall", "needs", "need", "may", "will", "ought"];

/// Words for what is in a room.
pub(super) const HOLDS: [&str; 9] =
    ["with", "without", "has", "have", "contains", "contain", "containing", "having", "holding"];

/// Verbs of going away from where one is.
pub(super) const LEAVES: [&str; 4] = ["leave", "exit", "vacate", "get"];

/// Nouns of what is no thing that could be brought: where one can be, and who does it.
pub(super) const PLACES: [&str; 4] = ["room", "door", "doorway", "robot"];

/// A sentence's words, and what is known of each.
pub(super) struct Context<'a> {
    pub(super) model: &'a Model,
    pub(super) words: &'a [String],
    /// What each does, if it is closed.
    pub(super) closed: &'a [Option<Kind>],
    /// The entry by which each means nothing, if there is one.
    pub(super) empty: &'a [Option<EntryId>],
}

impl Context<'_> {
    /// Whether a word that joins goes on with what was denied before it: no other clause begins behind it, for there stands
    /// no verb, but a place, a noun or what describes one ("the room other than the red and the blue room"). Where a place
    /// follows the noun, it may be a clause without its verb ("the chair out of the red room and the block out of the blue
    /// room"), unless that would be another one in time.
    pub(super) fn goes_on(&self, at: usize, in_time: bool) -> bool {
        let turns = |kind: &Option<Kind>| *kind == Some(Kind::Turns);
        let behind = (at + 1..self.words.len()).find(|&at| self.closed[at] != Some(Kind::Turns));
        let Some(next) = behind.map(|at| &self.words[at]) else { return false };
        let is_place = (at + 1..=behind.unwrap_or(at)).any(|at| {
            // "The left of the block" is a place, too.
            let at = at + usize::from(self.words[at] == "the");
            self.words.get(at).is_some_and(|word| is_place_word(self.model, word))
        });
        // A place alone is of the thing that is moved, or spoken of, not of the robot.
        let moved = is_place && (self.moves_thing(at) || self.says_of_thing(at));
        let turned = self.closed[at] == Some(Kind::Joins) && self.closed[..at].iter().any(turns);
        let joins = matches!(self.closed[at], Some(Kind::Joins | Kind::Orders));
        if !(joins && moved || turned) {
            return false;
        }
        let end = self.closed.iter().skip(at + 1).position(Option::is_some);
        let mut rest = self.words[at + 1..end.map_or(self.words.len(), |n| at + 1 + n)].iter();
        is_place
            || begins_phrase(self.model, next)
                && (in_time || !rest.any(|word| is_place_word(self.model, word)))
    }

    /// Whether a thing is moved before a place: a verb stands there that takes one, and no place right behind it.
    pub(super) fn moves_thing(&self, at: usize) -> bool {
        self.words[..at].windows(2).any(|pair| {
            is(self.model, &pair[0], brings_thing) && !is_place_word(self.model, &pair[1])
        })
    }

    /// Whether a thing is brought to a place before: one that is said behind it, and does not only tell which thing it is.
    pub(super) fn brings_somewhere(&self, end: usize) -> bool {
        let tells = |at: usize| matches!(&*self.words[at - 1], "is" | "are" | "that" | "which");
        let is_place =
            |at: usize| at > 0 && is_place_word(self.model, &self.words[at]) && !tells(at);
        let verb = (0..end).find(|&at| is(self.model, &self.words[at], brings_thing));
        verb.is_some_and(|verb| (verb + 1..end).any(is_place))
    }

    /// Whether a phrase ends at a place that tells what is in another; what should be there is none of that.
    pub(super) fn has(&self, end: usize) -> bool {
        let before = &self.words[..end];
        let verb = before.iter().rposition(|word| !begins_phrase(self.model, word));
        verb.is_some_and(|at| {
            let is_told = at > 0 && MODALS.contains(&&*before[at - 1]);
            HOLDS.contains(&&*before[at]) && !is_told
        })
    }

    /// Whether "the" and a noun stand before a place: one thing, no several of which some could be excluded.
    pub(super) fn is_one_thing(&self, at: usize) -> bool {
        at > 1
            && self.words[at - 2] == "the"
            && is_bare_noun(self.model, &self.words[at - 1])
            && !PLACES.contains(&&*self.words[at - 1])
    }

    /// Whether a sentence begins with a thing, of which the rest is said: "the chair is never in the red room". What has no
    /// meaning of its own may stand before it, as "make sure" may.
    pub(super) fn begins_with_thing(&self, end: usize) -> bool {
        let is_frame =
            |at: usize| self.words.get(at + 1).is_some_and(|next| FRAMES.contains(&&**next));
        let kind = |&at: &usize| {
            let word = &*self.words[at];
            let is_verb = is_verb_word(self.model, word) && !is_frame(at);
            is_verb || is_place_word(self.model, word) || is(self.model, word, is_noun)
        };
        let first = (0..end).find(kind).map(|at| &*self.words[at]);
        first.is_some_and(|word| is_bare_noun(self.model, word) && !PLACES.contains(&word))
    }

    /// Whether a sentence says of a thing what is to become of it: "the block should be in the red room and not in the blue".
    pub(super) fn says_of_thing(&self, end: usize) -> bool {
        says(&self.words[..end], &MODALS) && self.begins_with_thing(end)
    }

    /// Whether nothing but a phrase stands before a place: "the red room is closed".
    pub(super) fn begins_with_noun(&self, end: usize) -> bool {
        let is_of_phrase =
            |word: &String| begins_phrase(self.model, word) || is(self.model, word, is_noun);
        end > 0 && self.words[..end].iter().all(is_of_phrase)
    }
}

/// Whether one of a list stands among words.
pub(super) fn says(words: &[String], list: &[&str]) -> bool {
    words.iter().any(|word| list.contains(&&**word))
}
