//! The page. Everything it decides is the pure [`app::reduce`]: an [`app::Action`] changes the [`app::State`] and
//! yields effects, which are data; the views (wasm only) draw the state and carry the effects out.

pub mod page;
pub mod talk;
pub mod train;
pub mod app;
