//! What words may newly come to mean. The seed lexicon is what an English speaker brings along: a corpus does not
//! teach that "red" is a place, nor that it says nothing. Only nouns stretch: a "box" may be any movable thing.

use crate::ccg::{Atom, EntryId, Model, Origin, SyntaxId};
use crate::logic::ConstantId;

/// How far the meaning of words is open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Novelty {
    /// They may mean anything, or nothing.
    Any,
    /// They may name other things of the same sort as these nouns do.
    Like(Vec<ConstantId>),
    /// They mean what the seed says.
    None,
}

/// How far the meaning of the words of a span is open.
pub fn novelty(model: &Model, span: &[String]) -> Novelty {
    let settled: Vec<EntryId> = span.iter().flat_map(|word| settled(model, word)).collect();
    if settled.is_empty() {
        return Novelty::Any;
    }
    let is_noun = |id: &EntryId| {
        model.grammar.syntaxes.is(model.lexicon.category(*id).syntax, Atom::N) && span.len() == 1
    };
    let constants = |id| model.lexicon.lexeme(model.lexicon.entry(id).lexeme).constants.iter();
    let nouns: Vec<ConstantId> =
        settled.into_iter().filter(is_noun).flat_map(constants).copied().collect();
    if nouns.is_empty() { Novelty::None } else { Novelty::Like(nouns) }
}

/// The seed entries that have constants for a word alone.
fn settled(model: &Model, word: &str) -> Vec<EntryId> {
    let lexicon = &model.lexicon;
    let has_constants =
        |id: &EntryId| !lexicon.lexeme(lexicon.entry(*id).lexeme).constants.is_empty();
    let entries = lexicon.entries_for_word(word).iter().copied();
    entries.filter(|id| lexicon.origin(*id) == Origin::Seed).filter(has_constants).collect()
}

impl Novelty {
    /// Whether the words may have the syntactic category.
    pub fn admits_syntax(&self, model: &Model, syntax: SyntaxId) -> bool {
        match self {
            Novelty::Any => true,
            Novelty::Like(_) => model.grammar.syntaxes.is(syntax, Atom::N),
            Novelty::None => false,
        }
    }

    /// Whether the words may speak of the constants.
    pub fn admits(&self, model: &Model, constants: &[ConstantId]) -> bool {
        let sorts = |c: ConstantId| model.grammar.sorts.of(model.grammar.terms.name(c));
        match self {
            Novelty::Any => true,
            Novelty::Like(nouns) => constants
                .iter()
                .all(|&constant| nouns.iter().any(|&noun| sorts(noun) == sorts(constant))),
            Novelty::None => false,
        }
    }
}
