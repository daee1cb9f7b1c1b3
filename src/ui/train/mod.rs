//! The workbench: a corpus is opened and looked at, a parser is trained on it. It is a program of its own, which the
//! page fetches when it is to be seen; what it tells the page is [`crate::ui::page::news`]. Each part has a folder with
//! its own state, actions and views, is lent the desk, and knows no other; `update` and `hear` alone know them all.

pub mod words;
pub mod effect;
pub mod svg;
pub mod desk;
pub mod data;
pub mod run;
pub mod experiments;
pub mod lexicon;
pub mod study;
pub mod kept;
pub mod action;
pub mod state;
pub mod restart;
pub mod returning;
pub mod keeping;
pub mod hear;
pub mod update;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
pub use update::reduce;
