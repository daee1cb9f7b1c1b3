//! What the page does by itself for who has just come.

pub mod state;
pub mod run;
