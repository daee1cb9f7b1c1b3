//! The words about what is kept, a language a table.

mod table;
mod english;
mod german;
mod language;

pub use table::Text;
