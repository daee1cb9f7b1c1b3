//! Training as Yew draws it; wasm only.

mod press;
mod settings;
mod curves;
mod now;
mod panel;

pub(crate) use panel::panel;
