//! The page as Yew draws it; wasm only. Components are thin: they show a part of the state and send actions.

mod app;
mod address;
mod effects;
mod host;
mod words;
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

pub use app::mount;
