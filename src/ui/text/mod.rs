//! The page's words, a language a table ([`Text`]) and a grammar ([`Phrases`]). A language that lacks a word does not
//! compile; another one is a table, a grammar, and a line in [`Language`].

mod language;
mod table;
mod phrases;
mod english;
mod english_phrases;
mod german;
mod german_phrases;

pub use language::Language;
pub use phrases::{Phrases, room_at};
pub use table::{Faults, Helps, Text};
