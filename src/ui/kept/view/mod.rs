//! What is kept, as Yew draws it; wasm only.

mod list;

pub(crate) use list::kept;
