//! The factored lexicon (Kwiatkowski et al. 2011): a lexeme pairs words with constants, a template is a category
//! with typed holes, an entry pairs the two. Everything is interned in the order it came, which a model file keeps.

use super::category::Category;
use super::combinator::Grammar;
use super::factor::{factor, instantiate};
use super::syntax::SyntaxId;
use crate::logic::{ConstantId, LogicError, Node, TermId, TyId};
use indexmap::{IndexMap, IndexSet};
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

/// Words and constants that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LexemeId(u32);

/// A category with typed holes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TemplateId(u32);

/// A lexeme in a template.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EntryId(u32);

/// Words and what they speak of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Lexeme {
    /// One or more words.
    pub words: Box<[Box<str>]>,
    /// What fills a template's holes, in order.
    pub constants: Box<[ConstantId]>,
}

/// A category with typed holes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Template {
    /// Its syntax.
    pub syntax: SyntaxId,
    /// Its meaning, abstracted over the holes.
    pub meaning: TermId,
    /// The number of holes.
    pub holes: usize,
}

/// What a learned word may put into a hole, besides that the type must fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hole {
    /// Any constant.
    Any,
    /// What says what a thing is: a property of one sort of entity only.
    Noun,
    /// What says how a thing is: a property of several sorts.
    Adjective,
    /// This constant alone: the template speaks of it, whatever the word.
    Only(ConstantId),
}

impl Hole {
    /// The hole behind a constant of an open template's text: `?`, `?noun` and `?adjective`, with digits behind them
    /// to tell holes apart, stand for what words put there; other constants for themselves.
    pub fn of(name: &str, constant: ConstantId) -> Self {
        match name.trim_end_matches(|c: char| c.is_ascii_digit()) {
            "?" => Hole::Any,
            "?noun" => Hole::Noun,
            "?adjective" => Hole::Adjective,
            _ => Hole::Only(constant),
        }
    }
}

/// A lexeme in a template whose holes its constants fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Entry {
    /// The lexeme.
    pub lexeme: LexemeId,
    /// The template.
    pub template: TemplateId,
}

/// Where an entry came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Origin {
    /// From the seed lexicon.
    Seed,
    /// Learned from examples.
    Learned,
    /// A candidate of lexical generation: no part of the lexicon.
    Candidate,
}

#[derive(Clone, Copy, Debug)]
struct Known {
    category: Category,
    origin: Origin,
}

/// Lexemes, templates and entries. Candidates are kept apart: only [`Lexicon::admit`] makes one part of the lexicon.
#[derive(Clone, Debug, Default)]
pub struct Lexicon {
    lexemes: IndexSet<Lexeme, FxBuildHasher>,
    templates: IndexSet<Template, FxBuildHasher>,
    entries: IndexMap<Entry, Known, FxBuildHasher>,
    by_words: FxHashMap<Box<[Box<str>]>, Vec<EntryId>>,
    vocabulary: FxHashSet<Box<str>>,
    longest: usize,
    /// The lexicon proper, in the order the entries came into it.
    admitted: Vec<EntryId>,
    /// Whole sentences with a meaning of their own, heard only when nothing else is said.
    idioms: IndexMap<Box<[Box<str>]>, EntryId, FxBuildHasher>,
    /// The templates that learned words may fill, with what may stand in their holes.
    pub open: IndexMap<TemplateId, Box<[Hole]>, FxBuildHasher>,
    /// Constants that templates keep, besides connectives and determiners.
    pub frame: Vec<ConstantId>,
}

/// Words as the lexicon has them.
pub(crate) fn boxed(words: &[String]) -> Box<[Box<str>]> {
    words.iter().map(|word| Box::from(word.as_str())).collect()
}

impl Lexicon {
    /// The lexeme behind an id.
    pub fn lexeme(&self, id: LexemeId) -> &Lexeme {
        &self.lexemes[id.0 as usize]
    }

    /// The template behind an id.
    pub fn template(&self, id: TemplateId) -> &Template {
        &self.templates[id.0 as usize]
    }

    /// Lexeme and template of an entry.
    #[expect(clippy::expect_used, reason = "ids never leave their lexicon (invariant 6)")]
    pub fn entry(&self, id: EntryId) -> Entry {
        *self.entries.get_index(id.0 as usize).expect("an id comes from this lexicon").0
    }

    /// The category of an entry.
    pub fn category(&self, id: EntryId) -> Category {
        self.entries[id.0 as usize].category
    }

    /// Where an entry came from.
    pub fn origin(&self, id: EntryId) -> Origin {
        self.entries[id.0 as usize].origin
    }

    /// Whether an entry is no part of the lexicon yet.
    pub fn is_candidate(&self, id: EntryId) -> bool {
        self.origin(id) == Origin::Candidate
    }

    /// Whether an entry says that its words mean nothing.
    pub fn is_empty_entry(&self, id: EntryId) -> bool {
        self.is_empty_template(self.entry(id).template)
    }

    /// Whether a template is that of words without meaning.
    pub fn is_empty_template(&self, id: TemplateId) -> bool {
        self.template(id).syntax == SyntaxId::EMPTY
    }

    /// All templates, in the order they came.
    pub fn templates(&self) -> impl Iterator<Item = (TemplateId, &Template)> {
        (0..).map(TemplateId).zip(&self.templates)
    }

    /// The entries of the lexicon proper, in the order they came into it.
    pub fn entries(&self) -> &[EntryId] {
        &self.admitted
    }

    /// The number of entries of the lexicon proper.
    pub fn len(&self) -> usize {
        self.admitted.len()
    }

    /// Whether the lexicon has no entry.
    pub fn is_empty(&self) -> bool {
        self.admitted.is_empty()
    }

    /// The most words that an entry of the lexicon proper has.
    pub fn longest(&self) -> usize {
        self.longest
    }

    /// The lexicon's entries for these words, in the order they came.
    pub fn entries_for(&self, words: &[Box<str>]) -> &[EntryId] {
        self.by_words.get(words).map_or(&[], Vec::as_slice)
    }

    /// Whether any entry that came after so many stands in these words.
    pub fn says_more(&self, then: usize, words: &[String]) -> bool {
        self.admitted.iter().skip(then).any(|&id| {
            let own = &self.lexeme(self.entry(id).lexeme).words;
            let same = |here: &[String]| here.iter().zip(own).all(|(a, b)| **a == **b);
            words.windows(own.len().max(1)).any(same)
        })
    }

    /// Whether the word occurs in any entry of the lexicon proper.
    pub fn knows(&self, word: &str) -> bool {
        self.vocabulary.contains(word)
    }

    /// The entries for a word alone.
    pub fn entries_for_word(&self, word: &str) -> &[EntryId] {
        self.entries_for(&[Box::from(word)])
    }

    /// Whether an entry for the word alone has constants, and none of the seed says that it may mean nothing.
    pub fn has_content(&self, word: &str) -> bool {
        let entries = self.entries_for_word(word);
        let lexeme = |id: EntryId| self.lexeme(self.entry(id).lexeme);
        let may_be_empty =
            |&id: &EntryId| self.is_empty_entry(id) && self.origin(id) == Origin::Seed;
        entries.iter().any(|&id| !lexeme(id).constants.is_empty())
            && !entries.iter().any(may_be_empty)
    }

    /// Whether an entry for the word alone says more than that it means nothing.
    pub fn has_meaning(&self, word: &str) -> bool {
        self.entries_for_word(word).iter().any(|&id| !self.is_empty_entry(id))
    }

    /// The words that occur in entries of the lexicon proper, in no particular order.
    pub(super) fn vocabulary(&self) -> impl Iterator<Item = &str> {
        self.vocabulary.iter().map(|word| &**word)
    }

    /// Adds a template: a meaning abstracted over `holes` holes.
    pub fn add_template(&mut self, syntax: SyntaxId, meaning: TermId, holes: usize) -> TemplateId {
        let (place, _) = self.templates.insert_full(Template { syntax, meaning, holes });
        TemplateId(place as u32)
    }

    /// The template of that place in the order of a model file.
    pub fn template_at(&self, place: usize) -> Option<TemplateId> {
        (place < self.templates.len()).then_some(TemplateId(place as u32))
    }

    /// The place of a template in the order of a model file.
    pub fn template_place(&self, id: TemplateId) -> usize {
        id.0 as usize
    }

    /// The types of a template's holes.
    pub fn holes(&self, grammar: &Grammar, id: TemplateId) -> Vec<TyId> {
        let template = self.template(id);
        let mut types = Vec::new();
        let mut meaning = template.meaning;
        while types.len() < template.holes {
            let Node::Lambda { parameter, body } = grammar.terms.node(meaning) else { break };
            types.push(parameter);
            meaning = body;
        }
        types
    }

    /// Adds a whole category for words, factored.
    ///
    /// # Errors
    /// When the category cannot be factored.
    pub fn add_category(
        &mut self,
        grammar: &mut Grammar,
        words: Box<[Box<str>]>,
        category: Category,
        origin: Origin,
    ) -> Result<EntryId, LogicError> {
        let factored = factor(&mut grammar.terms, category.meaning, &self.frame)?;
        let holes = factored.constants.len();
        let template = self.add_template(category.syntax, factored.template, holes);
        self.add(grammar, Lexeme { words, constants: factored.constants.into() }, template, origin)
    }

    /// Gives a whole sentence a category, in place of one that it has already. It is no part of the lexicon proper: no
    /// word is known by it.
    ///
    /// # Errors
    /// When the category cannot be factored.
    pub fn add_idiom(
        &mut self,
        grammar: &mut Grammar,
        words: Box<[Box<str>]>,
        category: Category,
    ) -> Result<EntryId, LogicError> {
        let entry = self.add_category(grammar, words.clone(), category, Origin::Candidate)?;
        self.idioms.insert(words, entry);
        Ok(entry)
    }

    /// The entry of a whole sentence, if it is an idiom.
    pub fn idiom(&self, words: &[Box<str>]) -> Option<EntryId> {
        self.idioms.get(words).copied()
    }

    /// The idioms, in the order they came.
    pub fn idioms(&self) -> impl Iterator<Item = (&[Box<str>], EntryId)> {
        self.idioms.iter().map(|(words, &entry)| (&**words, entry))
    }

    /// The id of a lexeme, with or without entries.
    pub fn intern_lexeme(&mut self, lexeme: Lexeme) -> LexemeId {
        LexemeId(self.lexemes.insert_full(lexeme).0 as u32)
    }

    /// Adds a lexeme in a template. An entry that is known keeps the stronger origin.
    ///
    /// # Errors
    /// When the constants do not fit the template's holes.
    pub fn add(
        &mut self,
        grammar: &mut Grammar,
        lexeme: Lexeme,
        template: TemplateId,
        origin: Origin,
    ) -> Result<EntryId, LogicError> {
        let Template { syntax, meaning, holes } = *self.template(template);
        if lexeme.constants.len() != holes {
            return Err(LogicError::TypeMismatch);
        }
        let meaning = instantiate(&mut grammar.terms, meaning, &lexeme.constants)?;
        let entry = Entry { lexeme: self.intern_lexeme(lexeme), template };
        let known = Known { category: Category { syntax, meaning }, origin: Origin::Candidate };
        let id = match self.entries.get_index_of(&entry) {
            Some(place) => EntryId(place as u32),
            None => EntryId(self.entries.insert_full(entry, known).0 as u32),
        };
        if origin != Origin::Candidate {
            self.admit(id, origin);
        }
        Ok(id)
    }

    /// Makes an entry part of the lexicon; `true` when it was not before.
    pub fn admit(&mut self, id: EntryId, origin: Origin) -> bool {
        let lexeme = self.entry(id).lexeme;
        let known = &mut self.entries[id.0 as usize];
        let new = known.origin == Origin::Candidate && origin != Origin::Candidate;
        known.origin = known.origin.min(origin);
        if new {
            let words = self.lexemes[lexeme.0 as usize].words.clone();
            self.longest = self.longest.max(words.len());
            self.vocabulary.extend(words.iter().cloned());
            self.by_words.entry(words).or_default().push(id);
            self.admitted.push(id);
        }
        new
    }
}

impl EntryId {
    /// The number by which a chart's lexical item names the entry.
    pub fn item(self) -> u32 {
        self.0
    }

    /// The entry that a chart's lexical item names.
    pub fn from_item(item: u32) -> Self {
        EntryId(item)
    }
}
