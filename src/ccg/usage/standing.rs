//! A lexical item where it stands in a sentence.

use crate::ccg::chart::Lexical;
use crate::ccg::closed::Kind;
use crate::ccg::context::Context;
use crate::ccg::model::Model;
use crate::ccg::syntax::{SyntaxId, Syntaxes};
use crate::ccg::word_kind::{begins_phrase, is_place_word, is_verb_word};

/// Words with a category, and what stands before and behind them.
pub(super) struct Standing<'a> {
    pub(super) context: &'a Context<'a>,
    pub(super) item: &'a Lexical,
    /// The category's syntax, as people write it.
    pub(super) text: &'a str,
    /// The words themselves.
    pub(super) own: &'a [String],
    /// All words before them.
    pub(super) so_far: &'a [String],
    /// All words behind them.
    pub(super) rest: &'a [String],
}

/// Whether words do not have their category where they stand.
pub(super) type Rule = fn(&Standing) -> bool;

impl<'a> Standing<'a> {
    pub(super) fn new(context: &'a Context<'a>, item: &'a Lexical) -> Standing<'a> {
        let (so_far, rest) = context.words.split_at(item.start);
        let (own, rest) = rest.split_at(item.end - item.start);
        let text = context.model.grammar.syntaxes.text(item.category.syntax);
        Standing { context, item, text, own, so_far, rest }
    }

    pub(super) fn model(&self) -> &'a Model {
        self.context.model
    }

    pub(super) fn syntaxes(&self) -> &'a Syntaxes {
        &self.context.model.grammar.syntaxes
    }

    pub(super) fn syntax(&self) -> SyntaxId {
        self.item.category.syntax
    }

    /// Whether these are all its words.
    pub(super) fn says(&self, words: &[&str]) -> bool {
        self.own.iter().map(String::as_str).eq(words.iter().copied())
    }

    /// Its word, if it has one alone.
    pub(super) fn word(&self) -> Option<&'a str> {
        match self.own {
            [word] => Some(word),
            _ => None,
        }
    }

    /// The word before it.
    pub(super) fn before(&self) -> Option<&'a str> {
        self.so_far.last().map(String::as_str)
    }

    /// The word behind it.
    pub(super) fn next(&self) -> Option<&'a str> {
        self.rest.first().map(String::as_str)
    }

    /// What its first word does, if that is closed.
    pub(super) fn first(&self) -> Option<Kind> {
        self.context.closed[self.item.start]
    }

    /// What the word before it does, if that is closed.
    pub(super) fn kind_before(&self) -> Option<Kind> {
        self.context.closed[..self.item.start].last().copied().flatten()
    }

    /// Whether one of its words does this.
    pub(super) fn does(&self, kind: Kind) -> bool {
        self.context.closed[self.item.start..self.item.end].contains(&Some(kind))
    }

    /// Whether a word before it does this.
    pub(super) fn did(&self, kind: Kind) -> bool {
        self.context.closed[..self.item.start].contains(&Some(kind))
    }

    /// Whether a word behind it does this.
    pub(super) fn will(&self, kind: Kind) -> bool {
        self.context.closed[self.item.end..].contains(&Some(kind))
    }

    /// Whether a phrase begins behind it.
    pub(super) fn opens_phrase(&self) -> bool {
        self.next().is_some_and(|next| begins_phrase(self.model(), next))
    }

    /// Whether a place begins behind it.
    pub(super) fn opens_place(&self) -> bool {
        self.next().is_some_and(|next| is_place_word(self.model(), next))
    }

    /// Whether a verb stands right behind it.
    pub(super) fn opens_clause(&self) -> bool {
        self.next().is_some_and(|next| is_verb_word(self.model(), next))
    }

    /// Whether a verb stands anywhere behind it.
    pub(super) fn has_verb_behind(&self) -> bool {
        self.rest.iter().any(|word| is_verb_word(self.model(), word))
    }

    /// Whether a place is said anywhere behind it.
    pub(super) fn has_place_behind(&self) -> bool {
        self.rest.iter().any(|word| is_place_word(self.model(), word))
    }
}
