//! The grammar of every language: goals, things, worlds and changes as people say them.

mod phrases;
mod english;
mod german_words;
mod german;

pub use english::English;
pub use german::German;
pub use phrases::{Phrases, room_at};
