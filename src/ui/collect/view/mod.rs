//! The page that asks as Yew draws it, and what carries its effects out; wasm only.

mod journal;
mod effects;
mod sight;
mod start;
mod item;
mod end;
mod page;
mod rehearse;
mod root;

pub use root::mount;
