//! The one native integration binary: a module a topic, in the reading order of `src/lib.rs`.
#![cfg(not(target_arch = "wasm32"))]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stderr,
    reason = "a failing test panics"
)]

#[path = "suite/command.rs"]
mod command;
#[path = "suite/everywhere.rs"]
mod everywhere;
#[path = "suite/logic.rs"]
mod logic;
#[path = "suite/ccg.rs"]
mod ccg;
#[path = "suite/render.rs"]
mod render;
#[path = "suite/overlay.rs"]
mod overlay;
#[path = "suite/tidy.rs"]
mod tidy;
#[path = "suite/world.rs"]
mod world;
#[path = "suite/dynamics.rs"]
mod dynamics;
#[path = "suite/drawing.rs"]
mod drawing;
#[path = "suite/arguments.rs"]
mod arguments;
#[path = "suite/corpus.rs"]
mod corpus;
#[path = "suite/plain_words.rs"]
mod plain_words;
#[path = "suite/outputs.rs"]
mod outputs;
#[path = "suite/rows.rs"]
mod rows;
#[path = "suite/goals.rs"]
mod goals;
#[path = "suite/holds.rs"]
mod holds;
#[path = "suite/time.rs"]
mod time;
#[path = "suite/solvers.rs"]
mod solvers;
#[path = "suite/planning.rs"]
mod planning;
#[path = "suite/learn.rs"]
mod learn;
#[path = "suite/teach.rs"]
mod teach;
#[path = "suite/study.rs"]
mod study;
#[path = "suite/wide.rs"]
mod wide;
#[path = "suite/explain.rs"]
mod explain;
#[path = "suite/worker.rs"]
mod worker;
#[path = "suite/demonstration.rs"]
mod demonstration;
#[path = "peer/peer.rs"]
mod peer;
#[path = "suite/robot.rs"]
mod robot;
#[path = "suite/ui.rs"]
mod ui;
#[path = "suite/proof.rs"]
mod proof;
#[path = "suite/chart.rs"]
mod chart;
#[path = "suite/plan_command.rs"]
mod plan_command;
#[path = "suite/experiment.rs"]
mod experiment;
#[path = "suite/commands.rs"]
mod commands;
