//! A plan as it is played: where in it the robot is, whether it goes on by itself, and what it did not expect.

use crate::domain::{Lock, State};
use crate::worker::protocol::PlanText;

/// A plan with at least one action, and the step that is shown. Invariant: `at < states.len()`, and there is
/// one more state than actions.
#[derive(Clone, Debug, PartialEq)]
pub struct Playback {
    actions: Vec<String>,
    states: Vec<State>,
    at: usize,
    playing: bool,
}

/// What a step did that the plan did not count on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surprise {
    /// A door that nobody had tried is locked.
    DoorLocked,
    /// Nothing happened: the robot slipped.
    Slipped,
    /// What the robot moved stayed behind, and the robot with it.
    LeftBehind,
}

impl Playback {
    /// Begins a plan at its first state, playing; `None` when it has no action or its states do not fit them.
    pub fn begin(plan: &PlanText) -> Option<Playback> {
        if plan.actions.is_empty() || plan.states.len() != plan.actions.len() + 1 {
            return None;
        }
        Some(Playback {
            actions: plan.actions.clone(),
            states: plan.states.clone(),
            at: 0,
            playing: true,
        })
    }

    /// The state shown; `None` is impossible while the invariant holds.
    pub fn shown(&self) -> Option<&State> {
        self.states.get(self.at)
    }

    /// The state after so many actions; `None` when there are fewer.
    pub fn state(&self, at: usize) -> Option<&State> {
        self.states.get(at)
    }

    /// The state that the plan begins in.
    pub fn first(&self) -> Option<&State> {
        self.states.first()
    }

    /// The state that the plan ends in.
    pub fn last(&self) -> Option<&State> {
        self.states.last()
    }

    /// The states up to the one shown.
    pub fn so_far(&self) -> &[State] {
        self.states.get(..=self.at).unwrap_or_default()
    }

    /// The states up to the one after so many actions; `None` when there are fewer.
    pub fn until(&self, at: usize) -> Option<&[State]> {
        self.states.get(..=at)
    }

    /// How many actions have been taken.
    pub fn at(&self) -> usize {
        self.at
    }

    /// How many actions there are.
    pub fn steps(&self) -> usize {
        self.actions.len()
    }

    /// The actions, in order.
    pub fn actions(&self) -> &[String] {
        &self.actions
    }

    /// The action that led to the state shown.
    pub fn latest(&self) -> Option<&str> {
        self.actions.get(self.at.checked_sub(1)?).map(String::as_str)
    }

    /// What the latest action did that nobody expected.
    pub fn surprise(&self) -> Option<Surprise> {
        let before = self.states.get(self.at.checked_sub(1)?)?;
        let (after, action) = (self.shown()?, self.latest()?);
        let locks = before.doors.iter().zip(&after.doors);
        let turns = action.starts_with("turn_");
        if locks.clone().any(|(was, is)| was.lock == Lock::Unknown && is.lock == Lock::Locked) {
            Some(Surprise::DoorLocked)
        } else if before == after {
            Some(Surprise::Slipped)
        } else if !turns && (before.agent.x, before.agent.y) == (after.agent.x, after.agent.y) {
            Some(Surprise::LeftBehind)
        } else {
            None
        }
    }

    /// Whether it goes on by itself.
    pub fn playing(&self) -> bool {
        self.playing
    }

    /// Whether the last state is shown.
    pub fn ended(&self) -> bool {
        self.at == self.actions.len()
    }

    /// Goes to a step, or the last one if there are fewer, and pauses.
    pub fn seek(&mut self, step: usize) {
        self.at = step.min(self.actions.len());
        self.playing = false;
    }

    /// Goes on by a plan that is the same as far as it was played.
    pub fn go_on_by(&mut self, plan: &PlanText) {
        let Playback { at, playing, .. } = *self;
        if let Some(other) = Playback::begin(plan).filter(|other| at <= other.steps()) {
            *self = Playback { at, playing, ..other };
        }
    }

    /// Plays from here, from the start when it has ended.
    pub fn play(&mut self) {
        if self.ended() {
            self.at = 0;
        }
        self.playing = true;
    }

    /// Pauses.
    pub fn pause(&mut self) {
        self.playing = false;
    }

    /// Takes one step while playing; stops playing at the end.
    pub fn advance(&mut self) {
        if self.playing && !self.ended() {
            self.at += 1;
        }
        self.playing = self.playing && !self.ended();
    }
}
