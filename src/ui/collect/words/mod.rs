//! The words of the page that asks, a language a table. What it is about the study may say in words of its own.

mod table;
mod english;
mod german;
mod language;

pub use table::Text;
