//! Commands: they are read and planned for by the engine that talks, in the world as it is seen, and thought of again when
//! that is not where it was expected.

use super::drive::event;
use super::effect::Effect;
use super::state::{Said, State};
use crate::domain::State as World;
use crate::robot::Event as Drive;
use crate::ui::page::engine::{Engine, Health};
use crate::ui::page::engines::{News, Owner};
use crate::ui::page::language::Language;
use crate::worker::protocol::{Event, PlanText, Program, Request, WorldRules};

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

/// Characters that a command may have.
const MOST: usize = 400;

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

/// The world that a command is said in.
fn world(state: &State) -> World {
    match state.pilot.driver.look() {
        Some(Ok(seen)) => seen,
        _ => state.pilot.driver.world.clone(),
    }
}

/// Whether something is being thought of.
pub fn is_asking(state: &State) -> bool {
    state.talker.is_at(|request| matches!(request, Request::Ask { .. } | Request::Plan { .. }))
}

/// The command is this now.
pub(super) fn typed(state: &mut State, command: &str) {
    wake(state);
    state.command = command.chars().take(MOST).collect();
}

/// The command is to be done.
pub(super) fn ask(state: &mut State) {
    if state.command.trim().is_empty() || state.model != Some(Ok(())) {
        return;
    }
    (state.said, state.rehearsal) = (None, None);
    event(state, Drive::Route(Vec::new()));
    let (command, world) = (state.command.clone(), world(state));
    send(state, Request::Ask { command, state: world, rules: RULES });
}

/// The command was meant in this way.
pub(super) fn choose(state: &mut State, place: usize) {
    let Some(said) = &mut state.said else { return };
    let Some(reading) = said.answer.readings.get(place) else { return };
    let form = reading.form.clone();
    (said.chosen, said.plan, state.rehearsal) = (Some(place), None, None);
    let world = world(state);
    send(state, Request::Plan { form, state: world, rules: RULES });
}

/// The robot is to think again, from where its run has led.
pub(super) fn again(state: &mut State, run: Vec<World>) {
    let said = state.said.as_ref();
    let reading = said.and_then(|said| said.answer.readings.get(said.chosen?));
    match reading.map(|reading| reading.form.clone()).zip(run.last().cloned()) {
        Some((form, world)) => send(state, Request::Plan { form, state: world, rules: RULES }),
        None => event(state, Drive::Again(None)),
    }
}

/// The engine has news.
pub(super) fn hear(state: &mut State, news: News) {
    match news {
        News::Answer(Request::OpenModel { .. }, said) => {
            state.model = Some(match said {
                Event::Opened(_) => Ok(()),
                Event::Refused { message } => Err(message),
                other => Err(format!("{other:?}")),
            });
            state.wanted.push(Effect::FetchWords);
        }
        News::Answer(Request::Ask { .. }, Event::Answer(answer)) => {
            let plan = answer.plan.clone().map(Box::new);
            let chosen = plan.is_some().then_some(0);
            state.said = Some(Said { answer, chosen, plan });
            follow(state);
        }
        News::Answer(Request::Plan { .. }, Event::Planned(plan)) => {
            if state.pilot.driver.is_thinking() {
                let states = usable(&plan).then(|| plan.states.clone());
                event(state, Drive::Again(states));
            } else if let Some(said) = &mut state.said {
                said.plan = Some(plan);
                follow(state);
            }
        }
        News::Answer(Request::ReadWorld { .. }, Event::World(world)) => {
            super::place::open(state, world, None);
        }
        News::Answer(Request::ReadWorld { .. }, Event::Refused { message }) => {
            state.undrawn = Some(message);
        }
        News::Stopped if state.pilot.driver.is_thinking() => event(state, Drive::Again(None)),
        News::Answer(Request::Plan { .. }, _) if state.pilot.driver.is_thinking() => {
            event(state, Drive::Again(None));
        }
        News::Answer(..) | News::Progress(_) | News::Stopped => {}
    }
}

fn usable(plan: &PlanText) -> bool {
    plan.reached && !plan.states.is_empty()
}

/// The plan, if there is one, is what the robot follows once it may.
fn follow(state: &mut State) {
    if let Some(states) = state.plan().map(|plan| plan.states.clone()) {
        event(state, Drive::Route(states));
    }
}
