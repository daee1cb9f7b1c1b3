//! What kinds of words there are, by the categories that the seed has them in: nouns, verbs, prepositions and what
//! describes. What was learned of a word makes it no other kind.

use super::lexicon::Origin;
use super::model::Model;
use super::syntax::{Atom, SyntaxId, Syntaxes};

/// Whether the seed has the word in a syntactic category of a kind.
pub(super) fn is(model: &Model, word: &str, kind: fn(&Syntaxes, SyntaxId) -> bool) -> bool {
    model.lexicon.entries_for_word(word).iter().any(|&entry| {
        let syntax = model.lexicon.category(entry).syntax;
        model.lexicon.origin(entry) == Origin::Seed && kind(&model.grammar.syntaxes, syntax)
    })
}

pub(super) fn is_noun(all: &Syntaxes, syntax: SyntaxId) -> bool {
    all.is(syntax, Atom::N)
}

/// `S/PP`, `S/NP` and what takes more.
fn is_verb(all: &Syntaxes, syntax: SyntaxId) -> bool {
    let Some((result, argument)) = all.forward(syntax) else { return false };
    let takes = all.is(argument, Atom::NP) || all.is(argument, Atom::PP);
    takes && (all.is(result, Atom::S) || is_verb(all, result))
}

/// `S/NP`, `S/PP/NP`: what is done to a thing.
pub(super) fn takes_thing(all: &Syntaxes, syntax: SyntaxId) -> bool {
    let takes = all.forward(syntax).is_some_and(|(_, argument)| all.is(argument, Atom::NP));
    takes && is_verb(all, syntax)
}

/// Whether a noun begins with the word, or what describes one, or with a determiner: no verb and no preposition.
pub(super) fn begins_phrase(model: &Model, word: &str) -> bool {
    let is_determiner = |all: &Syntaxes, syntax: SyntaxId| {
        let parts = all.forward(syntax);
        parts.is_some_and(|(result, argument)| {
            all.is(argument, Atom::N) && (all.is(result, Atom::NP) || all.is(result, Atom::N))
        })
    };
    let is_phrase = is(model, word, is_determiner) || is(model, word, is_noun);
    is_phrase && !is(model, word, is_verb) && !is(model, word, is_preposition)
}

/// Whether what describes a noun begins with the word.
pub(super) fn is_adjective(model: &Model, word: &str) -> bool {
    is(model, word, |all, syntax| {
        all.forward(syntax)
            .is_some_and(|parts| [parts.0, parts.1].into_iter().all(|part| all.is(part, Atom::N)))
    })
}

/// Whether the word is a noun and does not describe others.
pub(super) fn is_bare_noun(model: &Model, word: &str) -> bool {
    is(model, word, is_noun) && !is_adjective(model, word)
}

/// Whether a place follows the word, or the word is one.
pub(super) fn is_place_word(model: &Model, word: &str) -> bool {
    is(model, word, is_preposition) || is(model, word, |all, syntax| all.is(syntax, Atom::PP))
}

/// `S/PP/NP`: what brings a thing somewhere.
pub(super) fn brings_thing(all: &Syntaxes, syntax: SyntaxId) -> bool {
    let rest = all.forward(syntax).filter(|&(_, argument)| all.is(argument, Atom::NP));
    rest.is_some_and(|(rest, _)| takes_place(all, rest))
}

/// `S/PP`: what the robot does alone.
pub(super) fn takes_place(all: &Syntaxes, syntax: SyntaxId) -> bool {
    let parts = all.forward(syntax);
    parts.is_some_and(|(result, place)| all.is(result, Atom::S) && all.is(place, Atom::PP))
}

/// Whether the word is one with which a clause begins: what one does.
pub(super) fn is_verb_word(model: &Model, word: &str) -> bool {
    is(model, word, is_verb)
}

/// Whether the word can only begin a noun phrase: no noun, and nothing that describes one.
pub(super) fn is_determiner(model: &Model, word: &str) -> bool {
    begins_phrase(model, word) && !is(model, word, is_noun) && !is_adjective(model, word)
}

/// `PP/NP`.
pub(super) fn is_preposition(all: &Syntaxes, syntax: SyntaxId) -> bool {
    let parts = all.forward(syntax);
    parts.is_some_and(|(result, argument)| all.is(result, Atom::PP) && all.is(argument, Atom::NP))
}
