//! What a language has to have a word for on the Train page.

use crate::ui::page::document::Model;
use crate::ui::page::files::Fault;
use crate::ui::page::grammar::Phrases;
use crate::worker::protocol::Progress;

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub phrases: &'static (dyn Phrases + Sync),

    pub training: &'static str,
    pub begin_training: &'static str,
    pub cancel: &'static str,
    pub train_help: fn(usize, u32) -> String,
    pub beginning: &'static str,
    pub training_begun: &'static str,
    pub training_stopped: &'static str,
    pub training_at: fn(&Progress) -> String,
    pub trained: fn(usize, usize) -> String,
    pub model_is: fn(&Model) -> String,
    pub open_model: &'static str,
    pub save_model: &'static str,

    // The corpus.
    pub corpus: &'static str,
    pub open_corpus: &'static str,
    pub corpus_hint: &'static str,
    pub corpus_open: fn(&str, usize) -> String,
    pub no_rows: fn(&str) -> String,
    pub commands: fn(usize) -> String,
    pub rejected: fn(usize) -> String,
    pub left_out: fn(usize) -> String,
    pub use_rejected: &'static str,
    pub reading_stopped: &'static str,
    pub problems: fn(usize) -> String,
    pub rows_to_look_at: fn(usize) -> String,
    pub save_corpus: &'static str,
    pub six_sentences: &'static str,
    pub more_rows: fn(usize) -> String,
    pub demonstrations: fn(usize) -> String,
    pub demonstration: fn(usize) -> String,
    pub after: &'static str,
    pub reading_row: &'static str,
    pub line: fn(u64) -> String,
    pub file: &'static str,
    pub row_kept: &'static str,
    pub and_more: fn(usize) -> String,
    pub file_fault: fn(&str, Fault) -> String,
}
