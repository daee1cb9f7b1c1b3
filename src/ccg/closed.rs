//! Closed words: those that turn a sentence round, exclude, join, order or limit (`assets/lexicon/closed.txt`). Invariant:
//! such a word is used with its meaning by an entry of a seed lexicon, or the sentence has no full reading. No learned
//! entry speaks for one, none goes without meaning, and nothing throws one away with an argument.

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
    /// It limits to one thing.
    Limits,
}

const KINDS: [(&str, Kind); 4] = [
    ("turns", Kind::Turns),
    ("joins", Kind::Joins),
    ("orders", Kind::Orders),
    ("limits", Kind::Limits),
];

/// A line's words: one or more, and what they do. A word with `-` before it is an ending.
struct Phrase {
    words: Vec<&'static str>,
    kind: Kind,
}

static PHRASES: LazyLock<Vec<Phrase>> = LazyLock::new(|| {
    let lines = include_str!("../../assets/lexicon/closed.txt").lines();
    let lines = lines.filter_map(|line| line.split('#').next()?.split_once(':'));
    let mut phrases = Vec::new();
    for (name, all) in lines {
        let kind = KINDS.iter().find(|(known, _)| *known == name.trim()).map(|&(_, kind)| kind);
        for phrase in all.split('|').map(str::trim) {
            let words = phrase.split_whitespace().collect();
            // A test holds that every line has a kind.
            phrases.extend(kind.map(|kind| Phrase { words, kind }));
        }
    }
    phrases
});

/// For every word of a command what it does, if it is closed; where several phrases cover a word, the first of the list.
pub fn closed(words: &[impl AsRef<str>]) -> Vec<Option<Kind>> {
    let mut places = vec![None; words.len()];
    for Phrase { words: own, kind } in PHRASES.iter() {
        for start in 0..(words.len() + 1).saturating_sub(own.len()) {
            let here = &words[start..start + own.len()];
            let matches = here.iter().zip(own).all(|(word, own)| match own.strip_prefix('-') {
                Some(ending) => word.as_ref().ends_with(ending),
                None => word.as_ref() == *own,
            });
            if matches {
                places[start..start + own.len()].iter_mut().for_each(|place| {
                    place.get_or_insert(*kind);
                });
            }
        }
    }
    places
}

/// Whether any of the words is closed.
pub fn any_closed(words: &[impl AsRef<str>]) -> bool {
    closed(words).iter().any(Option::is_some)
}

/// The closed words that stand alone, in the list's order: what a misspelt word may be.
pub fn closed_words() -> impl Iterator<Item = &'static str> {
    PHRASES.iter().filter_map(|phrase| match phrase.words[..] {
        [word] if !word.starts_with('-') => Some(word),
        _ => None,
    })
}
