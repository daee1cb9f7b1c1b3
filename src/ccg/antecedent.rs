//! What is named again: a pronoun, "there" or "one" stands for what was named before it. What an entry says of it without a
//! name, such as *the object* of "it", is replaced by what each phrase before the word means, and a noun by each noun; sorts
//! and the rest of the sentence choose among these, and where they leave two, the sentence has two readings. Nothing is named
//! by what stands behind.

use super::anaphora::{names_noun, names_phrase};
use super::category::Category;
use super::chart::{Chart, ChartConfig, Lexical};
use super::filling::all_edges;
use super::hearing::Hearing;
use super::lexicon::EntryId;
use super::model::Model;
use super::syntax::Atom;
use super::word_kind::{begins_phrase, is, is_adjective, is_bare_noun, is_noun};
use crate::logic::{LogicError, Node, TermId, Terms, read, ty};

/// What entries say of a phrase that is named again.
const PHRASES: [&str; 2] = ["(the:<<e,t>,e> object:<e,t>)", "(the:<<e,t>,e> room:<e,t>)"];

/// What entries say of a noun that is named again.
const NOUNS: [&str; 2] = ["object:<e,t>", "room:<e,t>"];

/// With these goes on what tells a thing from others: "the chair that is in the red room".
const TELLS: [&str; 5] = ["that", "which", "with", "where", "containing"];

/// Phrases that are looked at, and words of one that goes on: outside text is hostile.
const MOST: usize = 8;
const LONGEST: usize = 12;

/// What is named before some place.
struct Named {
    /// What entries say of it without a name.
    unnamed: Vec<TermId>,
    /// Where the words of each end, and what it means.
    named: Vec<(usize, TermId)>,
}

/// Whether a word of these names again what was named before.
pub fn looks_back(words: &[String]) -> bool {
    words.iter().any(|word| names_phrase(word) || names_noun(word))
}

/// The entries of every span of a command, with what their words name again, where something was named before.
pub fn items(model: &mut Model, hearing: &Hearing) -> Vec<Lexical> {
    let items = hearing.items(model);
    let words = &hearing.words;
    if !looks_back(words) {
        return items;
    }
    let phrases = Named { unnamed: unnamed(model, PHRASES), named: phrases(model, hearing) };
    let nouns = Named { unnamed: unnamed(model, NOUNS), named: nouns(model, hearing) };
    let mut all = Vec::with_capacity(items.len());
    for item in items {
        let own = &words[item.start..item.end];
        let meanings = if own.iter().any(|word| names_phrase(word)) {
            phrases.meanings(model, &item)
        } else if own.iter().any(|word| names_noun(word)) {
            nouns.meanings(model, &item)
        } else {
            Vec::new()
        };
        if meanings.is_empty() {
            all.push(item);
        }
        let with = |meaning| Lexical { category: Category { meaning, ..item.category }, ..item };
        all.extend(meanings.into_iter().map(with));
    }
    all
}

/// The terms of what entries say.
fn unnamed(model: &mut Model, all: [&str; 2]) -> Vec<TermId> {
    all.iter().filter_map(|text| read(&mut model.grammar.terms, text).ok()).collect()
}

impl Named {
    /// What an item means with each name for what it leaves unnamed, where that can be.
    fn meanings(&self, model: &mut Model, item: &Lexical) -> Vec<TermId> {
        let grammar = &mut model.grammar;
        let own = item.category.meaning;
        let mut found = Vec::new();
        for &from in &self.unnamed {
            for &(_, name) in self.named.iter().filter(|(end, _)| *end <= item.start) {
                let Ok(meaning) = replaced(&mut grammar.terms, own, from, name) else { continue };
                let is_new = (meaning != own || name == from) && !found.contains(&meaning);
                if is_new && grammar.sorts.fit(&grammar.terms, meaning) {
                    found.push(meaning);
                }
            }
        }
        found
    }
}

/// A term with a closed part of it replaced by another, which is closed, too.
fn replaced(
    terms: &mut Terms,
    term: TermId,
    from: TermId,
    to: TermId,
) -> Result<TermId, LogicError> {
    if term == from {
        return Ok(to);
    }
    match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => Ok(term),
        Node::Lambda { parameter, body } => {
            let body = replaced(terms, body, from, to)?;
            terms.lambda(parameter, body)
        }
        Node::Apply { head, args } => {
            let mut args = args.to_vec();
            for arg in &mut args {
                *arg = replaced(terms, *arg, from, to)?;
            }
            terms.apply_head(head, &args)
        }
    }
}

/// The phrases that name something: where each ends, and what it means.
fn phrases(model: &mut Model, hearing: &Hearing) -> Vec<(usize, TermId)> {
    let words = &hearing.words;
    let is_part = |word: &String| {
        begins_phrase(model, word) || is_adjective(model, word) || is_bare_noun(model, word)
    };
    let part: Vec<bool> = words.iter().map(is_part).collect();
    let starts = (0..words.len()).filter(|&at| part[at] && (at == 0 || !part[at - 1]));
    let spans: Vec<(usize, usize)> = starts
        .filter_map(|start| {
            let end = (start..words.len()).find(|&at| !part[at]).unwrap_or(words.len());
            let noun = (start..end).rev().find(|&at| is(model, &words[at], is_noun))?;
            Some((start, noun + 1))
        })
        .collect();
    let mut found = Vec::new();
    for (start, end) in spans.into_iter().take(MOST) {
        let goes_on = words.get(end).is_some_and(|word| TELLS.contains(&&**word));
        let last = (end..words.len()).find(|&at| hearing.closed[at].is_some());
        let last = last.unwrap_or(words.len()).min(start + LONGEST).max(end);
        let mut ends = (end..=if goes_on { last } else { end }).rev();
        let meaning = ends.find_map(|end| Some((end, phrase(model, words.get(start..end)?)?)));
        found.extend(meaning);
    }
    found
}

/// What words mean as a phrase, if they are one: the best reading.
fn phrase(model: &mut Model, words: &[String]) -> Option<TermId> {
    let hearing = Hearing::new(model, words);
    let items = hearing.items(model);
    let config = ChartConfig { in_time: false, ..ChartConfig::default() };
    let Model { grammar, features, .. } = model;
    let chart = Chart::fill(grammar, features, words.len(), items, all_edges, config);
    let mut roots = chart.roots().map(|edge| chart.edge(edge).category);
    let found = roots.find(|category| {
        grammar.syntaxes.is(category.syntax, Atom::NP)
            && grammar.terms.ty(category.meaning) == ty::ENTITY
    });
    found.map(|category| category.meaning)
}

/// The nouns: where each ends, and what it means most of all.
fn nouns(model: &Model, hearing: &Hearing) -> Vec<(usize, TermId)> {
    let is_noun = |entry: &EntryId| {
        let syntax = model.lexicon.category(*entry).syntax;
        model.grammar.syntaxes.is(syntax, Atom::N)
    };
    let mut found = Vec::new();
    for (at, word) in hearing.words.iter().enumerate() {
        if names_noun(word) || !is_bare_noun(model, word) {
            continue;
        }
        let all = model.lexicon.entries_for_word(word).iter().copied().filter(is_noun);
        let score = |entry: &EntryId| model.entry_score(*entry);
        let best = all.max_by(|a, b| score(a).total_cmp(&score(b)).then_with(|| b.cmp(a)));
        found.extend(best.map(|entry| (at + 1, model.lexicon.category(entry).meaning)));
    }
    found
}
