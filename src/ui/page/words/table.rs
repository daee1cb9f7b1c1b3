//! What a language has to have a word for wherever one is on the page.

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub copied: &'static str,
    pub not_copied: &'static str,
    pub share: &'static str,

    // The engines.
    pub engine_stopped: &'static str,
    pub engine_kept: &'static str,
    pub engine_restart: &'static str,
    pub engine_stopped_said: &'static str,
    pub engine_starting: &'static str,
    pub engine_silent: &'static str,
    pub other_version: &'static str,

    // The model.
    pub no_model: fn(&str) -> String,
    pub model_opened: fn(usize) -> String,

    // The foot, and what is dropped on the page.
    pub stays_here: &'static str,
    pub drop_here: &'static str,
}
