//! The workbench as Yew draws it, and what carries its effects out; wasm only.

mod effects;
mod root;

pub use root::{Handle, mount};
