//! The corpus as Yew draws it; wasm only.

mod faults;
mod files;
mod mapping;
mod filters;
mod grid;
mod row;
mod care;
mod split;
mod panel;

pub(crate) use panel::panel;
