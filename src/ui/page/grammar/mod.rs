//! The grammar of every language: goals, things, worlds and changes as people say them.

mod phrases;
mod claims;
mod english;
mod english_claims;
mod german_words;
mod german;
mod german_claims;

pub use english::English;
pub use german::German;
pub use phrases::{Phrases, capitalised, room_at, spot};
