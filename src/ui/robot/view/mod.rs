//! The page that drives a robot as Yew draws it, and what carries its effects out; wasm only.

mod effects;
mod keys;
mod room;
mod setup;
mod place;
mod dry;
mod bar;
mod page;
mod runtime;
mod root;

pub use root::mount;
