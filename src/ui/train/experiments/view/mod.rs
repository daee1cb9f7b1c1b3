//! Experiments as Yew draws them; wasm only.

mod results;
mod six;
mod panel;

pub(crate) use panel::panel;
