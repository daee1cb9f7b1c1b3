//! What a language has to have a word for about training.

use crate::ui::page::document::Model;
use crate::ui::train::run::action::Number;
use crate::worker::protocol::{FeatureKind, Progress, Settings};

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub training: &'static str,
    pub train: &'static str,
    pub go_on: &'static str,
    pub pause: &'static str,
    pub pausing: &'static str,
    pub step_example: &'static str,
    pub step_epoch: &'static str,
    pub stop: &'static str,
    pub resume: &'static str,
    pub use_so_far: &'static str,
    pub help: fn(usize, &Settings) -> String,
    pub beginning: &'static str,
    pub begun: &'static str,
    pub stopped: &'static str,
    pub rests: &'static str,
    pub trained: fn(usize, usize) -> String,
    pub at: fn(&Progress) -> String,
    pub times: fn(f64, Option<f64>) -> String,
    pub model_is: fn(&Model) -> String,
    pub open_model: &'static str,
    pub save_model: &'static str,

    // Settings.
    pub settings: &'static str,
    pub paper: &'static str,
    pub are_paper: &'static str,
    pub number: fn(Number) -> &'static str,
    pub idioms: &'static str,
    pub lexicon: &'static str,
    pub lexicons: [&'static str; 3],
    pub own_lexicon: &'static str,
    pub no_lexicon: fn(&str) -> String,
    pub save_curves: &'static str,
    pub without: &'static str,
    pub kind: fn(FeatureKind) -> &'static str,

    // Curves.
    pub curves: &'static str,
    pub held_out: &'static str,
    pub nothing_held_out: &'static str,
    pub precision: &'static str,
    pub recall: &'static str,
    pub f1: &'static str,
    pub valid: &'static str,
    pub updates: &'static str,
    pub entries: &'static str,
    pub pass: &'static str,
    pub as_table: &'static str,

    // What is being learned.
    pub now: &'static str,
    pub nothing_yet: &'static str,
    pub forms: fn(usize) -> String,
    pub valid_in: fn(usize, usize) -> String,
    pub added: &'static str,
    pub moved: &'static str,
    pub moved_by: &'static str,
    pub moved_to: &'static str,
    pub feature: &'static str,
}
