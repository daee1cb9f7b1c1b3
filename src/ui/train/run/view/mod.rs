//! Training as Yew draws it; wasm only.

mod training;

pub(crate) use training::training;
