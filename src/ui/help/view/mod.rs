//! The guide as Yew draws it; wasm only.

mod page;

pub(crate) use page::help;
