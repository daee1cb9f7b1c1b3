//! What a language has to have a word for about experiments.

use crate::ui::train::experiments::action::Saved;
use crate::ui::train::experiments::matrix::Kind;
use crate::worker::protocol::{By, Progress};

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub experiments: &'static str,
    pub help: &'static str,
    pub of_paper: &'static str,
    pub paper_help: &'static str,
    pub paper_share: &'static str,
    pub about: fn(Kind) -> &'static str,
    pub six: &'static str,
    pub about_six: &'static str,
    pub six_learned: fn(usize, usize) -> String,
    pub never_heard: &'static str,
    pub carried_out: fn(usize) -> String,
    pub not_done: fn(&str) -> String,
    pub paper_six: &'static str,
    pub pool: fn(usize, usize, u32) -> String,
    pub experiment: &'static str,
    pub kind: fn(Kind) -> &'static str,
    pub folds: &'static str,
    pub seeds: &'static str,
    pub together: &'static str,
    pub by: fn(By) -> &'static str,
    pub needs_held_out: &'static str,
    pub go: &'static str,
    pub stop: &'static str,
    pub repeat: &'static str,
    pub no_plan: &'static str,
    pub begun: &'static str,
    pub stopped: &'static str,
    pub ended: fn(usize) -> String,
    pub at: fn(usize, usize, &str, &str) -> String,
    pub learning: fn(&Progress) -> String,
    pub judging: fn(usize, usize) -> String,
    pub results: &'static str,
    pub none: &'static str,
    pub run: &'static str,
    pub examples: &'static str,
    pub valid: &'static str,
    pub entries: &'static str,
    pub precision: &'static str,
    pub recall: &'static str,
    pub f1: &'static str,
    pub paper: &'static str,
    pub all: &'static str,
    pub saved: fn(Saved) -> &'static str,
    pub forget: &'static str,
}
