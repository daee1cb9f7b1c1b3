//! What the page says wherever one is on it, a language a table.

mod table;
mod english;
mod german;
mod language;

pub use table::Text;
