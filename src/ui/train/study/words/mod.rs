//! The words about studies, a language a table.

mod table;
mod english;
mod german;
mod language;

pub use table::Text;
