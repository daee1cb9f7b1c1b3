//! Where the robot is: which rooms it is in, and how metres are mapped to their cells.

use super::drive::unlink;
use super::state::{Kind, State};
use crate::domain::State as World;
use crate::robot::calibration::{Calibration, Mark, corners};
use crate::ui::page::world::WORLDS;

/// Metres that a cell can measure.
const SIZES: (f64, f64) = (0.2, 3.0);

/// One of the page's worlds is that of the robot.
pub(super) fn pick(state: &mut State, place: usize) {
    if let Some(world) = WORLDS.get(place).and_then(|choice| choice.open()) {
        open(state, world, Some(place));
    }
}

/// Another world: nothing that was said or calibrated holds in it.
pub(super) fn open(state: &mut State, world: World, preset: Option<usize>) {
    unlink(state);
    state.wiring.bodies =
        world.objects.iter().map(|object| (object.name.clone(), String::new())).collect();
    state.pilot.place_in(world.clone(), None);
    (state.world, state.preset, state.said, state.rehearsal) = (world, preset, None, None);
    (state.marks, state.uncalibrated, state.undrawn) = (None, None, None);
    state.is_recalled = false;
}

/// A cell measures so many metres.
pub(super) fn size(state: &mut State, size: f64) {
    if !size.is_finite() {
        return;
    }
    state.size = size.clamp(SIZES.0, SIZES.1);
    state.pilot.driver.calibration = None;
    if state.kind == Kind::Simulated {
        unlink(state);
    }
}

/// The robot stands as it is drawn: in the middle of its cell, looking to its side.
pub(super) fn here(state: &mut State) {
    let Some(seen) = state.pilot.driver.pose() else { return };
    let calibration = Calibration::here(state.size, &state.world.agent, seen);
    calibrated(state, calibration);
}

/// The corner to stand in next, if corners are being noted.
pub fn corner(state: &State) -> Option<(i32, i32)> {
    let marks = state.marks.as_ref()?;
    corners(&state.world).get(marks.len()).copied()
}

/// The robot stands in the corner that was asked for.
pub(super) fn note(state: &mut State) {
    let Some((cell, seen)) = corner(state).zip(state.pilot.driver.pose()) else { return };
    let Some(marks) = &mut state.marks else { return };
    marks.push(Mark { metres: [seen.x, seen.y], cell });
    if marks.len() < corners(&state.world).len() {
        return;
    }
    match Calibration::fit(marks) {
        Ok(calibration) => calibrated(state, calibration),
        Err(why) => (state.marks, state.uncalibrated) = (None, Some(why)),
    }
}

fn calibrated(state: &mut State, calibration: Calibration) {
    state.pilot.driver.calibration = Some(calibration);
    (state.marks, state.uncalibrated, state.is_recalled) = (None, None, false);
}
