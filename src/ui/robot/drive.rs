//! Driving: what comes over the link, what a person does and the time that goes by are given to the pilot, and what it wants
//! goes to the link, the planner, or the person. A robot that is simulated takes the frames in place of a link.

use super::effect::Effect;
use super::state::{Kind, Link, State};
use super::think;
use super::words::Text;
use crate::robot::address::address;
use crate::robot::calibration::Calibration;
use crate::robot::sim::{Body, Bridge, Noise};
use crate::robot::{Act, Event, Input, Pilot, Told, Wiring};

/// Milliseconds before the link is opened again, at first and at most.
const AGAIN: (u32, u32) = (1_000, 10_000);

/// Gives the pilot something, and carries out what it wants.
pub(super) fn take(state: &mut State, input: Input) {
    for act in state.pilot.take(input, state.now) {
        match act {
            Act::Send(text) => match &mut state.bridge {
                Some(bridge) => bridge.hear(&text, state.now),
                None => state.wanted.push(Effect::Send(text)),
            },
            Act::Plan(run) => {
                if !think::again(state, run) {
                    event(state, Event::Again(None));
                }
            }
            Act::Tell(told) => tell(state, told),
        }
    }
}

pub(super) fn event(state: &mut State, event: Event) {
    take(state, Input::Event(event));
}

fn tell(state: &mut State, told: Told) {
    state.announcement = (Text::of(state.language).told)(&told);
    state.told = Some(told);
}

/// Time has gone on: the simulated robot with it.
pub(super) fn tick(state: &mut State, backlog: u32) {
    let said = state.bridge.as_mut().map(|bridge| bridge.pass(state.now));
    for text in said.into_iter().flatten() {
        take(state, Input::Heard(text));
    }
    if backlog > 0 {
        event(state, Event::Backlog(backlog));
    }
    event(state, Event::Tick);
}

/// A link is wanted.
pub(super) fn link(state: &mut State) {
    if state.link != Link::Off {
        return;
    }
    think::wake(state);
    renew(state);
    match state.kind {
        Kind::Simulated => {
            let body = Body { size: state.size, reach: state.limits().reach, ..Body::default() };
            // Every time anew, and the same for the same moment.
            let seed = state.now as u64;
            state.bridge = Some(Bridge::new(&state.world, body, Noise::default(), seed, state.now));
            state.pilot.driver.calibration =
                Some(Calibration::plain(state.size, (0, 0), [0.0, 0.0]));
            state.link = Link::Open;
            take(state, Input::Opened);
        }
        Kind::Real => match address(&state.address, state.is_secure) {
            Ok(address) => {
                state.fault = None;
                state.link = Link::Opening(0);
                state.wanted.push(Effect::Open(address));
            }
            Err(fault) => state.fault = Some(fault),
        },
    }
}

/// A pilot for the robot as it is wired now; what was calibrated holds on.
fn renew(state: &mut State) {
    let (calibration, limits) = (state.pilot.driver.calibration, state.limits());
    let bodies = state.wiring.bodies.iter().filter(|(_, topic)| !topic.trim().is_empty());
    let wiring = match state.kind {
        Kind::Real => Wiring { bodies: bodies.cloned().collect(), ..state.wiring.clone() },
        Kind::Simulated => {
            let tracked = |name: &String| (name.clone(), format!("/tracked/{name}"));
            let bodies = state.world.objects.iter().map(|object| tracked(&object.name));
            Wiring { bodies: bodies.collect(), ..Wiring::default() }
        }
    };
    state.pilot = Pilot::new(state.world.clone(), wiring);
    state.pilot.driver.calibration = calibration;
    state.pilot.driver.limits = limits;
    state.told = None;
}

/// No link is wanted any more: the robot is told to stop first.
pub(super) fn unlink(state: &mut State) {
    event(state, Event::Closing);
    if state.bridge.is_none() && state.link != Link::Off {
        state.wanted.push(Effect::Close);
    }
    take(state, Input::Closed);
    (state.link, state.bridge) = (Link::Off, None);
}

/// The link is open: for the first time, or again.
pub(super) fn opened(state: &mut State) {
    if let Link::Opening(_) = state.link {
        state.link = Link::Open;
        take(state, Input::Opened);
    }
}

/// The link is gone, or did not open.
pub(super) fn closed(state: &mut State) {
    let tries = match state.link {
        Link::Open => 0,
        Link::Opening(tries) => tries,
        Link::Off | Link::Lost(_) => return,
    };
    if state.link == Link::Open {
        take(state, Input::Closed);
    }
    state.link = Link::Lost(tries + 1);
    let wait = AGAIN.0.saturating_mul(1 << tries.min(4)).min(AGAIN.1);
    state.wanted.push(Effect::Again(tries + 1, wait));
}

/// It is time to open it again.
pub(super) fn again(state: &mut State, tries: u32) {
    if state.link != Link::Lost(tries) {
        return;
    }
    if let Ok(address) = address(&state.address, state.is_secure) {
        state.link = Link::Opening(tries);
        state.wanted.push(Effect::Open(address));
    }
}
