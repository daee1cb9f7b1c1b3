//! Studies as they are drawn; wasm only.

mod controls;
mod make;
mod survey;
mod rows;
mod review;
mod panel;

pub(crate) use panel::panel;
