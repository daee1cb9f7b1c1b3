//! What the workbench keeps on this machine: corpora, runs and models, in the page's one store, as bytes under names.
//! This part lists them and asks for them; what they are is `keeping`'s matter, which knows the other parts.

pub mod words;
pub mod ask;
pub mod action;
pub mod state;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use action::Action;
pub use state::State;
