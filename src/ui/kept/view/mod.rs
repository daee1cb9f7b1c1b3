//! What is kept, as it is drawn; wasm only. The frame is the page's, the list the keeper's.

pub mod list;
mod frame;

pub(crate) use frame::kept;
