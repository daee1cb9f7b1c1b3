//! A plan carried out by a simulated robot, without a clock: what a dry run can say of it before anything moves.

use super::base::Body;
use super::bridge::{Bridge, Plugs};
use super::noise::Noise;
use crate::domain::State;
use crate::robot::calibration::Calibration;
use crate::robot::pilot::{Act, Input, Pilot};
use crate::robot::stage::{Event, Halt, Stage, Told};
use crate::robot::wiring::{Limits, Wiring};

/// Milliseconds of a rehearsal at most.
const LONGEST: f64 = 1_800_000.0;
/// Milliseconds between two looks.
const TICK: f64 = 20.0;

/// What came of a rehearsal.
#[derive(Clone, Debug, PartialEq)]
pub struct Rehearsal {
    /// Whether it came to the end of the plan, as planned.
    pub is_done: bool,
    /// Seconds that it took.
    pub seconds: f64,
    /// Metres between the robot and the nearest wall on the way.
    pub nearest: f64,
    /// Why it stopped, if it did.
    pub halt: Option<Halt>,
}

/// Carries out a plan's states in cells of so many metres, with the usual noise.
pub fn rehearse(states: &[State], size: f64, limits: Limits, seed: u64) -> Option<Rehearsal> {
    let world = states.first()?;
    let body = Body { size, reach: limits.reach, ..Body::default() };
    let mut bridge = Bridge::new(world, body, Noise::default(), seed, 0.0);
    bridge.plugs = Plugs { bodies: None, ..Plugs::default() };
    let mut pilot = Pilot::new(world.clone(), Wiring::default());
    pilot.driver.calibration = Some(Calibration::plain(size, (0, 0), [0.0; 2]));
    pilot.driver.limits = limits;
    // It is the plan that is looked at here, and not the base.
    pilot.driver.stops = Some(0);
    let mut now = 0.0;
    let mut told = Vec::new();
    let mut take = |pilot: &mut Pilot, bridge: &mut Bridge, input: Input, now: f64| {
        for act in pilot.take(input, now) {
            match act {
                Act::Send(text) => bridge.hear(&text, now),
                Act::Tell(words) => told.push(words),
                Act::Plan(_) => {}
            }
        }
    };
    take(&mut pilot, &mut bridge, Input::Opened, now);
    let mut is_begun = false;
    while now < LONGEST {
        now += TICK;
        for text in bridge.pass(now) {
            take(&mut pilot, &mut bridge, Input::Heard(text), now);
        }
        take(&mut pilot, &mut bridge, Input::Event(Event::Tick), now);
        if !is_begun && now > 1_000.0 {
            is_begun = true;
            for event in [Event::Route(states.to_vec()), Event::Arm, Event::Held(true)] {
                take(&mut pilot, &mut bridge, Input::Event(event), now);
            }
        }
        let is_over = pilot.driver.stage != Stage::Driving || pilot.driver.is_thinking();
        if is_begun && is_over {
            break;
        }
    }
    let halt = match &pilot.driver.stage {
        Stage::Halted(halt) => Some(halt.clone()),
        _ => None,
    };
    let is_done = states.len() < 2 || told.contains(&Told::Arrived);
    Some(Rehearsal {
        is_done,
        seconds: (now - 1_000.0) / 1000.0,
        nearest: bridge.base.nearest,
        halt,
    })
}
