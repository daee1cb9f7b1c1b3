//! The page as Yew draws it; wasm only. Views are functions of the state that send actions; only what has something of
//! its own to remember (a canvas, what is folded open) is a component, since each costs what every visitor loads.

mod app;
mod address;
mod effects;
mod host;
mod sign;
mod select;
mod masthead;
mod share;
mod talk;
mod answer;
mod readings;
mod room;
mod stage;
mod canvas;
mod sketch;
mod picture;
mod cells;
mod controls;
mod edit;
mod teach;
mod chart;
mod proof;
mod planner;
mod rules;
mod study;
mod workbench;
mod train;
mod corpus;
mod row;
mod files;
mod notice;

pub use app::{has_page, mount};
