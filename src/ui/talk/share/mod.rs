//! Sharing: all of the talk as one text, for a link or a file.

pub mod also;
pub mod session;
pub mod state;
pub mod exchange;
