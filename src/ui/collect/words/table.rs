//! What a language has to have a word for where people take part in a study.

use crate::study::ends::Refusal;
use crate::ui::collect::action::Trouble;
use crate::ui::page::grammar::Scenes;
use crate::ui::page::keep::fault::Fault;

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub grammar: &'static (dyn Scenes + Sync),
    pub loading: &'static str,
    pub no_study: &'static str,
    pub trouble: fn(&Trouble) -> String,
    pub other_language: &'static str,

    // Before it begins.
    pub welcome: &'static str,
    pub consent: &'static str,
    pub consent_title: &'static str,
    pub posts_to: fn(&[String]) -> String,
    pub posts_nowhere: &'static str,
    pub preview: &'static str,
    pub simulated: &'static str,
    pub agree: &'static str,
    pub instructions_title: &'static str,
    pub instructions: &'static str,
    pub instructions_runs: &'static str,
    pub example: &'static str,
    pub example_said: &'static str,
    pub begin: &'static str,

    // Items.
    pub item: fn(usize, usize) -> String,
    pub ask: fn(usize) -> String,
    pub showing: fn(usize) -> String,
    pub before: &'static str,
    pub after: &'static str,
    pub show_change: &'static str,
    pub hide_change: &'static str,
    pub play: &'static str,
    pub pause: &'static str,
    pub one_step: &'static str,
    pub step: fn(usize, usize) -> String,
    pub command: &'static str,
    pub hint: &'static str,
    pub next: &'static str,
    pub kept: &'static str,
    pub keeping: &'static str,
    pub fault: fn(&Fault) -> String,

    // Two tabs, and visits that were broken off.
    pub elsewhere: &'static str,
    pub take: &'static str,
    pub refused: &'static str,

    // Ends.
    pub end_title: &'static str,
    pub sending: fn(&str) -> String,
    pub not_sent: fn(&str, u32) -> String,
    pub try_again: &'static str,
    pub form: fn(&str) -> String,
    pub submit: &'static str,
    pub code: &'static str,
    pub copy: &'static str,
    pub copied: &'static str,
    pub go_on: &'static str,
    pub file: &'static str,
    pub save: &'static str,
    pub file_sent: &'static str,
    pub back: fn(&str) -> String,
    pub go_back: &'static str,
    pub refusal: fn(&Refusal) -> String,
    pub end_preview: &'static str,

    // When it is over, and leaving before.
    pub thanks: &'static str,
    pub over_code: &'static str,
    pub over_form: &'static str,
    pub erased: &'static str,
    pub delete: &'static str,
    pub withdraw: &'static str,
    pub sure: &'static str,
    pub withdraw_yes: &'static str,
    pub withdraw_no: &'static str,
    pub withdrawn: &'static str,
}
