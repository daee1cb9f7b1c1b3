//! The languages that the page can be read in.

use super::table::Text;
use super::{english, german};

/// A language of the page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// All of them.
    pub const ALL: [Language; 2] = [Language::English, Language::German];

    /// Its words.
    pub const fn text(self) -> &'static Text {
        match self {
            Language::English => &english::ENGLISH,
            Language::German => &german::GERMAN,
        }
    }

    /// Its code, as in a `lang` attribute.
    pub const fn code(self) -> &'static str {
        self.text().code
    }

    /// What its speakers call it.
    pub const fn name(self) -> &'static str {
        self.text().name
    }

    /// The language of a code such as `de-CH`.
    pub fn of(code: &str) -> Option<Language> {
        let short = code.split(['-', '_']).next().unwrap_or_default();
        Language::ALL.into_iter().find(|language| language.code().eq_ignore_ascii_case(short))
    }
}
