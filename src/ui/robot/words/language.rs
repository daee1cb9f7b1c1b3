//! The words of every language.

use super::english::ENGLISH;
use super::german::GERMAN;
use super::table::Text;
use crate::ui::page::language::Language;

impl Text {
    /// The words of a language.
    pub const fn of(language: Language) -> &'static Text {
        match language {
            Language::English => &ENGLISH,
            Language::German => &GERMAN,
        }
    }
}
