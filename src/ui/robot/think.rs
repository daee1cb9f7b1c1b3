//! What is asked of the engine that talks, whoever asks: it is woken, sent requests, and has a robot think again.

use super::effect::Effect;
use super::state::State;
use crate::domain::State as World;
use crate::ui::page::engine::{Engine, Health};
use crate::ui::page::engines::Owner;
use crate::ui::page::language::Language;
use crate::worker::protocol::{Program, Request, WorldRules};

/// What a robot can do that is driven by wheels.
pub const RULES: WorldRules = WorldRules {
    pull: false,
    robot: true,
    landmarks_stay: true,
    slip: 0.0,
    lock: 0.0,
    loss: 0.0,
    luck: 0,
};

impl Owner for State {
    type Effect = Effect;

    fn engine(&mut self, _program: Program) -> (&mut Engine, &mut Vec<Effect>) {
        (&mut self.talker, &mut self.wanted)
    }

    fn language(&self) -> Language {
        self.language
    }

    fn say(&mut self, words: &str) {
        words.clone_into(&mut self.announcement);
    }
}

/// Has the engine that talks loaded, and its model fetched, if they are not yet.
pub(super) fn wake(state: &mut State) {
    if state.talker.health == Health::Asleep {
        state.talker.wake(&mut state.wanted);
        state.wanted.push(Effect::FetchModel);
    }
}

/// Sends a request.
pub(super) fn send(state: &mut State, request: Request) {
    state.talker.send(request, false, &mut state.wanted);
}

/// Whether something is being thought of.
pub fn is_asking(state: &State) -> bool {
    state.talker.is_at(|request| {
        matches!(request, Request::Ask { .. } | Request::Plan { .. } | Request::GoOn { .. })
    })
}

/// Has a robot think again, from what its run has come to, for what its command meant where it was said; whether there is
/// something to think of.
pub(super) fn again(state: &mut State, run: Vec<World>) -> bool {
    let said = state.said.as_ref().filter(|_| state.plan().is_some() && !run.is_empty());
    let reading = said.and_then(|said| said.answer.readings.get(said.chosen?));
    let form = reading.map(|reading| reading.form.clone());
    let is_said = form.is_some();
    if let Some(form) = form {
        send(state, Request::GoOn { form, run, rules: RULES });
    }
    is_said
}

/// The engine cannot go on with the plan that it keeps, if it keeps one: a goal of states is planned for anew, which loses
/// nothing; a task over time is not, since what was done of it would be done again.
pub(super) fn anew(state: &mut State, world: World) -> bool {
    let said = state
        .said
        .as_ref()
        .filter(|said| said.plan.as_ref().is_some_and(|plan| plan.done.is_empty()));
    let reading = said.and_then(|said| said.answer.readings.get(said.chosen?));
    let form = reading.map(|reading| reading.form.clone());
    let is_said = form.is_some();
    if let Some(form) = form {
        send(state, Request::Plan { form, run: vec![world], rules: RULES });
    }
    is_said
}
