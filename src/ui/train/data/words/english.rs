//! The words about the corpus in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::ui::page::files::Fault as FileFault;
use crate::ui::page::grammar::English;
use crate::ui::train::data::mapping::Column;
use crate::worker::protocol::{By, Deed, Half, Outcome, Rule, Status};

/// The words.
pub(super) static ENGLISH: Text = Text {
    phrases: &English,

    corpus: "What it learns from",
    open_corpus: "Open a corpus",
    corpus_hint: "or drop files anywhere: batch-results CSV, tables whose columns you map, JSON lines, packed with gzip or not. At most 64 MB a file (unpacked), 100,000 rows, 1 MB a cell.",
    corpus_open: |name, n| format!("{name} is open: {n} commands."),
    no_rows: |why| format!("No row can be used, and what was open before is still open. {why}"),
    busy: "Training is at work on the corpus that is open. Stop it first, then open another.",
    commands: |n| format!("{n} commands"),
    rejected: |n| format!(", {n} rejected"),
    left_out: |n| format!(", {n} bad {} left out", if n == 1 { "row" } else { "rows" }),
    held_out: |n| format!(", {n} held out"),
    use_rejected: "Use rejected rows too",
    leave_rejected: "Leave rejected rows out",
    reading: "Reading…",
    cancel: "Cancel",
    reading_stopped: "Reading was stopped. What was open before is still open.",
    save_as: "Save with decisions",
    save_csv: "CSV",
    save_json: "JSON lines",
    six_sentences: "Back to the six sentences",
    file_fault: |name, fault| match fault {
        FileFault::Empty => {
            format!("{name} is empty. Choose a file with a header line and at least one row.")
        }
        FileFault::TooLarge => {
            format!("{name} is larger than 64 MB. Split it and open one part at a time.")
        }
        FileFault::Unreadable => format!(
            "{name} could not be read. See whether it is still there, then choose it again."
        ),
        FileFault::NotText(line) => format!(
            "{name} is not text in UTF-8 (first seen in line {line}). Save it again as UTF-8, or choose the CSV file itself, not a spreadsheet or an archive."
        ),
    },

    // Problems.
    problems: |n| format!(", {n} {}", if n == 1 { "problem" } else { "problems" }),
    rows_to_look_at: |n| format!("{n} {} in the file", if n == 1 { "problem" } else { "problems" }),
    line: |n| format!("line {n}"),
    file: "file",
    row_kept: " · row kept",
    and_more: |n| format!("and {n} more"),
    save_bad: |name, n| format!("Save the {n} bad rows of {name}, to mend and drop them again"),

    // Mapping columns.
    map: "Map the columns by hand",
    map_help: |name| {
        format!(
            "These are the first rows of {name}. Say what each column is: the command, and for each demonstration the state before and after."
        )
    },
    column_is: |name| format!("{name} is"),
    column: |column| match column {
        Column::Unused => "not used".to_owned(),
        Column::Command => "command".to_owned(),
        Column::Task => "task".to_owned(),
        Column::Worker => "worker".to_owned(),
        Column::Id => "name of the row".to_owned(),
        Column::Status => "status".to_owned(),
        Column::Approve => "approved".to_owned(),
        Column::Reject => "reason of rejection".to_owned(),
        Column::Before(n) => format!("before, {n}"),
        Column::After(n) => format!("after, {n}"),
    },
    map_use: "Read it so",
    map_save: "Save the mapping",
    map_missing: "A command and at least one demonstration (before and after) are needed.",
    map_again: "A mapping that was saved can be dropped here, or together with the next files.",

    // The table.
    search: "Search commands",
    filter_task: "Task",
    filter_worker: "Worker",
    filter_status: "Status",
    filter_outcome: "Parse",
    filter_half: "Part",
    filter_rule: "Marked",
    any: "any",
    none: "none",
    show_all: "Show all",
    seen: |n, of| if n == of { format!("{n} rows") } else { format!("{n} of {of} rows") },
    table: "Rows of the corpus. Arrow keys move, Enter opens, the space bar picks.",
    command: "Command",
    pairs: "Shown",
    pick: |n| format!("Pick row {n}"),
    status: |status| match status {
        Status::Open => "open",
        Status::Approved => "approved",
        Status::Rejected => "rejected",
    },
    outcome: |outcome| match outcome {
        Outcome::Right => "right",
        Outcome::Tied => "tied with wrong ones",
        Outcome::Lower => "valid, but not best",
        Outcome::Invalid => "no valid reading",
        Outcome::Unread => "no reading",
    },
    rule: |rule| match rule {
        Rule::Invalid => "does not validate under any reading",
        Rule::Strange => "unlike most of its task",
        Rule::Duplicate => "duplicate",
        Rule::Short => "too short",
    },
    half: |half| match half {
        Half::Train => "learned from",
        Half::HeldOut => "held out",
        Half::Aside => "set aside",
    },

    // A row.
    demonstration: |n| format!("Demonstration {n}, before:"),
    after: "After:",
    way: |rooms, n| format!("The way, {n} actions: {rooms}"),
    unlike: |rooms, n| format!("Not like this, {n} actions: {rooms}"),
    close: "Close the row",
    where_from: |id, line| if line > 0 { format!("{id}, line {line}") } else { id.to_owned() },
    readings: |n| if n == 1 { "1 reading".to_owned() } else { format!("{n} readings") },
    valid_for: |valid, n| {
        format!("{} for demonstration {n}", if valid { "valid" } else { "not valid" })
    },
    not_audited: "What the model makes of it is not known yet: ask it under Care.",
    no_reading: |why| format!("The model has no single answer: {why}."),

    // Care.
    care: "Care",
    picked: |n| format!("{n} picked rows"),
    all_seen: |n| format!("all {n} rows in view"),
    with_rows: |rows| format!("With {rows}:"),
    pick_none: "Pick none",
    approve: "Approve",
    reject: "Reject",
    reason: "Reason of rejection",
    reopen: "Reopen",
    put: |half| match half {
        Half::Train => "Learn from",
        Half::HeldOut => "Hold out",
        Half::Aside => "Set aside",
    },
    undo: "Undo the last decision",
    redo: "Do it again",
    done: |done| {
        let rows = done.rows;
        match done.deed {
            Deed::Approve => format!("{rows} rows approved."),
            Deed::Reject => format!("{rows} rows rejected."),
            Deed::Reopen => format!("{rows} rows reopened."),
            Deed::Put(Half::Train) => format!("{rows} rows are learned from."),
            Deed::Put(Half::HeldOut) => format!("{rows} rows are held out."),
            Deed::Put(Half::Aside) => format!("{rows} rows are set aside."),
            Deed::Split => format!("The corpus is parted: {rows} rows changed sides."),
        }
    },
    undone: |what| format!("Undone: {what}"),
    rules: "Rows to look at first",
    find: "Look for short, double and strange rows",
    audit: "Ask the robot's model about every row",
    auditing: |done, of| format!("{done} of {of} rows are judged."),
    audited: "Every row is judged.",
    marked: |n| format!("{n} rows"),

    // Splits.
    split: "Hold rows out",
    split_help: "What is held out is not learned from: a model is judged on it after every pass. Pick rows for a split by hand.",
    share: "Share in percent",
    together: "What stays together",
    by: |by| match by {
        By::Row => "single rows",
        By::Command => "rows of one command",
        By::Task => "rows of one task",
        By::Worker => "rows of one worker",
    },
    seed: "Seed",
    split_share: "Hold this share out",
    split_none: "Hold nothing out",
    split_view: |name| format!("Hold out all of {name}"),
};
