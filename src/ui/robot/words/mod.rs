//! The words of the page that drives a robot, a language a table.

mod table;
mod english;
mod german;
mod language;

pub use table::Text;
