//! The grammar of every language: goals, things, worlds and changes as people say them.

mod scenes;
mod phrases;
mod claims;
mod english;
mod english_claims;
mod english_deeds;
mod german_words;
mod german;
mod german_claims;
mod german_deeds;

pub use english::English;
pub use german::German;
pub use phrases::{Phrases, capitalised};
pub use scenes::{Scenes, room_at, spot};
