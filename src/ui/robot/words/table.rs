//! What a language has to have a word for where a robot is driven.

use crate::robot::address::Fault;
use crate::robot::calibration::Uncalibrated;
use crate::robot::session::{Bad, Kind};
use crate::robot::sim::Rehearsal;
use crate::robot::{Check, Halt, Stage, Told};
use crate::ui::page::grammar::Phrases;
use crate::ui::page::world::Name;
use crate::ui::robot::state::Link;

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub grammar: &'static (dyn Phrases + Sync),
    pub title: &'static str,
    pub front: &'static str,
    pub guide: &'static str,
    pub other_language: &'static str,
    pub intro: &'static str,

    // The robot.
    pub robot: &'static str,
    pub which: &'static str,
    pub simulated: &'static str,
    pub real: &'static str,
    pub address: &'static str,
    pub link: &'static str,
    pub unlink: &'static str,
    pub start: &'static str,
    pub end: &'static str,
    pub fault: fn(Fault) -> &'static str,
    pub linked: fn(Link) -> &'static str,
    pub topics: &'static str,
    pub velocity: &'static str,
    pub pose: &'static str,
    pub object: fn(&str) -> String,
    pub objects: &'static str,
    pub types: &'static str,
    pub types_asked: &'static str,
    pub kind: fn(&Kind) -> String,

    // Where it is.
    pub place: &'static str,
    pub world: &'static str,
    pub world_name: fn(Name) -> &'static str,
    pub own_world: &'static str,
    pub drawing: &'static str,
    pub drawing_help: &'static str,
    pub draw: &'static str,
    pub size: &'static str,
    pub here: &'static str,
    pub here_help: &'static str,
    pub corners: &'static str,
    pub corners_help: &'static str,
    pub corner: fn(usize, usize, &str) -> String,
    pub recalled: &'static str,
    pub note: &'static str,
    pub calibrated: fn(f64, f64) -> String,
    pub uncalibrated: fn(Uncalibrated) -> String,

    // The dry run.
    pub dry: &'static str,
    pub dry_help: &'static str,
    pub check: fn(Check) -> &'static str,
    pub good: &'static str,
    pub bad: &'static str,
    pub open: &'static str,
    pub try_stop: &'static str,
    pub try_help: &'static str,
    pub rehearse: &'static str,
    pub rehearsed: fn(&Rehearsal) -> String,
    pub came_wrong: fn(&Bad) -> String,

    // Driving.
    pub drive: &'static str,
    pub drive_help: &'static str,
    pub speed: &'static str,
    pub speeds: [&'static str; 3],
    pub arm: &'static str,
    pub disarm: &'static str,
    pub release: &'static str,
    pub hold: &'static str,
    pub hold_help: &'static str,
    pub stop: &'static str,
    pub stage: fn(&Stage) -> String,
    pub halt: fn(&Halt) -> String,
    pub told: fn(&Told) -> String,

    // Commands.
    pub command: &'static str,
    pub command_hint: &'static str,
    pub go: &'static str,
    pub thinking: &'static str,
    pub loading: &'static str,
    pub no_model: fn(&str) -> String,
    pub meant: &'static str,
    pub which_meant: &'static str,
    pub plan: fn(usize, usize) -> String,
    pub nothing: &'static str,
    pub unknown: fn(&[&str]) -> String,
    pub left_out: fn(&[&str]) -> String,
    pub no_way: &'static str,
    pub demands: fn(&str) -> String,
    pub without: &'static str,
    pub once: &'static str,
    pub done_already: &'static str,
    pub room: &'static str,
}
