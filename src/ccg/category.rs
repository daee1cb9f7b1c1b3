//! A category: a syntactic category with a meaning. A small value; its text is `NP/N : (lambda …)`.

use super::syntax::{SyntaxId, Syntaxes};
use crate::logic::{TermId, Terms, print};
use std::cmp::Ordering;

/// Syntax and meaning, both interned: equal exactly when they are the same category.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Category {
    /// What it combines with.
    pub syntax: SyntaxId,
    /// What it means.
    pub meaning: TermId,
}

impl Category {
    /// The order in which ties break: the syntax's text, then the meaning's structure. Never ids.
    pub fn compare(self, other: Self, syntaxes: &Syntaxes, terms: &Terms) -> Ordering {
        if self == other {
            return Ordering::Equal;
        }
        let (a, b) = (syntaxes.text(self.syntax), syntaxes.text(other.syntax));
        a.cmp(b).then_with(|| terms.compare(self.meaning, other.meaning))
    }

    /// `syntax : meaning`
    pub fn print(self, syntaxes: &Syntaxes, terms: &Terms) -> String {
        format!("{} : {}", syntaxes.text(self.syntax), print(terms, self.meaning))
    }
}
