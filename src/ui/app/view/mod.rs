//! The page as Yew draws it: what stands around the pages, and what carries their effects out; wasm only.

mod masthead;
mod address;
mod bench;
mod coming;
mod effects;
mod root;

pub use root::{has_page, mount};
