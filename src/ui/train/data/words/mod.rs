//! The words about the corpus, a language a table.

mod table;
mod english;
mod german;
mod language;

pub use table::Text;
