//! The page as Yew draws it; wasm only. Components are thin: they show a part of the state and send actions.

mod app;
mod effects;
mod host;
mod sketch;
mod picture;
mod canvas;
mod cells;
mod stage;
mod controls;
mod train;
mod talk;
mod answer;
pub mod proof;
pub mod chart;
mod corpus;
mod row;
mod files;
mod notice;

pub use app::mount;
