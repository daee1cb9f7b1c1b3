//! What was learned, as Yew draws it; wasm only.

mod table;
mod rows;
mod entries;
mod errors;
mod difference;
mod panel;

pub(crate) use panel::panel;
