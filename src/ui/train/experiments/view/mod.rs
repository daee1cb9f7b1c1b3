//! Experiments as Yew draws them; wasm only.

mod results;
mod panel;

pub(crate) use panel::panel;
