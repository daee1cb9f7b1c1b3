//! Closed words: those that turn a sentence round, exclude, join, order or limit (`assets/lexicon/closed.txt`). Invariant:
//! such a word is used with its meaning by an entry of a seed lexicon, or the sentence has no full reading. No learned
//! entry speaks for one, none goes without meaning, and nothing throws one away with an argument.

use super::alternatives::alternatives;
use crate::logic::order;
use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;

/// What would become of a sentence without the word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The opposite: it denies, excludes or goes away.
    Turns,
    /// Half of it: it joins two things, or chooses between them.
    Joins,
    /// It orders in time or sets a condition.
    Orders,
    /// Less, or more: it limits to one thing, or speaks of all.
    Limits,
    /// What no goal here can be: no entry speaks for it.
    Bars,
}

const KINDS: [(&str, Kind); 5] = [
    ("turns", Kind::Turns),
    ("joins", Kind::Joins),
    ("orders", Kind::Orders),
    ("limits", Kind::Limits),
    ("bars", Kind::Bars),
];

/// Before a word with which a sentence begins.
const BEGINS: char = '^';

/// A line's words: one or more, and what they do. A word with `-` before it is an ending, one with `^` begins the sentence.
struct Phrase {
    words: Vec<String>,
    kind: Kind,
}

/// All phrases in the list's order, and where those stand that begin with a word, or with an ending.
#[derive(Default)]
struct Phrases {
    all: Vec<Phrase>,
    by_word: FxHashMap<String, Vec<usize>>,
    by_ending: Vec<(String, usize)>,
}

static PHRASES: LazyLock<Phrases> = LazyLock::new(|| {
    let lines = include_str!("../../assets/lexicon/closed.txt").lines();
    let lines = lines.filter_map(|line| line.split('#').next()?.split_once(':'));
    let mut phrases = Phrases::default();
    for (name, all) in lines {
        let kind = KINDS.iter().find(|(known, _)| *known == name.trim()).map(|&(_, kind)| kind);
        for phrase in alternatives(all).unwrap_or_default() {
            let words: Vec<String> = phrase.split_whitespace().map(str::to_owned).collect();
            // A test holds that every line can be read and has a kind.
            let (Some(first), Some(kind)) = (words.first(), kind) else { continue };
            let place = phrases.all.len();
            match first.strip_prefix('-') {
                Some(ending) => phrases.by_ending.push((ending.to_owned(), place)),
                None => {
                    let word = first.trim_start_matches(BEGINS).to_owned();
                    phrases.by_word.entry(word).or_default().push(place);
                }
            }
            phrases.all.push(Phrase { words, kind });
        }
    }
    phrases
});

/// For every word of a command what it does, if it is closed; where several phrases cover a word, the first of the list.
pub fn closed(words: &[impl AsRef<str>]) -> Vec<Option<Kind>> {
    let Phrases { all, by_word, by_ending } = &*PHRASES;
    let mut found: Vec<(usize, usize)> = Vec::new();
    for (start, first) in words.iter().enumerate() {
        let ends = |(ending, _): &&(String, usize)| first.as_ref().ends_with(ending.as_str());
        let ending = by_ending.iter().filter(ends).map(|&(_, place)| place);
        let same = by_word.get(first.as_ref()).into_iter().flatten().copied();
        let may_begin = |place: usize| start == 0 || !all[place].words[0].starts_with(BEGINS);
        let begun = same
            .chain(ending)
            .filter(|&place| may_begin(place) && stands(&all[place].words, &words[start..]));
        found.extend(begun.map(|place| (place, start)));
    }
    order::sort_by_key(&mut found, |&one| one);
    let mut places = vec![None; words.len()];
    for (place, start) in found {
        let Phrase { words: own, kind } = &all[place];
        places[start..start + own.len()].iter_mut().for_each(|place| {
            place.get_or_insert(*kind);
        });
    }
    places
}

/// Whether words begin with those of a phrase.
fn stands(own: &[String], words: &[impl AsRef<str>]) -> bool {
    let mut both = words.iter().map(AsRef::as_ref).zip(own);
    own.len() <= words.len()
        && both.all(|(word, own): (&str, &String)| match own.strip_prefix('-') {
            Some(ending) => word.ends_with(ending),
            None => word == own.trim_start_matches(BEGINS),
        })
}

/// Whether any of the words is closed.
pub fn any_closed(words: &[impl AsRef<str>]) -> bool {
    closed(words).iter().any(Option::is_some)
}

/// The closed words that stand alone, in the list's order: what a misspelt word may be.
pub fn closed_words() -> impl Iterator<Item = &'static str> {
    PHRASES.all.iter().filter_map(|phrase| match &phrase.words[..] {
        [word] if !word.starts_with(['-', BEGINS]) => Some(word.as_str()),
        _ => None,
    })
}
