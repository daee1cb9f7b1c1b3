//! What the words of a command are taken for: known words as they stand, misspelt ones as those next to them, and words
//! that the lexicon does not know as those that a general resource has them near, at a price. What was learned of a word
//! goes before both.

use super::absorb::empty_entries;
use super::anaphora::{is_pronoun, is_within_or_out, names_place};
use super::category::Category;
use super::chart::Lexical;
use super::clauses::Clauses;
use super::closed::{Kind, closed};
use super::context::{Context, STATES, says};
use super::features::Feature;
use super::general::{General, Near, Target};
use super::lexicon::{EntryId, Origin, boxed};
use super::lookup::lexical_items;
use super::model::Model;
use super::spelling::heard;
use super::syntax::SyntaxId;
use super::usage::rules::may_mean;
use super::word_kind::is_place_word;
use crate::logic::read;
use std::sync::Arc;

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

    /// The words where they stand.
    pub(super) fn context<'a>(&'a self, model: &'a Model) -> Context<'a> {
        Context { model, words: &self.words, closed: &self.closed, empty: &self.empty }
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
        let context = self.context(model);
        items.retain(|item| may_mean(&context, item));
        items
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
