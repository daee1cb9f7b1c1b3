//! The Train page in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::ui::page::document::{Model, Origin};
use crate::ui::page::files::Fault;
use crate::ui::page::grammar::English;

/// The words.
pub(super) static ENGLISH: Text = Text {
    phrases: &English,

    training: "Train a parser",
    begin_training: "Train",
    cancel: "Cancel",
    train_help: |n, epochs| {
        format!(
            "It can learn from {n} commands, each shown with the room before and after, in {epochs} passes."
        )
    },
    beginning: "Beginning…",
    training_begun: "Training has begun.",
    training_stopped: "Training was stopped. What was there before is as it was.",
    training_at: |p| {
        format!(
            "Pass {} of {}, command {} of {}. {} with a valid meaning, {} entries in the lexicon.",
            p.epoch, p.epochs, p.example, p.examples, p.valid, p.entries
        )
    },
    trained: |valid, n| {
        format!("Trained: {valid} of {n} commands have a valid meaning. Type a command.")
    },
    model_is: |model: &Model| {
        let report = &model.report;
        let origin = match &model.origin {
            Origin::Shipped => "the model that comes with this page".to_owned(),
            Origin::Trained(corpus) => format!("a model trained here on {corpus}"),
            Origin::File => "a model from a file".to_owned(),
        };
        format!(
            "In use: {origin}. {} of {} commands have a valid meaning, {} entries in its lexicon.",
            report.valid, report.examples, report.entries
        )
    },
    open_model: "Open a model",
    save_model: "Save the model",

    corpus: "What it learns from",
    open_corpus: "Open a corpus",
    corpus_hint: "or drop files anywhere: batch-results CSV, or JSON lines",
    corpus_open: |name, n| format!("{name} is open: {n} commands."),
    no_rows: |name| format!("No row of {name} can be used. What was open before is still open."),
    commands: |n| format!("{n} commands"),
    rejected: |n| format!(", {n} rejected rows left out"),
    left_out: |n| format!(", {n} bad rows left out"),
    use_rejected: "Use rejected rows too",
    reading_stopped: "Reading was stopped. What was open before is still open.",
    problems: |n| format!(", {n} problems"),
    rows_to_look_at: |n| format!("{n} rows to look at"),
    save_corpus: "Save this file",
    six_sentences: "Back to the six sentences",
    more_rows: |n| format!("Show more ({n} left)"),
    demonstrations: |n| format!("{n} demonstration{}", if n == 1 { "" } else { "s" }),
    demonstration: |n| format!("Demonstration {n}, before:"),
    after: "After:",
    reading_row: "Reading…",
    line: |n| format!("line {n}"),
    file: "file",
    row_kept: " · row kept",
    and_more: |n| format!("and {n} more"),
    file_fault: |name, fault| match fault {
        Fault::Empty => {
            format!("{name} is empty. Choose a file with a header line and at least one row.")
        }
        Fault::TooLarge => {
            format!("{name} is larger than 64 MB. Split it and open one part at a time.")
        }
        Fault::Unreadable => format!(
            "{name} could not be read. See whether it is still there, then choose it again."
        ),
        Fault::NotText(line) => format!(
            "{name} is not text in UTF-8 (first seen in line {line}). Save it again as UTF-8, or choose the CSV file itself, not a spreadsheet or an archive."
        ),
    },
};
