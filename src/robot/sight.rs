//! The world as it is seen to be: the robot's cell and side from its pose, those of tracked things from theirs, and all else
//! as it is believed to be. Poses are in cells.

use super::geometry::Pose;
use crate::domain::{Cell, Direction, State, cell_at};
use std::f64::consts::{FRAC_PI_2, PI};

/// Why what is seen is no state of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unseen {
    /// The robot is where there is no floor.
    #[error("the robot is at column {0}, row {1}, where there is no floor")]
    Robot(i32, i32),
    /// So is the tracked thing of this number.
    #[error("the tracked thing {0} is where there is no floor")]
    Body(usize),
    /// Two things are in one cell.
    #[error("two things are at column {0}, row {1}")]
    Shared(i32, i32),
}

/// The angle of a side, counter-clockwise from the east.
pub fn angle(direction: Direction) -> f64 {
    match direction {
        Direction::East => 0.0,
        Direction::North => FRAC_PI_2,
        Direction::West => PI,
        Direction::South => -FRAC_PI_2,
    }
}

/// The side that a heading is nearest to.
pub fn side(heading: f64) -> Direction {
    match libm::round(heading / FRAC_PI_2) as i32 {
        0 => Direction::East,
        1 => Direction::North,
        -1 => Direction::South,
        _ => Direction::West,
    }
}

/// The cell that a place is in.
pub fn cell(pose: Pose) -> (i32, i32) {
    (libm::round(pose.x) as i32, libm::round(pose.y) as i32)
}

/// The world as it is seen, all that is not seen as `believed`. `bodies` are places among its objects and poses.
///
/// # Errors
/// Why that is no state of the world.
pub fn look(believed: &State, robot: Pose, bodies: &[(usize, Pose)]) -> Result<State, Unseen> {
    let mut state = believed.clone();
    let is_floor = |(x, y)| cell_at(&believed.rooms, &believed.doors, x, y) != Cell::Wall;
    let (x, y) = cell(robot);
    if !is_floor((x, y)) {
        return Err(Unseen::Robot(x, y));
    }
    (state.agent.x, state.agent.y, state.agent.direction) = (x, y, side(robot.heading));
    for &(index, pose) in bodies {
        let at = cell(pose);
        if !is_floor(at) {
            return Err(Unseen::Body(index));
        }
        if let Some(object) = state.objects.get_mut(index) {
            (object.x, object.y) = at;
        }
    }
    let mut taken = vec![(x, y)];
    for object in &state.objects {
        if taken.contains(&(object.x, object.y)) {
            return Err(Unseen::Shared(object.x, object.y));
        }
        taken.push((object.x, object.y));
    }
    Ok(state)
}
