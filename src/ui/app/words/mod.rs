//! The words of the frame around the pages, a language a table.

mod table;
mod english;
mod german;
mod language;

pub use table::Text;
