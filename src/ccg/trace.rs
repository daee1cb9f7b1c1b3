//! A derivation done again with marked constants, so that every constant of every meaning knows the leaf that it came
//! from, exactly, however often a word stands in the sentence.

use super::category::Category;
use super::combinator::{Grammar, RuleId};
use super::derivation::Derivation;
use super::model::Model;
use crate::logic::mark::marked;
use crate::logic::{LogicError, Marks, TermId, Terms};

/// A derivation with marked meanings.
pub struct Trace {
    /// Its constituents: parts before what was made of them, the whole last.
    pub nodes: Vec<Traced>,
    /// The words that each leaf has a meaning for, first and one past the last; marks count leaves.
    leaves: Vec<(usize, usize)>,
    terms: Terms,
}

/// A constituent.
pub struct Traced {
    /// The first word, and one past the last.
    pub words: (usize, usize),
    /// The rule that made it; nothing for one from the lexicon.
    pub rule: Option<RuleId>,
    /// What it is, in the model's arena.
    pub category: Category,
    /// Its meaning, marked.
    meaning: TermId,
    /// Places of its parts among the nodes, from left to right.
    pub parts: Vec<usize>,
}

/// Words in a text: the place of the first and one past the last.
pub type Words = (usize, usize);

impl Trace {
    /// The derivation of a reading that the model made.
    ///
    /// # Errors
    /// When a meaning is too large.
    pub fn of(model: &Model, derivation: &Derivation) -> Result<Trace, LogicError> {
        let mut grammar = Grammar::default();
        for shift in &model.grammar.shifts {
            let mut shift = shift.clone();
            shift.meaning = marked(&model.grammar.terms, shift.meaning, &mut grammar.terms, None)?;
            grammar.shifts.push(shift);
        }
        let mut tracing = Tracing { model, grammar, nodes: Vec::new(), leaves: Vec::new() };
        tracing.add(derivation)?;
        let Tracing { grammar, nodes, leaves, .. } = tracing;
        Ok(Trace { nodes, leaves, terms: grammar.terms })
    }

    /// The meaning of a node as a person writes it: each constant with the words that it came from, what stands
    /// between with none. `plain` is the model's arena.
    pub fn pieces(&self, node: &Traced, plain: &mut Terms) -> Vec<(String, Option<Words>)> {
        let Ok(marks) = Marks::off(&self.terms, node.meaning, plain) else { return Vec::new() };
        let words = |origin: u32| self.leaves.get(origin as usize).copied();
        let pieces = marks.pieces(node.meaning).into_iter();
        pieces.map(|(text, origin)| (text, origin.and_then(words))).collect()
    }

    /// The places of the words that a part of the whole's meaning came from, in order; the part is one of the model's
    /// arena.
    pub fn words_of(&self, part: TermId, plain: &mut Terms) -> Vec<usize> {
        let Some(whole) = self.nodes.last() else { return Vec::new() };
        let Ok(marks) = Marks::off(&self.terms, whole.meaning, plain) else { return Vec::new() };
        let origins = marks.origins(whole.meaning, part);
        let leaves = (0..).zip(&self.leaves).filter(|(leaf, _)| origins.contains(leaf));
        leaves.flat_map(|(_, &(start, end))| start..end).collect()
    }
}

/// A trace at work.
struct Tracing<'a> {
    model: &'a Model,
    /// The model's shifts, over an arena of marked terms.
    grammar: Grammar,
    nodes: Vec<Traced>,
    leaves: Vec<Words>,
}

impl Tracing<'_> {
    /// Adds a derivation's nodes; the place of its root.
    fn add(&mut self, derivation: &Derivation) -> Result<usize, LogicError> {
        let (rule, meaning, parts) = match derivation {
            Derivation::Leaf { own, category, .. } => {
                let origin = u32::try_from(self.leaves.len()).ok();
                self.leaves.push(*own);
                let terms = &self.model.grammar.terms;
                let meaning = marked(terms, category.meaning, &mut self.grammar.terms, origin)?;
                (None, meaning, Vec::new())
            }
            Derivation::Node { rule, children, .. } => {
                let parts: Result<Vec<usize>, LogicError> =
                    children.iter().map(|child| self.add(child)).collect();
                let parts = parts?;
                let meanings: Vec<TermId> =
                    parts.iter().filter_map(|&at| Some(self.nodes.get(at)?.meaning)).collect();
                let meaning = self.grammar.meaning(*rule, &meanings);
                (Some(*rule), meaning.ok_or(LogicError::TooLarge)?, parts)
            }
        };
        let (words, category) = (derivation.span(), derivation.category());
        self.nodes.push(Traced { words, rule, category, meaning, parts });
        Ok(self.nodes.len() - 1)
    }
}
