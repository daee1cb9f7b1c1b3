//! The page as a whole: the one place that knows every page. It gives each what is its own, and does between them what
//! they wish for. A page joins by its folder, a variant, and an arm where actions, news and views are given out.

pub mod words;
pub mod action;
pub mod state;
mod bench;
pub mod hear;
pub mod update;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
pub use update::reduce;
