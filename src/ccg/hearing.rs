//! What the words of a command are taken for: known words as they stand, misspelt ones as those next to them, and words
//! that the lexicon does not know as those that a general resource has them near, at a price. What was learned of a word
//! goes before both.

use super::absorb::empty_entries;
use super::anaphora::{is_pronoun, is_within_or_out, names_place};
use super::category::Category;
use super::chart::Lexical;
use super::clauses::Clauses;
use super::closed::{Kind, closed};
use super::features::Feature;
use super::general::{General, Near, Target};
use super::lexicon::{EntryId, Origin, boxed};
use super::lookup::lexical_items;
use super::model::Model;
use super::spelling::heard;
use super::syntax::{Atom, SyntaxId};
use super::word_kind::{
    begins_phrase, brings_thing, is, is_adjective, is_bare_noun, is_determiner, is_place_word,
    is_verb_word,
};
use crate::logic::read;
use std::sync::Arc;

/// Verbs that say what is somewhere, not what is done to it.
const STATES: [&str; 16] = [
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

/// A command's words as they are heard.
#[derive(Clone, Debug, Default)]
pub struct Hearing {
    /// The words, misspelt ones as the known words next to them.
    pub words: Vec<String>,
    /// For every word what it does, if it is closed.
    pub closed: Vec<Option<Kind>>,
    /// For every word the entry by which it means nothing, if there is one.
    pub empty: Vec<Option<EntryId>>,
}

impl Hearing {
    /// Hears a command's words.
    pub fn new(model: &Model, words: &[String]) -> Self {
        // What was learned of a whole sentence is learned of it as it is spelt.
        let words = match idiom(model, words) {
            Some(_) => words.to_vec(),
            None => heard(model, words),
        };
        let (closed, empty) = (closed(&words), empty_entries(model, &words));
        Hearing { words, closed, empty }
    }

    /// The entries of every span, the lexicon's and those of what unknown words may stand for.
    pub fn items(&self, model: &mut Model) -> Vec<Lexical> {
        let mut items = lexical_items(model, &self.words);
        let general = Arc::clone(model.general());
        for start in 0..self.words.len() {
            let longest = (start + general.longest()).min(self.words.len());
            for end in start + 1..=longest {
                self.understand(model, &general, (start, end), &mut items);
            }
        }
        items.retain(|item| self.may_mean(model, item));
        items
    }

    /// Whether words may have a category where they stand, by what stands around them.
    fn may_mean(&self, model: &Model, item: &Lexical) -> bool {
        let (syntaxes, syntax) = (&model.grammar.syntaxes, item.category.syntax);
        if let Some(clause) = syntaxes.joined(syntax)
            && item.end == item.start + 1
            && self.goes_on(model, item.start, clause == SyntaxId::T)
        {
            return false;
        }
        // "Leave" is said of the place where one is; with more behind it, something else is left.
        if syntax == SyntaxId::LIST && item.end < self.words.len() {
            let joins = matches!(self.closed[item.end], Some(Kind::Joins | Kind::Orders));
            return joins || self.empty[item.end].is_some();
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
        if self.is_out_of_place(model, item) {
            return false;
        }
        // What the robot is not to do says nothing of where a thing is not to be: "take it to the red room but not the blue".
        let of_robot = syntaxes.forbids_place(syntax) && item.end < self.words.len();
        let is_place =
            || syntaxes.is_in_time(syntax) || is_place_word(model, &self.words[item.end]);
        !(of_robot && is_place() && self.moves_thing(model, item.start))
    }

    /// Whether what stands around words shows that they are not used in this category.
    fn is_out_of_place(&self, model: &Model, item: &Lexical) -> bool {
        let (syntaxes, syntax) = (&model.grammar.syntaxes, item.category.syntax);
        let before = item.start.checked_sub(1).map(|at| self.words[at].as_str());
        let next = self.words.get(item.end);
        let opens_phrase = || next.is_some_and(|word| begins_phrase(model, word));
        let (before_it, own) = (&self.words[..item.start], &self.words[item.start..item.end]);
        let rest = &self.words[item.end..];
        let around = [&self.closed[..item.start], &self.closed[item.end..]];
        let joins_others = || around.iter().any(|part| part.contains(&Some(Kind::Joins)));
        match syntaxes.text(syntax) {
            // An adjective is denied where one stands: "not the red room" is no room that is not red.
            "N/N/(N/N)" if self.closed[item.start] == Some(Kind::Turns) => {
                next.is_some_and(|word| is_determiner(model, word))
            }
            // Behind a clause "stay out" is of where that one led.
            "PP" if before.is_some_and(|word| STAYS.contains(&word)) => {
                next.is_none()
                    && is_within_or_out(&self.words[item.start])
                    && self.closed[..item.start].contains(&Some(Kind::Joins))
            }
            // "Any room" is a command by itself, but not behind a preposition: "by any room".
            "S/N" => before.is_some_and(|word| is_place_word(model, word)),
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
                    || opens_phrase() && rest.iter().any(|word| is_place_word(model, word));
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
                opens_phrase() || next.is_some_and(|word| is_place_word(model, word))
            }
            // No bare phrase is forbidden: "take the block without the chair to the red room".
            _ if syntaxes.forbids_along(syntax) => {
                opens_phrase() && !rest.iter().any(|word| is_verb_word(model, word))
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
    fn goes_on(&self, model: &Model, at: usize, in_time: bool) -> bool {
        let turns = |kind: &Option<Kind>| *kind == Some(Kind::Turns);
        let Some(next) = self.words.get(at + 1) else { return false };
        let is_place = is_place_word(model, next);
        // A place alone is of the thing that is moved, not of the robot.
        let turned = self.closed[..at].iter().any(turns);
        if self.closed[at] != Some(Kind::Joins)
            || !(turned || is_place && self.moves_thing(model, at))
        {
            return false;
        }
        let end = self.closed.iter().skip(at + 1).position(Option::is_some);
        let mut rest = self.words[at + 1..end.map_or(self.words.len(), |n| at + 1 + n)].iter();
        is_place
            || begins_phrase(model, next)
                && (in_time || !rest.any(|word| is_place_word(model, word)))
    }

    /// Whether a thing is moved before a place: a verb stands there that takes one, and no place right behind it.
    fn moves_thing(&self, model: &Model, at: usize) -> bool {
        self.words[..at]
            .windows(2)
            .any(|pair| is(model, &pair[0], brings_thing) && !is_place_word(model, &pair[1]))
    }

    /// Whether a phrase cannot begin at a place: a noun stands there, and before it what describes it.
    pub(super) fn is_within_phrase(&self, model: &Model, at: usize) -> bool {
        let describes =
            |at: usize| self.closed[at].is_none() && is_adjective(model, &self.words[at]);
        at > 0 && describes(at - 1) && is_bare_noun(model, &self.words[at])
    }

    /// Whether a word speaks of time: it orders clauses or forbids something on the way. "And" alone does not.
    pub(super) fn is_in_time(&self, model: &Model) -> bool {
        let speaks = |start: usize, end: usize| {
            let own = boxed(&self.words[start..end]);
            let closed = &self.closed[start..end];
            closed.iter().any(|kind| kind.is_some_and(|kind| kind != Kind::Joins))
                && model.lexicon.entries_for(&own).iter().any(|&entry| {
                    model.grammar.syntaxes.is_in_time(model.lexicon.category(entry).syntax)
                })
        };
        (0..self.words.len()).any(|start| {
            let longest = (start + model.lexicon.longest()).min(self.words.len());
            (start + 1..=longest).any(|end| speaks(start, end))
        })
    }

    /// The clauses: one begins where a word that joins or orders stands before an imperative.
    pub fn clauses(&self, model: &Model) -> Clauses {
        let joins = |at: usize| matches!(self.closed[at], Some(Kind::Joins | Kind::Orders));
        let begins = |&at: &usize| {
            let verb = (at..self.words.len()).find(|&at| !joins(at));
            joins(at)
                && !joins(at - 1)
                && verb
                    .is_some_and(|verb| self.commands(model, verb) && !self.looks_back(model, verb))
        };
        (1..self.words.len()).filter(begins).fold(Clauses::ONE, Clauses::with)
    }

    /// Whether a verb is done to a thing that was named before, or beside it, or where that one is: it belongs to that clause.
    fn looks_back(&self, model: &Model, verb: usize) -> bool {
        let joins = |&at: &usize| matches!(self.closed[at], Some(Kind::Joins | Kind::Orders));
        let end = (verb..self.words.len()).find(joins).unwrap_or(self.words.len());
        let next = (verb + 1..end).find(|&at| !is_place_word(model, &self.words[at]));
        // "The room with the basket in it" looks back no further than to itself.
        let is_own = |at: usize| {
            let before_it = &self.words[verb + 1..at];
            says(before_it, &STATES) || says(before_it, &["where", "that", "which"])
        };
        let names = |at: usize| names_place(model, &self.words, &self.closed, at) && !is_own(at);
        match next {
            Some(next) => is_pronoun(&self.words[next]) || (verb + 1..end).any(names),
            None => is_within_or_out(&self.words[end - 1]),
        }
    }

    /// Whether an imperative begins at a place, or something said of one.
    fn commands(&self, model: &Model, at: usize) -> bool {
        let begins = |&entry: &EntryId| {
            let mut syntax = model.lexicon.category(entry).syntax;
            while let Some((result, _)) = model.grammar.syntaxes.forward(syntax) {
                syntax = result;
            }
            syntax == SyntaxId::S
        };
        let longest = (at + model.lexicon.longest()).min(self.words.len());
        let own = boxed(&self.words[at..longest]);
        (1..=own.len()).any(|n| model.lexicon.entries_for(&own[..n]).iter().any(begins))
    }

    /// What the words of a span may stand for, if the lexicon does not know one of them.
    fn understand(
        &self,
        model: &mut Model,
        general: &General,
        (start, end): (usize, usize),
        items: &mut Vec<Lexical>,
    ) {
        let own = &self.words[start..end];
        let is_known = own.iter().all(|word| model.lexicon.knows(word));
        if is_known || self.closed[start..end].iter().any(Option::is_some) {
            return;
        }
        for near in general.near(&own.join(" ")) {
            for entry in entries(model, general, own, near) {
                let (category, far) = (model.lexicon.category(entry), features(near));
                let score = model.entry_score(entry) + model.value(&far);
                let item = entry.item();
                items.push(Lexical { start, end, own: (start, end), category, score, item });
            }
        }
    }
}

/// Whether one of a list stands among words.
fn says(words: &[String], list: &[&str]) -> bool {
    words.iter().any(|word| list.contains(&&**word))
}

/// The idiom that a sentence is, and the place of its words: none stand around them but such as mean nothing.
pub(super) fn idiom(model: &Model, words: &[String]) -> Option<((usize, usize), EntryId)> {
    let n = words.len();
    let whole = boxed(words);
    if let Some(entry) = model.lexicon.idiom(&whole) {
        return Some(((0, n), entry));
    }
    model.lexicon.idioms().next()?;
    let empty = empty_entries(model, words);
    let before = empty.iter().take_while(|entry| entry.is_some()).count();
    let behind = empty.iter().rev().take_while(|entry| entry.is_some()).count();
    let spans = (0..=before)
        .flat_map(|start| (start.max(n - behind)..=n).rev().map(move |end| (start, end)));
    spans
        .into_iter()
        .find_map(|(start, end)| Some(((start, end), model.lexicon.idiom(&whole[start..end])?)))
}

/// What it is scored by that words are taken for something near.
fn features(near: &Near) -> Vec<Feature> {
    let measure = matches!(near.target, Target::Measure(_)).then_some(Feature::Measure);
    let far = std::iter::repeat_n(Feature::Far, usize::from(near.price));
    far.chain(measure).collect()
}

/// The entries of what words may stand for: a word's own, or candidates for a measure.
fn entries(model: &mut Model, general: &General, own: &[String], near: &Near) -> Vec<EntryId> {
    match &near.target {
        Target::Word(word) => {
            let all = model.lexicon.entries_for_word(word).iter().copied();
            all.filter(|&entry| model.lexicon.category(entry).syntax != SyntaxId::EMPTY).collect()
        }
        Target::Measure(constant) => {
            let words = boxed(own);
            let Model { lexicon, grammar, .. } = model;
            let mut found = Vec::new();
            for (syntax, meaning) in general.categories(constant) {
                let syntax = grammar.syntaxes.read(syntax);
                let meaning = read(&mut grammar.terms, &meaning).ok();
                let Some((syntax, meaning)) = syntax.zip(meaning) else { continue };
                let category = Category { syntax, meaning };
                let words = words.clone();
                found.extend(lexicon.add_category(grammar, words, category, Origin::Candidate));
            }
            found
        }
    }
}

/// What words that an entry is used for are taken for, if they are not its own, with what that is scored by.
pub fn taken(model: &Model, words: &[String], entry: EntryId) -> Option<(String, Vec<Feature>)> {
    let own = &model.lexicon.lexeme(model.lexicon.entry(entry).lexeme).words;
    let is_own = own.iter().map(|word| &**word).eq(words.iter().map(String::as_str));
    let near = model.general().near(&words.join(" ")).iter();
    let mut fits = near.filter(|near| match &near.target {
        Target::Word(word) => !is_own && own.len() == 1 && own.first() == Some(word),
        Target::Measure(_) => is_own && model.lexicon.is_candidate(entry),
    });
    let near = fits.next()?;
    let name = match &near.target {
        Target::Word(word) => word.to_string(),
        Target::Measure(constant) => constant.split(':').next().unwrap_or_default().to_owned(),
    };
    Some((name, features(near)))
}
