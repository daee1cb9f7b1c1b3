//! What is watched: where in a plan the robot is and how fast it goes, what else is to be seen in the room, what the
//! planner said, and what came of many runs.

use super::playback::Playback;
use crate::domain::State as World;
use crate::ui::page::effect::{Effect, Timer};
use crate::worker::protocol::{PlanProgress, Runs, ValueMap};

/// Reports of a planner that are kept for the plot.
const MOST_REPORTS: usize = 400;

/// How fast a plan is played.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Speed {
    /// Half as fast.
    Half,
    /// A step in a third of a second or so.
    #[default]
    Normal,
    /// Twice as fast.
    Double,
    /// Four times as fast.
    Fourfold,
}

impl Speed {
    /// All of them, slow first.
    pub const ALL: [Speed; 4] = [Speed::Half, Speed::Normal, Speed::Double, Speed::Fourfold];

    /// Milliseconds from one step to the next.
    pub const fn step_ms(self) -> u32 {
        match self {
            Speed::Half => 560,
            Speed::Normal => 280,
            Speed::Double => 140,
            Speed::Fourfold => 70,
        }
    }

    /// As people write it.
    pub const fn name(self) -> &'static str {
        match self {
            Speed::Half => "½×",
            Speed::Normal => "1×",
            Speed::Double => "2×",
            Speed::Fourfold => "4×",
        }
    }
}

/// What can be shown over the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The cells where the goal holds.
    Goal,
    /// What each cell is worth.
    Values,
    /// What to do on each cell.
    Arrows,
}

impl Layer {
    /// All of them.
    pub const ALL: [Layer; 3] = [Layer::Goal, Layer::Values, Layer::Arrows];
}

/// What is watched, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Watch {
    /// The plan that is played.
    pub playback: Option<Playback>,
    /// How fast.
    pub speed: Speed,
    /// What is to be seen over the room, beyond the first depth.
    pub layers: [bool; Layer::ALL.len()],
    /// What the cells are worth in the world that is shown.
    pub values: Option<Values>,
    /// What the planner said while it worked, and last.
    pub reports: Vec<PlanProgress>,
    /// How long answer and plan took, in seconds.
    pub seconds: Option<f64>,
    /// What came of many runs, as far as they are.
    pub runs: Option<Runs>,
    /// Whether the engine keeps the policy of the reading that is chosen.
    pub has_policy: bool,
    /// Whether no shorter way on is to be had.
    pub(super) is_best: bool,
    begun: f64,
    play: u32,
}

/// A value map, and the world that it is of.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// What the cells are worth.
    pub map: std::rc::Rc<ValueMap>,
    /// The world.
    pub of: World,
    /// Of a task over time: how many of its steps were done.
    pub done: u8,
}

impl Watch {
    /// Nothing to watch.
    pub fn new() -> Watch {
        Watch {
            playback: None,
            speed: Speed::default(),
            layers: [true; Layer::ALL.len()],
            values: None,
            reports: Vec::new(),
            seconds: None,
            runs: None,
            has_policy: false,
            is_best: false,
            begun: 0.0,
            play: 0,
        }
    }

    /// Whether a layer is on.
    pub const fn shows(&self, layer: Layer) -> bool {
        self.layers[layer as usize]
    }

    /// A plan is asked for at this time: what was known of the one before is forgotten.
    pub fn begin(&mut self, now: f64) {
        self.forget();
        self.begun = now;
    }

    /// What was planned holds no more.
    pub fn forget(&mut self) {
        let Watch { speed, layers, play, .. } = *self;
        *self = Watch { speed, layers, play: play.wrapping_add(1), ..Watch::new() };
    }

    /// The planner said how far it is.
    pub fn report(&mut self, progress: PlanProgress) {
        if self.reports.len() == MOST_REPORTS {
            // Every second one will do for the plot.
            let mut place = 0;
            self.reports.retain(|_| {
                place += 1;
                place % 2 == 0
            });
        }
        self.reports.push(progress);
    }

    /// A plan has come, or none can.
    pub fn end(&mut self, work: Option<PlanProgress>, now: f64) {
        self.seconds = Some((now - self.begun).max(0.0) / 1000.0);
        self.has_policy = work.is_some();
        if let Some(work) = work {
            self.report(work);
        }
    }

    /// Whether a timer is the one that counts.
    pub(super) const fn awaits(&self, play: u32) -> bool {
        self.play == play
    }

    /// No timer counts any more.
    pub(super) const fn hold(&mut self) {
        self.play = self.play.wrapping_add(1);
    }

    /// The timer for the next step.
    pub(crate) const fn tick(&mut self) -> Effect {
        self.hold();
        Effect::StartTimer(Timer::Play(self.play), self.speed.step_ms())
    }
}

impl Default for Watch {
    fn default() -> Watch {
        Watch::new()
    }
}
