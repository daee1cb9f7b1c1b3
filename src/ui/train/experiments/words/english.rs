//! The words about experiments in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::ui::train::experiments::action::Saved;
use crate::ui::train::experiments::matrix::Kind;
use crate::worker::protocol::By;

/// The words.
pub(super) static ENGLISH: Text = Text {
    experiments: "Experiments",
    help: "Several runs with the settings of the part Train, one after another. What is learned from and what is held out is as the corpus is parted under Data; for the paper's tables open both files and hold out the test file.",
    experiment: "Experiment",
    kind: |kind| match kind {
        Kind::Cross => "Cross-validation",
        Kind::Curve => "Learning curve",
        Kind::Features => "Without each kind of features",
        Kind::Demonstrations => "With 1, 2 and 3 demonstrations",
        Kind::Seeds => "Several seeds",
        Kind::Table2 => "The paper's Table II",
        Kind::Table3 => "The paper's Table III",
    },
    folds: "Parts",
    seeds: "Seeds",
    together: "What stays together",
    by: |by| match by {
        By::Row => "single rows",
        By::Command => "rows of one command",
        By::Task => "rows of one task",
        By::Worker => "rows of one worker",
    },
    needs_held_out: "This one is judged on what is held out: hold rows out under Data first.",
    go: "Run it",
    stop: "Stop",
    repeat: "Repeat the runs of a file",
    no_plan: "This file plans no runs.",
    begun: "The runs have begun.",
    stopped: "The runs were stopped: nothing of them is kept.",
    ended: |n| format!("{n} runs are done."),
    at: |run, runs, name, part| format!("Run {run} of {runs}: {name}. {part}"),
    learning: |p| {
        format!("Pass {} of {}, command {} of {}.", p.epoch, p.epochs, p.example, p.examples)
    },
    judging: |n, of| format!("Judged on {n} of {of} commands."),
    results: "Results",
    none: "Nothing was found yet.",
    run: "Run",
    examples: "Learned from",
    valid: "Valid",
    entries: "Entries",
    precision: "Precision",
    recall: "Recall",
    f1: "F1",
    paper: "Paper",
    all: "all together",
    saved: |saved| match saved {
        Saved::Csv => "Save as CSV",
        Saved::Json => "as JSON",
        Saved::Report => "as a report",
        Saved::Plan => "the runs, to repeat them",
    },
    forget: "Forget this result",
};
