//! What claims have in common in every language: how they are taken apart, and how several become one sentence.

use crate::worker::protocol::{Claim, Description, Noun};

/// A language's words for what makes up a sentence.
pub(super) struct Words {
    /// A thing as a subject.
    pub(super) noun: fn(&Noun) -> String,
    /// Where a claim has its first thing.
    pub(super) place: fn(&Claim) -> String,
    /// A claim as a whole.
    pub(super) claim: fn(&Claim) -> String,
    /// "is".
    pub(super) is: &'static str,
}

/// Several claims with a word between them: about one thing, about several things in one place (of which `are` says
/// that they are there), or one after the other.
pub(super) fn joined(words: &Words, all: &[Claim], and: &str, are: &str) -> String {
    let list = |all: Vec<String>| all.join(&format!(" {and} "));
    let parts = all.iter().map(|told| related(told).or_else(|| denied(told)));
    if let Some(parts) = parts.collect::<Option<Vec<_>>>()
        && let [(relation, first), rest @ ..] = &parts[..]
        && !rest.is_empty()
    {
        if rest.iter().all(|(_, nouns)| nouns[0] == first[0]) {
            let places = list(all.iter().map(words.place).collect());
            return format!("{} {} {places}", (words.noun)(&first[0]), words.is);
        }
        let is_same = |(r, nouns): &(&str, &[Noun; 2])| r == relation && nouns[1] == first[1];
        if rest.iter().all(is_same) && all.iter().all(|told| related(told).is_some()) {
            let things = list(parts.iter().map(|(_, nouns)| (words.noun)(&nouns[0])).collect());
            return format!("{things} {are} {}", all.first().map(words.place).unwrap_or_default());
        }
    }
    all.iter().map(words.claim).collect::<Vec<_>>().join(&format!(", {and} "))
}

/// Several things that are to be in one relation to one place: the things, the relation, the place.
pub(super) fn one_place(all: &[Claim]) -> Option<(Vec<&Noun>, &str, &Noun)> {
    let (relation, [_, place]) = related(all.first()?)?;
    let things = all.iter().map(|told| match related(told)? {
        (r, [thing, p]) if r == relation && p == place && *thing != Noun::Robot => Some(thing),
        _ => None,
    });
    let things = things.collect::<Option<Vec<_>>>()?;
    (relation != "eq").then_some((things, relation, place))
}

/// The relation that a claim says to hold, and of what.
pub(super) fn related(told: &Claim) -> Option<(&str, &[Noun; 2])> {
    match told {
        Claim::Related { relation, nouns } => Some((relation, nouns)),
        _ => None,
    }
}

/// The relation that a claim says not to hold, and of what.
pub(super) fn denied(told: &Claim) -> Option<(&str, &[Noun; 2])> {
    match told {
        Claim::Not(inner) => related(inner),
        _ => None,
    }
}

/// What is said to be in the thing at hand, if a claim says that and no more.
pub(super) fn held(told: &Claim) -> Option<&Description> {
    let Claim::Exists(inside) = told else { return None };
    match &inside.claims[..] {
        [told] if related(told) == Some(("in", &[Noun::It, Noun::Outer])) => Some(inside),
        _ => None,
    }
}
