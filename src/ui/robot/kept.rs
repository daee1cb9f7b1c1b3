//! How a robot is set up, as a text that is kept: which one it is, its address and topics, its rooms, how metres are mapped
//! to their cells, how fast it may go. The next visit begins with it. That it may be driven is never kept.

use super::effect::Effect;
use super::place;
use super::state::{Kind, Link, State};
use crate::domain::State as World;
use crate::robot::Wiring;
use crate::robot::calibration::Calibration;
use crate::robot::wiring::Limits;
use serde::{Deserialize, Serialize};

/// What the text calls itself.
const FORMAT: &str = "groundling robot 1";

#[derive(Serialize, Deserialize)]
struct Setup {
    format: String,
    kind: Kind,
    address: String,
    wiring: Wiring,
    preset: Option<usize>,
    world: World,
    size: f64,
    calibration: Option<Calibration>,
    speed: f64,
}

/// The text of how it is set up.
pub fn write(state: &State) -> String {
    // Where the simulated robot is, it says anew each time.
    let calibration = state.pilot.driver.calibration.filter(|_| state.kind == Kind::Real);
    let setup = Setup {
        format: FORMAT.to_owned(),
        kind: state.kind,
        address: state.address.clone(),
        wiring: state.wiring.clone(),
        preset: state.preset,
        world: state.world.clone(),
        size: state.size,
        calibration,
        speed: state.limits().speed,
    };
    // Names, numbers and a state: JSON can hold them all.
    serde_json::to_string(&setup).unwrap_or_default()
}

/// Has the set-up kept, where it is not as it was kept last.
pub(super) fn keep(state: &mut State) {
    let text = write(state);
    if state.kept.as_ref().is_some_and(|kept| *kept != text) {
        state.kept = Some(text.clone());
        state.wanted.push(Effect::Keep(text));
    }
}

/// What was kept has come, or there is nothing: from now on what changes is kept. What a person has changed meanwhile
/// stays, and so does a text that is none.
pub(super) fn recall(state: &mut State, text: Option<&str>) {
    let is_untouched = state.link == Link::Off && write(state) == write(&fresh());
    if let Some(setup) = text.and_then(read).filter(|_| is_untouched) {
        place::open(state, setup.world, setup.preset);
        let names = |wiring: &Wiring| -> Vec<String> {
            wiring.bodies.iter().map(|(name, _)| name.clone()).collect()
        };
        if names(&setup.wiring) == names(&state.wiring) {
            state.wiring = setup.wiring;
        }
        (state.kind, state.address) = (setup.kind, setup.address);
        place::size(state, setup.size);
        state.pilot.driver.calibration = setup.calibration;
        state.pilot.driver.limits = Limits { speed: setup.speed, ..Limits::default() }.capped();
        state.is_recalled = state.pilot.driver.calibration.is_some();
    }
    state.kept = Some(write(state));
}

/// The page as it opens.
fn fresh() -> State {
    let mut state = State::new();
    place::pick(&mut state, 0);
    state
}

/// A set-up, if that is one.
fn read(text: &str) -> Option<Setup> {
    let setup: Setup = serde_json::from_str(text).ok()?;
    let is_sound = setup.format == FORMAT
        && setup.world.check().is_ok()
        && setup.size.is_finite()
        && setup.calibration.is_none_or(|found| found.is_sound());
    is_sound.then_some(setup)
}
