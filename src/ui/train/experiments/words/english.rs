//! The words about experiments in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::ui::train::experiments::action::Saved;
use crate::ui::train::experiments::matrix::Kind;
use crate::worker::protocol::By;

/// The words.
pub(super) static ENGLISH: Text = Text {
    experiments: "Experiments",
    help: "Several runs with the settings of the part Train, shared out among as many engines as the machine has room for, at most four; one would find the same. What is learned from and what is held out is as the corpus is parted under Data.",
    of_paper: "The paper’s experiments",
    paper_help: "One press each, on the corpus that is open. For the paper’s own figures open its training and test files together and hold out the test file under Data.",
    paper_share: "Nothing is held out yet: a fifth of the commands will be, drawn with the seed of the settings. It can be undone under Data.",
    about: |kind| match kind {
        Kind::Table2 { is_raw: false } => {
            "learning from 3, 2 and 1 demonstrations a command, beside the paper’s figures for its pruned set"
        }
        Kind::Table2 { is_raw: true } => "the same, beside the figures for its raw set",
        Kind::Table3 => "learning without a planner and with one of horizon 1, 10 and 20",
        _ => "",
    },
    six: "The six sentences",
    about_six: "Section VII: learns from six sentences, then does what none of them says; the corpus that is open stays",
    six_learned: |n, right| {
        format!("Learned from {n} sentences; {right} of them are answered as they were shown.")
    },
    never_heard: "Never heard:",
    carried_out: |steps| format!("It was carried out in {steps} steps."),
    not_done: |reason| format!("It was not carried out: {reason}."),
    paper_six: "The paper: the unseen “go to the blue room” was carried out.",
    pool: |done, runs, engines| match engines {
        1 => format!("{done} of {runs} runs are done."),
        _ => format!("{done} of {runs} runs are done, by {engines} engines."),
    },
    experiment: "Experiment",
    kind: |kind| match kind {
        Kind::Cross => "Cross-validation",
        Kind::Curve => "Learning curve",
        Kind::Features => "Without each kind of features",
        Kind::Demonstrations => "With 1, 2 and 3 demonstrations",
        Kind::Seeds => "Several seeds",
        Kind::Table2 { is_raw: false } => "Table II, pruned",
        Kind::Table2 { is_raw: true } => "Table II, raw",
        Kind::Table3 => "Table III",
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
    was_lost: |name| {
        format!(
            "“{name}” was at work when the page was left: what its runs had found is lost. Run it once more."
        )
    },
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
        Saved::Svg => "as SVG",
        Saved::Json => "as JSON",
        Saved::Report => "as a report",
        Saved::Plan => "the runs, to repeat them",
    },
    settings: |s| {
        format!(
            "The first run: seed {}, {} passes, beams {} and {}.",
            s.seed, s.epochs, s.beam, s.lexical_beam
        )
    },
    forget: "Delete this result",
};
