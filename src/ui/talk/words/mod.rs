//! The words of the Talk page, a language a table.

mod table;
mod english;
mod german;
mod language;
mod names;

pub use table::{Faults, Helps, Meant, Text};
