//! The words about training, a language a table.

mod table;
mod english;
mod german;
mod language;
mod duration;

pub use table::Text;
