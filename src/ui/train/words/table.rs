//! What a language has to have a word for around the workbench's parts.

use crate::ui::train::action::Tab;

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub parts: &'static str,
    pub tab: fn(Tab) -> &'static str,
}
