//! The page that says what can be said, with examples to press, and which keys there are. Its text comes as a file, a
//! language a file (`www/help.*.html`), once somebody wants to read it; the examples are filled in from the room on view.

pub mod guide;
pub mod state;
#[cfg(target_arch = "wasm32")]
pub mod view;

pub use state::State;
