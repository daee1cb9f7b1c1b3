//! The state of the page that drives a robot.

use super::effect::Effect;
use crate::domain::State as World;
use crate::robot::address::{Fault, USUAL};
use crate::robot::calibration::Uncalibrated;
use crate::robot::message::{Command, Generation, Sighting};
use crate::robot::sim::{Bridge, Rehearsal};
use crate::robot::wiring::{Limits, Types};
use crate::robot::{Mark, Pilot, Told, Wiring};
use crate::ui::page::engine::Engine;
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Preferences;
use crate::ui::page::world::{WORLDS, empty};
use crate::worker::protocol::{Answer, PlanText, Program};
use serde::{Deserialize, Serialize};

/// Types that a person can give where the bridge does not tell them.
pub const TYPES: [(Generation, Command); 3] = [
    (Generation::One, Command::Twist),
    (Generation::Two, Command::Twist),
    (Generation::Two, Command::TwistStamped),
];

/// Metres a second to choose from.
pub const SPEEDS: [f64; 3] = [0.1, 0.18, 0.3];

/// All that the page knows.
#[derive(Clone, Debug)]
pub struct State {
    /// The language that it is in.
    pub language: Language,
    /// What the person prefers.
    pub preferences: Preferences,
    /// Whether it came in a secure way.
    pub is_secure: bool,
    /// Which robot is driven.
    pub kind: Kind,
    /// The bridge's address, as typed.
    pub address: String,
    /// Why that is none.
    pub fault: Option<Fault>,
    /// How the robot is wired: topics as typed, those of objects by their places in the world, empty where none is.
    pub wiring: Wiring,
    /// How far the link is.
    pub link: Link,
    /// Which of the page's worlds it is in, if it is one.
    pub preset: Option<usize>,
    /// The world as it was chosen.
    pub world: World,
    /// Rooms as they are drawn by the person.
    pub drawing: String,
    /// Why they cannot be read.
    pub undrawn: Option<String>,
    /// Metres that a cell measures.
    pub size: f64,
    /// The corners that were noted, while calibration goes on.
    pub marks: Option<Vec<Mark>>,
    /// Why there is no calibration.
    pub uncalibrated: Option<Uncalibrated>,
    /// Who drives.
    pub pilot: Pilot,
    /// The robot that is simulated, if it is.
    pub bridge: Option<Bridge>,
    /// What a person was told last.
    pub told: Option<Told>,
    /// The time, in milliseconds.
    pub now: f64,
    /// What came of the last rehearsal.
    pub rehearsal: Option<Rehearsal>,
    /// The engine that talks.
    pub talker: Engine,
    /// Whether it has a model, or why not.
    pub model: Option<Result<(), String>>,
    /// The command as typed.
    pub command: String,
    /// What was said last, and what came of it.
    pub said: Option<Said>,
    /// How it is set up, as it was kept last; nothing before what is kept has come.
    pub kept: Option<String>,
    /// Whether the calibration is of an earlier visit.
    pub is_recalled: bool,
    /// What a screen reader is told.
    pub announcement: String,
    /// What is wanted.
    pub wanted: Vec<Effect>,
}

/// A robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The page's own.
    Simulated,
    /// One behind a rosbridge.
    Real,
}

/// Whose topic it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// The base takes its velocity there.
    Velocity,
    /// The robot's pose is said there.
    Pose,
    /// The pose of the object of this place is.
    Object(usize),
}

/// How far the link is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// None is wanted.
    Off,
    /// It is being opened, for the time of this number since it was open last.
    Opening(u32),
    /// It is open.
    Open,
    /// It is gone, and is opened again after a while.
    Lost(u32),
}

/// A command with its answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// The answer.
    pub answer: Box<Answer>,
    /// Which reading was chosen.
    pub chosen: Option<usize>,
    /// The plan for it, or why there is none.
    pub plan: Option<Box<PlanText>>,
}

impl State {
    /// What there is before the page has opened: nothing is driven.
    pub fn new() -> State {
        let world = WORLDS.first().and_then(|choice| choice.open()).unwrap_or_else(empty);
        let wiring = Wiring::default();
        State {
            language: Language::default(),
            preferences: Preferences::default(),
            is_secure: false,
            kind: Kind::Simulated,
            address: USUAL.to_owned(),
            fault: None,
            pilot: Pilot::new(world.clone(), wiring.clone()),
            wiring,
            link: Link::Off,
            preset: Some(0),
            world,
            drawing: String::new(),
            undrawn: None,
            size: 0.5,
            marks: None,
            uncalibrated: None,
            bridge: None,
            told: None,
            now: 0.0,
            rehearsal: None,
            talker: Engine::new(Program::Talker),
            model: None,
            command: String::new(),
            said: None,
            kept: None,
            is_recalled: false,
            announcement: String::new(),
            wanted: Vec::new(),
        }
    }

    /// How fast it may go.
    pub const fn limits(&self) -> Limits {
        self.pilot.driver.limits
    }

    /// The plan that is to be carried out.
    pub fn plan(&self) -> Option<&PlanText> {
        let plan = self.said.as_ref()?.plan.as_deref()?;
        (plan.reached && !plan.actions.is_empty()).then_some(plan)
    }

    /// The types of this place.
    pub fn types(place: usize) -> Option<Types> {
        let (generation, command) = *TYPES.get(place)?;
        Some(Types { generation, command, sighting: Sighting::Odometry })
    }
}

impl Default for State {
    fn default() -> State {
        State::new()
    }
}
