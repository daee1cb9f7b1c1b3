//! Teaching: what is shown and said becomes a lesson.

pub mod trail;
pub mod state;
pub mod other;
pub mod learn;
pub mod unlike;
