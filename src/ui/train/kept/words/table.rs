//! What a language has to have a word for about what is kept.

use crate::ui::page::keep::fault::Fault;
use crate::ui::train::kept::state::Kind;

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub title: &'static str,
    pub help: &'static str,
    pub name: &'static str,
    pub keep_corpus: &'static str,
    pub keep_model: &'static str,
    pub nothing: &'static str,
    pub kind: fn(Kind) -> &'static str,
    pub what: &'static str,
    pub called: &'static str,
    pub when: &'static str,
    pub size: &'static str,
    pub open: &'static str,
    pub save: &'static str,
    pub delete: &'static str,
    pub sum: fn(usize, &str) -> String,
    pub keep_here: &'static str,
    pub deleted: fn(&str) -> String,
    pub written: fn(&str) -> String,
    pub opened: fn(&str) -> String,
    pub was_damaged: fn(&str) -> String,
    pub gone: fn(&str) -> String,
    pub no_corpus: fn(&str) -> String,
    pub wrong: fn(&str, &str) -> String,
    pub is_back: fn(&str) -> String,
    pub goes_on: fn(&str, u32, usize) -> String,
    pub fault: fn(&Fault) -> String,
    pub run_fault: fn(&Fault, Option<(u32, usize)>) -> String,
}
