//! Where the robot and the objects of a picture are, in their cells or between them. Angles are radians
//! counter-clockwise from north, lengths are cells.

use crate::domain::{Direction, State};
use std::f32::consts::{FRAC_PI_2, PI};

/// Where the things that move are, between cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The robot.
    pub robot: [f32; 2],
    /// Where the robot looks.
    pub turn: f32,
    /// The objects, in the state's order.
    pub objects: Vec<[f32; 2]>,
}

impl Pose {
    /// Everything in its cell.
    pub fn of(state: &State) -> Self {
        let objects = state.objects.iter().map(|o| [o.x as f32, o.y as f32]).collect();
        Self {
            robot: [state.agent.x as f32, state.agent.y as f32],
            turn: heading(state.agent.direction),
            objects,
        }
    }
}

/// How far a thing that looks north is turned to look that way.
pub(super) fn heading(direction: Direction) -> f32 {
    match direction {
        Direction::North => 0.0,
        Direction::West => FRAC_PI_2,
        Direction::South => PI,
        Direction::East => -FRAC_PI_2,
    }
}
