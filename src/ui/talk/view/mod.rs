//! The Talk page as Yew draws it; wasm only.

mod share;
mod command;
mod past;
mod answer;
mod choices;
mod course;
mod room;
mod stage;
mod canvas;
mod observer;
mod pace;
mod cells;
mod over;
mod controls;
mod edit;
mod teach;
mod readings;
mod planner;
mod chart;
mod rules;
mod study;
mod proof;
mod whole;

pub(crate) use command::give_back;
pub(crate) use whole::talk;
