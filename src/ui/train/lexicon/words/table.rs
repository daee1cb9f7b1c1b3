//! What a language has to have a word for about what was learned.

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub lexicon: &'static str,
    pub lexicon_help: &'static str,
    pub search: &'static str,
    pub learned_only: &'static str,
    pub words: &'static str,
    pub category: &'static str,
    pub meaning: &'static str,
    pub weight: &'static str,
    pub uses: &'static str,
    pub from: &'static str,
    pub example: &'static str,
    pub open_row: fn(u32) -> String,
    pub seed: &'static str,
    pub pick: fn(&str) -> String,
    pub shown: fn(u32, u32, u32) -> String,
    pub before: &'static str,
    pub next: &'static str,
    pub leave_out: fn(usize) -> String,
    pub without: fn(usize) -> String,

    // Errors.
    pub errors: &'static str,
    pub no_errors: &'static str,
    pub errs_nowhere: &'static str,
    pub worst: &'static str,
    pub command: &'static str,
    pub right: &'static str,
    pub best_form: &'static str,
    pub unknown: &'static str,
    pub deciders: &'static str,
    pub feature: &'static str,
    pub by: &'static str,
    pub confusion: &'static str,
    pub task: &'static str,
    pub does: &'static str,
    pub nothing: &'static str,
    pub count: &'static str,

    // Two models.
    pub compare: &'static str,
    pub compare_with: &'static str,
    pub no_model: fn(&str) -> String,
    pub compared: &'static str,
    pub robots: &'static str,
    pub alone: fn(&str, u32) -> String,
    pub common: fn(u32) -> String,
    pub moved: &'static str,
}
