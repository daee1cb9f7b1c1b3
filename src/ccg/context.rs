//! What words mean where they stand: which of their categories the words around them allow, and where no clause can be
//! that the words within it would allow.

use super::anaphora::{is_pronoun, is_within_or_out};
use super::chart::Lexical;
use super::closed::Kind;
use super::lexicon::EntryId;
use super::model::Model;
use super::syntax::{Atom, SyntaxId};
use super::word_kind::{
    begins_phrase, brings_thing, is, is_adjective, is_bare_noun, is_determiner, is_noun,
    is_place_word, is_preposition, is_verb_word,
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

/// Verbs by which a state lasts.
const STAYS: [&str; 3] = ["stay", "remain", "wait"];

/// Words up to when.
const UNTIL: [&str; 2] = ["until", "till"];

/// Words as long as which: "while", "on your way to".
const WHILE: [&str; 3] = ["while", "whilst", "way"];

/// Behind a verb that means no more than that what follows is to be so: "make sure".
const FRAMES: [&str; 3] = ["sure", "certain", "careful"];

/// Words that exclude what stands behind them.
const EXCEPT: [&str; 3] = ["but", "except", "besides"];

/// Words by which something goes from where it is.
const AWAY: [&str; 5] = ["out", "from", "off", "away", "outside"];

/// Verbs by which something goes on, and nothing is done.
const LASTS: [&str; 3] = ["stay", "keep", "remain"];

/// Verbs of what is to become of something.
const MODALS: [&str; 8] = ["should", "must", "shall", "needs", "need", "may", "will", "ought"];

/// What begins another clause without a verb that means anything of its own.
const FRAMED: [&str; 3] = ["make", "ensure", "see"];

/// Words for what is in a room.
const HOLDS: [&str; 9] =
    ["with", "without", "has", "have", "contains", "contain", "containing", "having", "holding"];

/// Verbs of going away from where one is.
const LEAVES: [&str; 4] = ["leave", "exit", "vacate", "get"];

/// Nouns of what is no thing that could be brought: where one can be, and who does it.
const PLACES: [&str; 4] = ["room", "door", "doorway", "robot"];

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
    /// Whether words may have a category where they stand, by what stands around them.
    pub(super) fn may_mean(&self, item: &Lexical) -> bool {
        let (syntaxes, syntax) = (&self.model.grammar.syntaxes, item.category.syntax);
        if let Some(clause) = syntaxes.joined(syntax)
            && self.goes_on(item.end - 1, clause == SyntaxId::T)
        {
            return false;
        }
        // "Leave" is said of the place where one is; with more behind it, something else is left.
        if syntax == SyntaxId::LIST && item.end < self.words.len() {
            let joins = matches!(self.closed[item.end], Some(Kind::Joins | Kind::Orders));
            let is_silent = self.empty[item.end].is_some();
            return joins || is_silent && !begins_phrase(self.model, &self.words[item.end]);
        }
        // Behind a clause "there" is where that one led, not where one was ("push it into the red room, then get out of there").
        let orders = |kind: &Option<Kind>| matches!(kind, Some(Kind::Joins | Kind::Orders));
        if syntaxes.is(syntax, Atom::PP)
            && self.words[item.start..item.end].last().is_some_and(|word| word == "there")
            && self.closed[item.start].is_some()
            && self.closed[..item.start].iter().any(orders)
        {
            return false;
        }
        if self.is_out_of_place(item) {
            return false;
        }
        let is_said_of = |at: usize| matches!(&*self.words[at], "is" | "are" | "be");
        if (syntaxes.forbids_place(syntax) || syntaxes.forbids_along(syntax))
            && (self.begins_with_thing(item.start)
                || item.start.checked_sub(1).is_some_and(is_said_of))
        {
            return false;
        }
        // What the robot is not to do says nothing of where a thing is not to be: "take it to the red room but not the blue".
        let of_robot = syntaxes.forbids_place(syntax) && item.end < self.words.len();
        let is_place =
            || syntaxes.is_in_time(syntax) || is_place_word(self.model, &self.words[item.end]);
        !(of_robot && is_place() && self.moves_thing(item.start))
    }

    /// Whether what stands around words shows that they are not used in this category.
    fn is_out_of_place(&self, item: &Lexical) -> bool {
        let (syntaxes, syntax) = (&self.model.grammar.syntaxes, item.category.syntax);
        let before = item.start.checked_sub(1).map(|at| self.words[at].as_str());
        let next = self.words.get(item.end);
        let opens_phrase = || next.is_some_and(|word| begins_phrase(self.model, word));
        let (before_it, own) = (&self.words[..item.start], &self.words[item.start..item.end]);
        let rest = &self.words[item.end..];
        let around = [&self.closed[..item.start], &self.closed[item.end..]];
        let joins_others = || around.iter().any(|part| part.contains(&Some(Kind::Joins)));
        if self.is_told_otherwise(item, own, rest) {
            return true;
        }
        match syntaxes.text(syntax) {
            // An adjective is denied where one stands: "not the red room" is no room that is not red.
            "N/N/(N/N)" if self.closed[item.start] == Some(Kind::Turns) => {
                next.is_some_and(|word| is_determiner(self.model, word))
            }
            // Behind a clause "stay out" is of where that one led.
            "PP" if before.is_some_and(|word| STAYS.contains(&word)) => {
                next.is_none()
                    && is_within_or_out(&self.words[item.start])
                    && self.closed[..item.start].contains(&Some(Kind::Joins))
            }
            // "Any room" is a command by itself, but not behind a preposition: "by any room".
            "S/N" => before.is_some_and(|word| word == "of" || is_place_word(self.model, word)),
            // What is not to be done until something is so is not to be so.
            "S/S" if says(own, &UNTIL) => self.closed[..item.start].contains(&Some(Kind::Turns)),
            // "The room that only has a chair" has nothing else.
            "N/N"
                if self.limits(item.start) && says(rest.get(..1).unwrap_or_default(), &STATES) =>
            {
                true
            }
            // What comes first of what is not said is that alone.
            "LIST\\S" if self.closed[item.start] == Some(Kind::Orders) => {
                let is_silent = |at: usize| self.empty[at].is_some();
                !(item.end..self.words.len()).all(is_silent)
                    || self.closed[..item.start].iter().any(Option::is_some)
            }
            // Both of two things that are named, or all that there are.
            "NP/NP" if says(own, &["both"]) => !joins_others(),
            "S/PP/N" | "S/PP\\(S/PP/NP)/N" | "S/ADJ\\(S/ADJ/NP)/N" | "N\\N/N"
                if says(own, &["both"]) =>
            {
                joins_others()
            }
            // Of what is there, and at the beginning, "only" says that nothing else is; of what is done that is so anyway.
            "N/N" | "NP/NP" | "NP\\NP" if self.limits(item.start) => {
                let is_all =
                    || opens_phrase() && rest.iter().any(|word| is_place_word(self.model, word));
                before.map_or_else(is_all, |word| STATES.contains(&word))
            }
            "S/PP/NP" if self.limits(item.start) => before.is_some() || !opens_phrase(),
            // To keep one thing or another out is to keep both.
            "S/PP\\(S/PP/NP)\\NP/NP" if self.words[item.start] == "or" => {
                says(before_it, &["keep"]) && self.closed[item.end..].contains(&Some(Kind::Turns))
            }
            // Where one stays until something is so, or while, one is all that time, not once.
            "T\\T/T" | "T\\(S/NP)\\NP/(S\\NP)" if says(own, &UNTIL) => says(before_it, &STAYS),
            "T\\T/T" if says(own, &WHILE) => says(before_it, &STAYS) || says(before_it, &["keep"]),
            "NEG/PP" => !says(rest, &UNTIL) && !says(rest, &WHILE),
            // "But to the blue room" is where to go instead, no other clause.
            "T\\NEG/T" if self.words[item.start] == "but" => {
                opens_phrase() || next.is_some_and(|word| is_place_word(self.model, word))
            }
            // No bare phrase is forbidden: "take the block without the chair to the red room".
            _ if syntaxes.forbids_along(syntax) => {
                opens_phrase() && !rest.iter().any(|word| is_verb_word(self.model, word))
            }
            _ => false,
        }
    }

    /// Whether the words right beside it show that words are not used in this category.
    fn is_told_otherwise(&self, item: &Lexical, own: &[String], rest: &[String]) -> bool {
        let syntaxes = &self.model.grammar.syntaxes;
        let (syntax, next) = (item.category.syntax, rest.first());
        let before = item.start.checked_sub(1).map(|at| (self.words[at].as_str(), self.closed[at]));
        let does = |kind: Kind| self.closed[item.start..item.end].contains(&Some(kind));
        let text = syntaxes.text(syntax);
        let so_far = &self.words[..item.start];
        match own {
            // "The red room and no block" is no room without one, if none was said to have anything.
            [and, no] if and == "and" && no == "no" && text.starts_with("N\\N") => {
                !says(so_far, &HOLDS)
            }
            // What one passes is told from where one goes, which is said behind it: "go past the chair to the blue room".
            _ if text == "T/NP" => {
                let clause = rest.iter().zip(&self.closed[item.end..]).map_while(|(word, kind)| {
                    (!matches!(kind, Some(Kind::Joins | Kind::Orders))).then_some(word)
                });
                clause.into_iter().any(|word| matches!(&**word, "to" | "into"))
            }
            // Of what should be somewhere there may be two.
            _ if text == "S\\NP\\(S\\NP/NP)\\NP/NP" => !says(so_far, &MODALS),
            // "And put the chair in it" is done where one goes, not after that.
            [and] if and == "and" && text == "T\\T/T" => {
                let [.., within, it] = rest else { return false };
                is_pronoun(it) && is_within_or_out(within)
            }
            // Not to leave a place without a thing is no place without it.
            [without] if without == "without" && text == "N\\N/NP" => {
                let turns = |kind: &&Option<Kind>| **kind == Some(Kind::Turns);
                says(so_far, &LEAVES) && self.closed[..item.start].iter().filter(turns).count() > 1
            }
            // "The chair should be here and the block shouldn't" are two clauses, of which the first says where.
            _ if does(Kind::Joins) && text.ends_with("\\NP)\\NP/NP") => says(so_far, &MODALS),
            // Behind what was brought to a place, it goes out of that one, not of where it was.
            _ if text == "PP"
                && says(own, &["out", "away"])
                && self.brings_somewhere(item.start) =>
            {
                before.is_some_and(|(word, _)| is_pronoun(word))
            }
            // What is denied stands behind "not".
            [not] if not == "not" && rest.is_empty() => true,
            // "And one in the blue room" is another thing, no room.
            [one] if one == "one" && before.is_some_and(|(_, kind)| kind.is_some()) => {
                next.is_some_and(|next| is_place_word(self.model, next))
            }
            // "The first block" is one of several, not what is done first.
            [_] if does(Kind::Orders) && before.is_some_and(|(word, _)| word == "the") => {
                syntaxes.is_in_time(syntax) || text == "NP/NP"
            }
            // "Nothing red" is no red thing, not a red place where nothing is.
            [.., last] if matches!(&**last, "nothing" | "anything") && text == "N\\N" => {
                next.is_some_and(|next| is_adjective(self.model, next) || EXCEPT.contains(&&**next))
            }
            [but, ..] if EXCEPT.contains(&&**but) => match text {
                // "But make sure" is another clause, and "the block but the bag" one thing instead of another.
                "N\\N/NP" => {
                    next.is_some_and(|next| {
                        is_verb_word(self.model, next) || FRAMED.contains(&&**next)
                    }) || own.len() == 1 && self.is_one_thing(item.start)
                }
                "N\\N\\(N\\N)/N" => says(&self.words[..item.start], &["nothing", "anything"]),
                _ => false,
            },
            // "No block out of the red room" leaves there what is there: that is no goal of all blocks.
            [.., no] if matches!(&**no, "no" | "none" | "any" | "anything" | "nothing") => {
                let goes_away = |word: &String| AWAY.contains(&&**word);
                text.starts_with("S/PP")
                    && rest.iter().any(goes_away)
                    && (matches!(&**no, "no" | "none" | "nothing")
                        || self.closed[..item.start].contains(&Some(Kind::Turns)))
            }
            // What is said of a thing beside another is of that thing, where it is said to be so as well.
            [and, ..]
                if and == "and" && !does(Kind::Turns) && text == "LIST\\(S/PP/NP)\\NP\\PP/NP" =>
            {
                let as_well = |word: &String| matches!(&**word, "too" | "well" | "also" | "so");
                !own.iter().chain(rest).any(as_well)
            }
            // "The block should go to the red room" sends no robot there.
            [_] if text == "S/PP" && before.is_some_and(|(word, _)| MODALS.contains(&word)) => {
                self.begins_with_thing(item.start)
            }
            // One leaves a place; to leave a thing is to let it be.
            [leave] if text == "S/NP" && matches!(&**leave, "leave" | "leaving") => {
                let noun = rest.iter().position(|word| is_bare_noun(self.model, word));
                noun.is_some_and(|at| {
                    let names_room = |word: &String| matches!(&**word, "room" | "'s");
                    !PLACES.contains(&&*rest[at]) && !rest.get(at + 1).is_some_and(names_room)
                })
            }
            // "And stay out" adds nothing to leaving.
            _ if text == "S\\S" && says(own, &AWAY) && says(own, &LASTS) => {
                !LEAVES.contains(&&*self.words[0])
            }
            // "The red room should contain the chair" says what is to be there, not which room is meant.
            [_] if text.starts_with("N\\N") && says(own, &HOLDS) => {
                before.is_some_and(|(word, _)| MODALS.contains(&word))
            }
            // What was brought somewhere is a clause of its own: "put the chair in the red room and stand next to it".
            _ if text == "LIST\\NP/AP" => self.brings_somewhere(item.start),
            // "Only go there" is no more than that; "only the chair" is said of what is there.
            [_] if text == "S/S" && does(Kind::Limits) => {
                !next.is_some_and(|next| is_verb_word(self.model, next))
            }
            // Where a thing is brought stands first, if not behind it: "into the red room push the chair".
            [_] if text == "S/NP\\PP" => {
                let clause = self.closed[..item.start].iter().rposition(Option::is_some);
                let before = &self.words[clause.map_or(0, |at| at + 1)..item.start];
                before.iter().any(|word| is_verb_word(self.model, word))
            }
            // Beside what was named, "it" is that, where a clause is joined.
            [it] if text == "NP" && is_pronoun(it) => {
                before.is_some_and(|(word, _)| is(self.model, word, is_preposition))
                    && self.closed[..item.start].contains(&Some(Kind::Joins))
            }
            // "The room with the chair and the block in it" has both: nothing is done to the second.
            _ if does(Kind::Joins)
                && (text.ends_with("\\NP/NP") && !text.starts_with("N\\N")
                    || (text.ends_with("/AP") || text.ends_with("/(S\\NP)"))
                        && next.is_some_and(|next| begins_phrase(self.model, next))
                        && !rest.iter().any(|word| is_verb_word(self.model, word))) =>
            {
                self.has(item.start)
            }
            _ => false,
        }
    }

    /// Whether a word limits to one thing.
    fn limits(&self, at: usize) -> bool {
        self.closed[at] == Some(Kind::Limits) || self.words[at] == "nothing"
    }

    /// Whether a word that joins goes on with what was denied before it: no other clause begins behind it, for there stands
    /// no verb, but a place, a noun or what describes one ("the room other than the red and the blue room"). Where a place
    /// follows the noun, it may be a clause without its verb ("the chair out of the red room and the block out of the blue
    /// room"), unless that would be another one in time.
    fn goes_on(&self, at: usize, in_time: bool) -> bool {
        let turns = |kind: &Option<Kind>| *kind == Some(Kind::Turns);
        let behind = (at + 1..self.words.len()).find(|&at| self.closed[at] != Some(Kind::Turns));
        let Some(next) = behind.map(|at| &self.words[at]) else { return false };
        let is_place = (at + 1..=behind.unwrap_or(at)).any(|at| {
            // "The left of the block" is a place, too.
            let at = at + usize::from(self.words[at] == "the");
            self.words.get(at).is_some_and(|word| is_place_word(self.model, word))
        });
        // A place alone is of the thing that is moved, not of the robot.
        let turned = self.closed[..at].iter().any(turns);
        if self.closed[at] != Some(Kind::Joins) || !(turned || is_place && self.moves_thing(at)) {
            return false;
        }
        let end = self.closed.iter().skip(at + 1).position(Option::is_some);
        let mut rest = self.words[at + 1..end.map_or(self.words.len(), |n| at + 1 + n)].iter();
        is_place
            || begins_phrase(self.model, next)
                && (in_time || !rest.any(|word| is_place_word(self.model, word)))
    }

    /// Whether a thing is moved before a place: a verb stands there that takes one, and no place right behind it.
    fn moves_thing(&self, at: usize) -> bool {
        self.words[..at].windows(2).any(|pair| {
            is(self.model, &pair[0], brings_thing) && !is_place_word(self.model, &pair[1])
        })
    }

    /// Whether a thing is brought to a place before: one that is said behind it, and does not only tell which thing it is.
    fn brings_somewhere(&self, end: usize) -> bool {
        let tells = |at: usize| matches!(&*self.words[at - 1], "is" | "are" | "that" | "which");
        let is_place =
            |at: usize| at > 0 && is_place_word(self.model, &self.words[at]) && !tells(at);
        let verb = (0..end).find(|&at| is(self.model, &self.words[at], brings_thing));
        verb.is_some_and(|verb| (verb + 1..end).any(is_place))
    }

    /// Whether a phrase ends at a place that tells what is in another; what should be there is none of that.
    fn has(&self, end: usize) -> bool {
        let before = &self.words[..end];
        let verb = before.iter().rposition(|word| !begins_phrase(self.model, word));
        verb.is_some_and(|at| {
            let is_told = at > 0 && MODALS.contains(&&*before[at - 1]);
            HOLDS.contains(&&*before[at]) && !is_told
        })
    }

    /// Whether "the" and a noun stand before a place: one thing, no several of which some could be excluded.
    fn is_one_thing(&self, at: usize) -> bool {
        at > 1
            && self.words[at - 2] == "the"
            && is_bare_noun(self.model, &self.words[at - 1])
            && !PLACES.contains(&&*self.words[at - 1])
    }

    /// Whether it is said of a thing that something is to become of it, and not what: "the chair should be moved".
    pub(super) fn is_open(&self) -> bool {
        let modal = self.words.iter().position(|word| MODALS.contains(&&**word));
        modal.is_some_and(|at| {
            let says_what = |word: &String| {
                is(self.model, word, is_noun)
                    || is_adjective(self.model, word)
                    || is(self.model, word, is_preposition)
            };
            self.begins_with_thing(at) && !self.words[at + 1..].iter().any(says_what)
        })
    }

    /// Where the verb or place stands before which no clause that begins at a place ends: a thing that is joined to another is
    /// none ("put the chair next to the block and the bag"), nor is one that comes after another that is moved.
    pub(super) fn bare_until(&self, start: usize) -> usize {
        let joint =
            (0..start).rev().find(|&at| self.closed[at].is_some() || self.empty[at].is_none());
        let Some(joint) = joint else { return 0 };
        let joins = match self.closed[joint] {
            Some(Kind::Joins) => true,
            Some(Kind::Orders) => self.moves_thing(joint),
            Some(Kind::Turns) => {
                self.words[..joint].iter().any(|word| is_verb_word(self.model, word))
            }
            _ => false,
        };
        let says = |at: &usize| {
            let word = &self.words[*at];
            is_verb_word(self.model, word)
                || is_place_word(self.model, word)
                    && (*at + 1 < self.words.len() || !is(self.model, word, is_preposition))
        };
        let behind = &self.words[joint + 1..];
        let is_phrase = behind.first().is_some_and(|next| begins_phrase(self.model, next));
        let noun = self.words[joint + 1..].iter().find(|word| is_bare_noun(self.model, word));
        let is_place = noun.is_some_and(|noun| PLACES.contains(&&**noun));
        // "The room that has the chair and the block in it" says no more than what is in it.
        let is_verb = |word: &String| is_verb_word(self.model, word);
        if joins && !is_place && self.has(joint) && !behind.iter().any(is_verb) {
            return usize::MAX;
        }
        if joins && is_phrase && (!is_place || self.moves_thing(joint)) {
            (joint + 1..self.words.len()).find(says).unwrap_or(usize::MAX)
        } else {
            0
        }
    }

    /// Whether a sentence begins with a thing, of which the rest is said: "the chair is never in the red room". What has no
    /// meaning of its own may stand before it, as "make sure" may.
    fn begins_with_thing(&self, end: usize) -> bool {
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

    /// Whether a phrase cannot begin at a place: a noun stands there, and before it what describes it.
    pub(super) fn is_within_phrase(&self, at: usize) -> bool {
        let describes =
            |at: usize| self.closed[at].is_none() && is_adjective(self.model, &self.words[at]);
        at > 0 && describes(at - 1) && is_bare_noun(self.model, &self.words[at])
    }
}

/// Whether one of a list stands among words.
pub(super) fn says(words: &[String], list: &[&str]) -> bool {
    words.iter().any(|word| list.contains(&&**word))
}
