//! Why a command came to nothing, and what the page can do about it.

pub mod help;
pub mod message;
mod instead;
pub mod messages;
pub mod mend;
