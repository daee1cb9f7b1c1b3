//! Commands: they are read and planned for by the engine that talks, in the world as it is seen, and thought of again when
//! that is not where it was expected.

use super::drive::event;
use super::effect::Effect;
use super::place;
use super::state::{Said, State};
use super::think::{RULES, anew, send, wake};
use crate::domain::State as World;
use crate::robot::Event as Drive;
use crate::ui::page::engines::News;
use crate::worker::protocol::{Event, PlanText, Request};

/// Characters that a command may have.
const MOST: usize = 400;

/// The world that a command is said in.
fn world(state: &State) -> World {
    match state.pilot.driver.look() {
        Some(Ok(seen)) => seen,
        _ => state.pilot.driver.world.clone(),
    }
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
    send(state, Request::Plan { form, run: vec![world], rules: RULES });
}

/// What can be done instead is to be done: without what leaves no way, or once that is over.
pub(super) fn instead(state: &mut State) {
    let Some(said) = &mut state.said else { return };
    let instead = said.plan.as_ref().and_then(|plan| plan.instead.as_ref());
    let Some(reading) = instead.map(|instead| instead.reading.clone()) else { return };
    said.answer.readings.push(reading);
    let place = said.answer.readings.len() - 1;
    choose(state, place);
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
        News::Answer(Request::GoOn { .. }, Event::Planned(plan)) => {
            let states = usable(&plan).then(|| plan.states.clone());
            // What was to hold on the way does not: it stops, and asks.
            let asks = states.is_none() && plan.instead.is_some();
            if let Some(said) = state.said.as_mut().filter(|_| asks) {
                said.plan = Some(plan);
            }
            event(state, Drive::Again(states));
        }
        News::Answer(Request::GoOn { run, .. }, Event::Refused { .. })
            if state.pilot.driver.is_thinking() =>
        {
            let is_asked = run.into_iter().last().is_some_and(|world| anew(state, world));
            if !is_asked {
                event(state, Drive::Again(None));
            }
        }
        News::Answer(Request::ReadWorld { .. }, Event::World(world)) => {
            place::open(state, world, None);
        }
        News::Answer(Request::ReadWorld { .. }, Event::Refused { message }) => {
            state.undrawn = Some(message);
        }
        News::Stopped if state.pilot.driver.is_thinking() => event(state, Drive::Again(None)),
        News::Answer(Request::Plan { .. } | Request::GoOn { .. }, _)
            if state.pilot.driver.is_thinking() =>
        {
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
