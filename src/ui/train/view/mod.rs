//! The Train page as Yew draws it; wasm only.

mod training;
mod problems;
mod row;
mod corpus;
mod workbench;

pub(crate) use workbench::workbench;
