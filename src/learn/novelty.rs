//! What words may newly come to mean. The seed lexicon is what an English speaker brings along: a corpus does not
//! teach that "red" is a place, nor that "the" is a chair. Only nouns stretch: a "box" may be any movable thing.

use crate::ccg::{Atom, EntryId, Model, Origin, SyntaxId, Syntaxes};
use crate::ground::Shade;
use crate::logic::ConstantId;

/// How far the meaning of words is open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Novelty {
    /// They may mean anything, or nothing.
    Any,
    /// They may name other things of the same sort as these nouns do.
    Like(Vec<ConstantId>),
    /// They may mean one of these: a shade is a colour that it is like.
    Shade(Vec<ConstantId>),
    /// They may mean nothing: they frame what others say, as "move" and "the" do, and here there may be no frame.
    Silence,
    /// They may relate things, or mean nothing, as "side" and "on" do by the seed.
    Relation,
    /// They mean what the seed says.
    None,
}

/// How far the meaning of the words of a span is open.
pub fn novelty(model: &Model, span: &[String]) -> Novelty {
    let lexicon = &model.lexicon;
    let constants = |id: EntryId| &lexicon.lexeme(lexicon.entry(id).lexeme).constants;
    let syntax = |id: EntryId| lexicon.category(id).syntax;
    if let Some(colors) = span.iter().find_map(|word| colors(model, word)) {
        return Novelty::Shade(colors);
    }
    let known: Vec<EntryId> = span.iter().flat_map(|word| seed_meanings(model, word)).collect();
    if known.is_empty() {
        let is_new = span.iter().any(|word| !is_filler(model, word));
        return if is_new { Novelty::Any } else { Novelty::Relation };
    }
    if known.iter().all(|&id| constants(id).is_empty()) {
        return Novelty::Silence;
    }
    let is_noun = |&id: &EntryId| model.grammar.syntaxes.is(syntax(id), Atom::N) && span.len() == 1;
    let nouns: Vec<ConstantId> =
        known.into_iter().filter(is_noun).flat_map(constants).copied().collect();
    if nouns.is_empty() { Novelty::None } else { Novelty::Like(nouns) }
}

/// The colours that a shade is like, as far as the seed has words for them; nothing for what is no shade, or one that the
/// seed has a word for.
fn colors(model: &Model, word: &str) -> Option<Vec<ConstantId>> {
    let shade = Shade::named(word).filter(|_| seed_meanings(model, word).next().is_none())?;
    let lexicon = &model.lexicon;
    let entries = shade.colors().flat_map(|(color, _)| seed_meanings(model, color.name()));
    let constants = entries.flat_map(|id| &lexicon.lexeme(lexicon.entry(id).lexeme).constants);
    Some(constants.copied().collect())
}

/// Whether the seed says of a word that it may mean nothing.
fn is_filler(model: &Model, word: &str) -> bool {
    let lexicon = &model.lexicon;
    let is_empty = |&id: &EntryId| lexicon.origin(id) == Origin::Seed && lexicon.is_empty_entry(id);
    lexicon.entries_for_word(word).iter().any(is_empty)
}

/// The seed entries by which a word alone means something.
fn seed_meanings(model: &Model, word: &str) -> impl Iterator<Item = EntryId> {
    let lexicon = &model.lexicon;
    let means = |id: &EntryId| lexicon.origin(*id) == Origin::Seed && !lexicon.is_empty_entry(*id);
    lexicon.entries_for_word(word).iter().copied().filter(means)
}

/// Whether a syntactic category has a thing among its arguments.
fn takes_thing(all: &Syntaxes, syntax: SyntaxId) -> bool {
    let parts = all.forward(syntax).or_else(|| all.backward(syntax));
    parts.is_some_and(|(result, argument)| all.is(argument, Atom::NP) || takes_thing(all, result))
}

impl Novelty {
    /// Whether the words may mean nothing.
    pub fn admits_silence(&self) -> bool {
        matches!(self, Novelty::Any | Novelty::Silence | Novelty::Relation)
    }

    /// Whether the words may have the syntactic category.
    pub fn admits_syntax(&self, model: &Model, syntax: SyntaxId) -> bool {
        match self {
            Novelty::Any | Novelty::Shade(_) => true,
            Novelty::Like(_) => model.grammar.syntaxes.is(syntax, Atom::N),
            Novelty::Relation => takes_thing(&model.grammar.syntaxes, syntax),
            Novelty::Silence | Novelty::None => false,
        }
    }

    /// Whether the words may speak of the constants.
    pub fn admits(&self, model: &Model, constants: &[ConstantId]) -> bool {
        let sorts = |c: ConstantId| model.grammar.sorts.of(model.grammar.terms.name(c));
        match self {
            Novelty::Any | Novelty::Relation => true,
            Novelty::Like(nouns) => constants
                .iter()
                .all(|&constant| nouns.iter().any(|&noun| sorts(noun) == sorts(constant))),
            Novelty::Shade(colors) => {
                !constants.is_empty() && constants.iter().all(|constant| colors.contains(constant))
            }
            Novelty::Silence | Novelty::None => false,
        }
    }
}
