//! What is kept, as Yew draws it, and the way to the store; wasm only.

mod panel;
mod shelf;

pub(crate) use panel::{of_results, of_run, panel};
pub(crate) use shelf::Shelf;
