//! Watching a plan: where in it the robot is and how fast it goes, what else is to be seen in the room, what the
//! planner said, and what came of many runs.

use super::action::{Action, Effect, Timer};
use super::playback::Playback;
use super::state::State;
use crate::domain::State as World;
use crate::worker::protocol::{PlanProgress, Program, Request, Runs, ValueMap};

/// How often a policy is followed when a person asks for it.
pub const RUNS: u32 = 500;

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

    fn tick(&mut self, effects: &mut Vec<Effect>) {
        self.play = self.play.wrapping_add(1);
        effects.push(Effect::StartTimer(Timer::Play(self.play), self.speed.step_ms()));
    }
}

impl Default for Watch {
    fn default() -> Watch {
        Watch::new()
    }
}

/// Plays the plan of the reading that is chosen; the world goes on from its end.
pub(super) fn play(state: &mut State, effects: &mut Vec<Effect>) {
    let plan = state.document.plan().and_then(|plan| Playback::begin(plan));
    state.watch.playback = plan;
    if let Some(last) = state.watch.playback.as_ref().and_then(Playback::last) {
        state.document.world = last.clone();
        state.watch.tick(effects);
    }
    look(state, effects);
}

/// Asks for the values of the world that is shown, if they are to be seen and not known.
pub(super) fn look(state: &mut State, effects: &mut Vec<Effect>) {
    let wanted = state.depth >= super::action::Depth::See
        && (state.watch.shows(Layer::Values) || state.watch.shows(Layer::Arrows))
        && state.watch.has_policy;
    let known =
        state.watch.values.as_ref().is_some_and(|values| same_around(&values.of, state.shown()));
    if wanted && !known {
        state.talker.retain(|request| !matches!(request, Request::Values { .. }));
        let shown = state.shown().clone();
        state.talker.send(Request::Values { state: shown }, false, effects);
    }
}

/// Whether two worlds differ in nothing but where the robot is: their values are the same.
fn same_around(a: &World, b: &World) -> bool {
    a.objects == b.objects && a.doors == b.doors && a.rooms == b.rooms
}

/// What the person or a timer does with a plan.
pub(super) fn act(state: &mut State, action: Action, effects: &mut Vec<Effect>) {
    match action {
        Action::Rang(Timer::Play(play)) if play == state.watch.play => advance(state, effects),
        Action::TogglePlay => toggle(state, effects),
        Action::Seek(step) => {
            if let Some(playback) = &mut state.watch.playback {
                playback.seek(step);
                state.watch.play = state.watch.play.wrapping_add(1);
                say_step(state);
                look(state, effects);
            }
        }
        Action::SetSpeed(speed) => {
            state.watch.speed = speed;
            if state.watch.playback.as_ref().is_some_and(Playback::playing) {
                state.watch.tick(effects);
            }
        }
        Action::ToggleLayer(layer) => {
            let shown = &mut state.watch.layers[layer as usize];
            *shown = !*shown;
            look(state, effects);
        }
        Action::TryMany => {
            state.watch.runs = None;
            let request = Request::RollOut { runs: RUNS, seed: 0 };
            state.talker.retain(|request| !matches!(request, Request::RollOut { .. }));
            state.talker.send(request, true, effects);
        }
        Action::StopPlanning => state.stop_at(Program::Talker, effects),
        _ => {}
    }
}

fn advance(state: &mut State, effects: &mut Vec<Effect>) {
    let Some(playback) = &mut state.watch.playback else { return };
    playback.advance();
    if let Some(event) = playback.surprise() {
        let words = state.text().surprise(event);
        state.say(words);
    }
    let Some(playback) = &state.watch.playback else { return };
    if playback.playing() {
        state.watch.tick(effects);
    } else if playback.ended() {
        let steps = playback.steps();
        let text = state.text();
        let words = format!("{} {}", (text.done_in)(steps), text.robot(state.shown()));
        state.say(words);
    }
    look(state, effects);
}

fn toggle(state: &mut State, effects: &mut Vec<Effect>) {
    let Some(playback) = &mut state.watch.playback else { return };
    if playback.playing() {
        playback.pause();
        state.watch.play = state.watch.play.wrapping_add(1);
    } else {
        playback.play();
        state.watch.tick(effects);
    }
}

fn say_step(state: &mut State) {
    let Some(playback) = &state.watch.playback else { return };
    let text = state.text();
    let words = format!("{} {}", text.step(playback), text.robot(state.shown()));
    state.say(words);
}
