//! The page that lists what is kept on this machine: what, since when, how much; to be saved as files, or deleted. A
//! saved file is opened here, too, by whatever means a person has.

pub mod words;
pub mod action;
pub mod update;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::{Action, Wish};
