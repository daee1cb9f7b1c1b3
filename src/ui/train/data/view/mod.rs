//! The corpus as Yew draws it; wasm only.

mod problems;
mod row;
mod corpus;

pub(crate) use corpus::corpus;
