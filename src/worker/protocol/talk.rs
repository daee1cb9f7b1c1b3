//! The part of the protocol that page and talker read, which are one program: what only the workbench and its engine have
//! to say to each other is most of it, and would be a tenth of the first view. Read so, messages are the same, whose
//! kinds stand first in [`Request`] and [`Event`]; any other is no message.

use super::event::Event;
use super::learning::{TeachReport, TrainReport};
use super::message::Envelope;
use super::planning::{Answer, PlanProgress, PlanText, Runs, ValueMap, WorldRules};
use super::reading::Study;
use super::request::{Request, Wanted};
use super::wire::{WireError, read};
use crate::domain::{Blueprint, State};
use serde::Deserialize;

/// What the page reads.
#[derive(Deserialize)]
#[serde(remote = "Event")]
enum Said {
    Ready,
    Pong,
    Crashed { message: String },
    Refused { message: String },
    Cancelled,
    Opened(TrainReport),
    Words,
    Taught(Box<TeachReport>),
    Answer(Box<Answer>),
    Planning(PlanProgress),
    Planned(Box<PlanText>),
    Values(ValueMap),
    RollingOut(Runs),
    RolledOut(Runs),
    Explained(Vec<Study>),
    Example { wanted: Wanted, command: Option<String> },
    World(State),
    WorldText { text: String },
}

/// What the talker reads.
#[derive(Deserialize)]
#[serde(remote = "Request")]
enum Asked {
    Cancel,
    Ping,
    OpenModel { text: String },
    Words { text: String },
    Read { command: String, state: State },
    Ask { command: String, state: State, rules: WorldRules },
    Plan { form: String, run: Vec<State>, rules: WorldRules },
    Values { state: State, done: u8 },
    RollOut { runs: u32, seed: u32 },
    Explain { command: String },
    Example { wanted: Wanted, state: State, rules: WorldRules },
    Draw { blueprint: Blueprint, seed: u32 },
    ReadWorld { text: String },
    WriteWorld { state: State },
    GoOn { form: String, run: Vec<State>, rules: WorldRules },
}

#[derive(Deserialize)]
struct Heard {
    groundling: u32,
    id: u32,
    #[serde(with = "Said")]
    body: Event,
}

#[derive(Deserialize)]
struct Wish {
    groundling: u32,
    id: u32,
    #[serde(with = "Asked")]
    body: Request,
}

/// What an engine said to the page.
///
/// # Errors
/// When the bytes are of another version, or no such message.
pub fn decode_said(bytes: &[u8]) -> Result<Envelope<Event>, WireError> {
    read(bytes).map(|Heard { groundling, id, body }| Envelope { groundling, id, body })
}

/// What the talker was asked.
///
/// # Errors
/// When the bytes are of another version, or no such message.
pub fn decode_asked(bytes: &[u8]) -> Result<Envelope<Request>, WireError> {
    read(bytes).map(|Wish { groundling, id, body }| Envelope { groundling, id, body })
}
