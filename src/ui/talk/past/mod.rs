//! What was said before, with what came of it: to be said again, or gone on from.

pub mod state;
pub mod lines;
pub mod recall;
