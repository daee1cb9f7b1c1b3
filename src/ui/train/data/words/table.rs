//! What a language has to have a word for about the corpus.

use crate::ui::page::files::Fault as FileFault;
use crate::ui::page::grammar::Phrases;
use crate::ui::train::data::mapping::Column;
use crate::worker::protocol::{By, Done, Half, Outcome, Rule, Status};

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub phrases: &'static (dyn Phrases + Sync),

    pub corpus: &'static str,
    pub open_corpus: &'static str,
    pub corpus_hint: &'static str,
    pub corpus_open: fn(&str, usize) -> String,
    pub no_rows: fn(&str) -> String,
    pub busy: &'static str,
    pub commands: fn(u32) -> String,
    pub rejected: fn(u32) -> String,
    pub left_out: fn(u32) -> String,
    pub held_out: fn(u32) -> String,
    pub use_rejected: &'static str,
    pub leave_rejected: &'static str,
    pub reading: &'static str,
    pub cancel: &'static str,
    pub reading_stopped: &'static str,
    pub save_as: &'static str,
    pub save_csv: &'static str,
    pub save_json: &'static str,
    pub six_sentences: &'static str,
    pub file_fault: fn(&str, FileFault) -> String,

    // Problems.
    pub problems: fn(usize) -> String,
    pub rows_to_look_at: fn(usize) -> String,
    pub line: fn(u64) -> String,
    pub file: &'static str,
    pub row_kept: &'static str,
    pub and_more: fn(usize) -> String,
    pub save_bad: fn(&str, u32) -> String,

    // Mapping columns.
    pub map: &'static str,
    pub map_help: fn(&str) -> String,
    pub column_is: fn(&str) -> String,
    pub column: fn(Column) -> String,
    pub map_use: &'static str,
    pub map_save: &'static str,
    pub map_missing: &'static str,
    pub map_again: &'static str,

    // The table.
    pub search: &'static str,
    pub filter_task: &'static str,
    pub filter_worker: &'static str,
    pub filter_status: &'static str,
    pub filter_outcome: &'static str,
    pub filter_half: &'static str,
    pub filter_rule: &'static str,
    pub any: &'static str,
    pub none: &'static str,
    pub show_all: &'static str,
    pub seen: fn(u32, u32) -> String,
    pub table: &'static str,
    pub command: &'static str,
    pub pairs: &'static str,
    pub pick: fn(u32) -> String,
    pub status: fn(Status) -> &'static str,
    pub outcome: fn(Outcome) -> &'static str,
    pub rule: fn(Rule) -> &'static str,
    pub half: fn(Half) -> &'static str,

    // A row.
    pub demonstration: fn(usize) -> String,
    pub after: &'static str,
    pub way: fn(&str, usize) -> String,
    pub unlike: fn(&str, usize) -> String,
    pub close: &'static str,
    pub where_from: fn(&str, u64) -> String,
    pub readings: fn(usize) -> String,
    pub valid_for: fn(bool, usize) -> String,
    pub not_audited: &'static str,
    pub no_reading: fn(&str) -> String,

    // Care.
    pub care: &'static str,
    pub picked: fn(usize) -> String,
    pub all_seen: fn(u32) -> String,
    pub with_rows: fn(&str) -> String,
    pub pick_none: &'static str,
    pub approve: &'static str,
    pub reject: &'static str,
    pub reason: &'static str,
    pub reopen: &'static str,
    pub put: fn(Half) -> &'static str,
    pub undo: &'static str,
    pub redo: &'static str,
    pub done: fn(&Done) -> String,
    pub undone: fn(&str) -> String,
    pub rules: &'static str,
    pub find: &'static str,
    pub audit: &'static str,
    pub auditing: fn(u32, u32) -> String,
    pub audited: &'static str,
    pub marked: fn(u32) -> String,

    // Splits.
    pub split: &'static str,
    pub split_help: &'static str,
    pub share: &'static str,
    pub together: &'static str,
    pub by: fn(By) -> &'static str,
    pub seed: &'static str,
    pub split_share: &'static str,
    pub split_none: &'static str,
    pub split_view: fn(&str) -> String,
}
