//! The reducer of the page that drives a robot: an action changes the state, and what is to be done comes back. Pure.

use super::action::Action;
use super::ask;
use super::drive::{self, event};
use super::effect::Effect;
use super::kept;
use super::place;
use super::state::{Link, State, Topic};
use super::think;
use crate::robot::Event;
use crate::robot::sim::rehearse;
use crate::robot::wiring::Limits;
use crate::ui::page::engines::{self, heard, look, stopped};
use crate::worker::protocol::{Program, Request};

/// Changes the state as the action says, and returns what is to be done. `now` is a time that no clock changes, in
/// milliseconds.
pub fn reduce(state: &mut State, action: Action, now: f64) -> Vec<Effect> {
    state.now = now;
    let is_passing = matches!(action, Action::Tick(_) | Action::LinkHeard(_));
    act(state, action);
    if !is_passing {
        kept::keep(state);
    }
    std::mem::take(&mut state.wanted)
}

fn act(state: &mut State, action: Action) {
    match action {
        Action::Opened(language, is_secure) => {
            (state.language, state.is_secure) = (language, is_secure);
            place::pick(state, 0);
            state.wanted.extend([Effect::Speak(language), Effect::Recall]);
        }
        Action::Prefers(preferences) => state.preferences = preferences,
        Action::Speak(language) => {
            state.language = language;
            state.wanted.push(Effect::Speak(language));
        }
        Action::Tick(backlog) => drive::tick(state, backlog),

        Action::Pick(kind) if kind != state.kind => {
            drive::unlink(state);
            state.pilot.driver.calibration = None;
            (state.kind, state.fault, state.marks) = (kind, None, None);
        }
        Action::Address(address) if state.link == Link::Off => {
            (state.address, state.fault) = (address, None);
        }
        Action::Name(topic, name) if state.link == Link::Off => named(state, topic, name),
        Action::Types(place) if state.link == Link::Off => {
            state.wiring.types = place.and_then(State::types);
        }
        Action::Link(true) => drive::link(state),
        Action::Link(false) => drive::unlink(state),
        Action::LinkOpened => drive::opened(state),
        Action::LinkHeard(text) => drive::take(state, crate::robot::Input::Heard(text)),
        Action::LinkClosed => drive::closed(state),
        Action::LinkAgain(tries) => drive::again(state, tries),
        Action::Pick(_) | Action::Address(_) | Action::Name(..) | Action::Types(_) => {}

        Action::Recalled(text) => kept::recall(state, text.as_deref()),

        Action::World(at) => place::pick(state, at),
        Action::Drawing(drawing) => state.drawing = drawing,
        Action::Draw => {
            think::wake(state);
            let text = state.drawing.clone();
            think::send(state, Request::ReadWorld { text });
        }
        Action::Size(size) => place::size(state, size),
        Action::Here => place::here(state),
        Action::Corners => (state.marks, state.uncalibrated) = (Some(Vec::new()), None),
        Action::Corner => place::note(state),

        Action::Rehearse => {
            let states = state.plan().map(|plan| plan.states.clone()).unwrap_or_default();
            let size = state.pilot.driver.calibration.map_or(state.size, |found| found.cell());
            state.rehearsal = rehearse(&states, size, state.limits(), 1);
        }
        Action::Try => event(state, Event::Try),
        Action::Arm(true) => event(state, Event::Arm),
        Action::Arm(false) => event(state, Event::Disarm),
        Action::Speed(speed) => {
            state.pilot.driver.limits = Limits { speed, ..state.limits() }.capped();
        }
        Action::Held(is_held) => event(state, Event::Held(is_held)),
        Action::Stop => event(state, Event::Emergency),
        Action::Release => event(state, Event::Release),
        Action::Hidden => event(state, Event::Hidden),
        Action::Closing => event(state, Event::Closing),

        Action::Typed(command) => ask::typed(state, &command),
        Action::Ask => ask::ask(state),
        Action::Choose(reading) => ask::choose(state, reading),
        Action::Instead => ask::instead(state),
        Action::Heard(envelope) => {
            if let Some(news) = heard(state, Program::Talker, envelope) {
                ask::hear(state, news);
            }
        }
        Action::EngineBroke(why) => {
            let news = stopped(state, Program::Talker, why);
            ask::hear(state, news);
        }
        Action::Look(watch) => {
            if let Some(news) = look(state, Program::Talker, watch) {
                ask::hear(state, news);
            }
        }
        Action::Restart => {
            engines::restart(state, Program::Talker);
            state.model = None;
            state.wanted.push(Effect::FetchModel);
        }
        Action::Model(Ok(text)) => think::send(state, Request::OpenModel { text }),
        Action::Model(Err(why)) => state.model = Some(Err(why)),
        Action::Words(Ok(text)) => think::send(state, Request::Words { text }),
        // Without them everything works that is said in words of the lexicon.
        Action::Words(Err(_)) => {}
    }
}

fn named(state: &mut State, topic: Topic, name: String) {
    let wiring = &mut state.wiring;
    match topic {
        Topic::Velocity => wiring.velocity = name,
        Topic::Pose => wiring.pose = name,
        Topic::Object(at) => {
            if let Some((_, topic)) = wiring.bodies.get_mut(at) {
                *topic = name;
            }
        }
    }
}
