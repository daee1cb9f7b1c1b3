//! Where phrases cannot begin or end, and which words none can be silent about, by the words that stand there: what the
//! categories of a span alone would allow.

use super::chart::Lexical;
use super::closed::Kind;
use super::context::{Context, MODALS, PLACES, says};
use super::syntax::{Atom, SyntaxId, Syntaxes};
use super::word_kind::{
    begins_phrase, brings_thing, is, is_adjective, is_bare_noun, is_noun, is_place_word,
    is_preposition, is_verb_word, takes_place,
};

/// With these begins what tells a thing from others.
const TELLS: [&str; 4] = ["that", "which", "who", "where"];

/// Verbs that say what is so.
const IS: [&str; 4] = ["is", "are", "was", "were"];

/// Words of being beside something.
const BESIDE: [&str; 8] =
    ["near", "next", "by", "beside", "close", "adjacent", "alongside", "behind"];

/// Words by which something is brought somewhere.
const TO: [&str; 3] = ["to", "into", "onto"];

/// Words with which a clause begins: no phrase goes on behind them.
const BEGINS: [&str; 6] = ["please", "kindly", "i", "we", "they", "it"];

/// Words of what is wanted or is to be: what is denied does not go on behind them.
const WANTS: [&str; 10] =
    ["want", "wants", "need", "needs", "could", "would", "can", "should", "let", "just"];

/// What a sentence's words keep phrases from, place by place.
pub(super) struct Fences {
    /// Half a phrase would begin: no clause does.
    within: Vec<bool>,
    /// Before which place no clause ends that begins here.
    bare: Vec<usize>,
    /// What is so, or is to become of something, is said here: nothing that tells which thing it is.
    said: Vec<bool>,
    /// What is to become of something is said here, of the noun there.
    becomes: Vec<Option<usize>>,
    /// Where a thing is brought is said here: nothing that tells which thing it is.
    brought: Vec<bool>,
    /// The same, where that was told: no more of where it is to be.
    beside: Vec<bool>,
    /// It is not said what is to become of a thing.
    is_open: bool,
}

impl Fences {
    /// The fences of a sentence.
    pub(super) fn new(context: &Context) -> Fences {
        // Beside what turns round or orders, half a phrase is no clause: "never go to the red, room after the blue room".
        let orders = |kind: &Option<Kind>| matches!(kind, Some(Kind::Turns | Kind::Orders));
        let is_strict = context.closed.iter().any(orders);
        let places = 0..context.words.len();
        let becomes: Vec<_> = places.clone().map(|at| context.of_what(at, &MODALS)).collect();
        let brought: Vec<_> = places.clone().map(|at| context.is_brought(at)).collect();
        let is_said = |at: usize| becomes[at].is_some() || context.of_what(at, &IS).is_some();
        let is_beside = |at: usize| brought[at] && context.was_beside(at);
        Fences {
            within: places.clone().map(|at| is_strict && context.is_within_phrase(at)).collect(),
            bare: places.clone().map(|at| context.bare_until(at)).collect(),
            said: places.clone().map(is_said).collect(),
            beside: places.map(is_beside).collect(),
            becomes,
            brought,
            is_open: context.is_open(),
        }
    }

    /// Whether a category may be that of a span.
    pub(super) fn admit(
        &self,
        syntaxes: &Syntaxes,
        (start, end): (usize, usize),
        syntax: SyntaxId,
    ) -> bool {
        if !syntax.is_sentence() {
            let is_noun = [Atom::N, Atom::NP].iter().any(|&atom| syntaxes.is(syntax, atom));
            let tells =
                |at: usize| self.brought[at] || self.becomes[at].is_some_and(|noun| start <= noun);
            let is_told = is_noun && (start + 1..end).any(tells);
            return !(is_told
                || self.said[start] && syntaxes.describes(syntax)
                || (self.said[start] || self.beside[start]) && syntaxes.goes_on(syntax));
        }
        let is_open = self.is_open && start == 0 && syntax == SyntaxId::S;
        !self.within[start] && end > self.bare[start] && !is_open
    }
}

impl Context<'_> {
    /// Whether an item may be silent about the words behind it that it absorbs. In front of what it takes, no word that waits
    /// for a phrase goes on with another clause ("apart from that, please head for the blue room"), and none that turns round
    /// with a verb ("I no want the bag in the green room").
    pub(super) fn may_absorb(&self, syntaxes: &Syntaxes, item: &Lexical) -> bool {
        let Some((result, argument)) = syntaxes.forward(item.category.syntax) else { return true };
        let waits = [Atom::N, Atom::NP].iter().any(|&atom| syntaxes.is(argument, atom));
        let absorbed = &self.words[item.own.1..item.end];
        if !waits || absorbed.is_empty() {
            return true;
        }
        let turns = self.closed[item.own.0..item.own.1].contains(&Some(Kind::Turns));
        let is_phrase = [Atom::N, Atom::NP, Atom::PP].iter().any(|&atom| syntaxes.is(result, atom));
        let acts = |word: &String| {
            is_verb_word(self.model, word)
                && (!word.ends_with("ing") || !is(self.model, word, takes_place))
        };
        let begins = (turns || is_phrase) && says(absorbed, &BEGINS);
        !(begins || turns && (says(absorbed, &WANTS) || absorbed.iter().any(acts)))
    }

    /// Whether it is said of a thing that something is to become of it, and not what: "the chair should be moved"; or that
    /// something is so of which nothing is known here: "the red room is closed".
    fn is_open(&self) -> bool {
        let end = self.words.len();
        let says_what = |at: usize| {
            let word = &self.words[at];
            is(self.model, word, is_noun)
                || is_adjective(self.model, word)
                || at + 1 < end && is(self.model, word, is_preposition)
        };
        let verb = |verbs: &[&str]| self.words.iter().position(|word| verbs.contains(&&**word));
        let is_left_open = |at: usize| !(at + 1..end).any(says_what);
        verb(&MODALS).is_some_and(|at| self.begins_with_thing(at) && is_left_open(at))
            || verb(&IS).is_some_and(|at| self.begins_with_noun(at) && is_left_open(at))
    }

    /// Where the verb or place stands before which no clause that begins at a place ends: a thing that is joined to another is
    /// none ("put the chair next to the block and the bag"), nor is one that comes after another that is moved.
    fn bare_until(&self, start: usize) -> usize {
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

    /// Of which noun before a place something is said there behind one of these verbs, and not which one it is: "the chair by
    /// the bag should be in the red room".
    fn of_what(&self, at: usize, verbs: &[&str]) -> Option<usize> {
        let own = &self.words[at];
        let is_content = !is_verb_word(self.model, own)
            && (is_place_word(self.model, own)
                || is_adjective(self.model, own)
                || is(self.model, own, is_noun));
        let names = |at: &usize| {
            let word = &self.words[*at];
            is(self.model, word, is_noun) || TELLS.contains(&&**word)
        };
        let noun = (0..at).rev().find(names)?;
        let between = &self.words[noun + 1..at];
        // "Whichever room is red" is told by that; and what the robot should do is done to something.
        let begins = &self.words[noun.saturating_sub(2)..noun];
        let tells = TELLS.contains(&&*self.words[noun]) || says(begins, &["whichever", "whatever"]);
        let is_robot = self.words[noun] == "robot";
        (is_content && !tells && !is_robot && says(between, verbs)).then_some(noun)
    }

    /// Whether at a place it is said where a thing is brought: "the bag to the red room" is no bag that is told by that, as "the
    /// door to the red room" is a door.
    fn is_brought(&self, at: usize) -> bool {
        let (before, behind) = (&self.words[..at], &self.words[at + 1..]);
        let Some(noun) = before.iter().rposition(|word| is(self.model, word, is_noun)) else {
            return false;
        };
        let is_side = |word: &String| matches!(&**word, "left" | "right");
        let goes_on = behind.iter().take(2).any(is_side)
            || behind.first().is_some_and(|next| {
                next == "be" || is_place_word(self.model, next) || is_verb_word(self.model, next)
            });
        TO.contains(&&*self.words[at])
            && !goes_on
            && !PLACES.contains(&&*before[noun])
            && !says(&before[noun + 1..], &TELLS)
            && !says(&before[noun + 1..], &BESIDE)
    }

    /// Whether at a place it is said where a thing is brought that was told from others by what it is beside: "take the bag
    /// near the block to the red room".
    fn was_beside(&self, at: usize) -> bool {
        let before = &self.words[..at];
        let Some(beside) = before.iter().rposition(|word| BESIDE.contains(&&**word)) else {
            return false;
        };
        let names = |words: &[String]| words.iter().any(|word| is(self.model, word, is_noun));
        let verb = before[..beside].iter().rposition(|word| is(self.model, word, brings_thing));
        names(&before[beside..]) && verb.is_some_and(|verb| names(&before[verb..beside]))
    }

    /// Whether a phrase cannot begin at a place: a noun stands there, and before it what describes it.
    fn is_within_phrase(&self, at: usize) -> bool {
        let describes =
            |at: usize| self.closed[at].is_none() && is_adjective(self.model, &self.words[at]);
        at > 0 && describes(at - 1) && is_bare_noun(self.model, &self.words[at])
    }
}
