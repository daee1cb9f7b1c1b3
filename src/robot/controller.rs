//! The velocity that takes a robot to the next cell: it turns towards where it is to look, then drives along the line to the
//! cell's middle, steering back to that line; behind a thing that it pushes it goes on, and comes back. Lengths in metres,
//! in the frame of the cells turned and scaled.

use super::geometry::{Pose, Twist, wrap};
use super::wiring::Limits;

/// Radians within which it looks where it should.
const AIMED: f64 = 0.05;
/// Radians beyond which it turns in place before it drives on.
const ASTRAY: f64 = 0.35;
/// Metres within which it is there.
const THERE: f64 = 0.02;
/// Speed and turning for every metre and radian that are left, a second.
const EAGER: f64 = 1.5;
/// Radians that it steers for every metre that it is beside its line, and at most.
const STEERING: (f64, f64) = (2.5, 0.5);
/// The slowest that it goes before it is there.
const SLOWEST: (f64, f64) = (0.03, 0.12);

/// What is to be reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// To look this way.
    Look(f64),
    /// To be at the middle of this place's line, having driven ahead along its heading.
    Ahead(Pose),
    /// The same, having driven back.
    Back(Pose),
}

/// The velocity towards a target; nothing once it is reached.
pub fn towards(pose: Pose, target: Target, limits: Limits) -> Option<Twist> {
    match target {
        Target::Look(heading) => {
            let left = wrap(heading - pose.heading);
            (left.abs() > AIMED).then(|| turning(left, limits))
        }
        Target::Ahead(place) => along(pose, place, 1.0, limits),
        Target::Back(place) => along(pose, place, -1.0, limits),
    }
}

/// Along a line, ahead (1) or back (-1).
fn along(pose: Pose, place: Pose, sign: f64, limits: Limits) -> Option<Twist> {
    let (sin, cos) = (libm::sin(place.heading), libm::cos(place.heading));
    let (x, y) = (place.x - pose.x, place.y - pose.y);
    let left = sign * (x * cos + y * sin);
    // Positive where the line lies to the left of the robot.
    let beside = y * cos - x * sin;
    if left <= THERE {
        return None;
    }
    let steer = (sign * STEERING.0 * beside).clamp(-STEERING.1, STEERING.1);
    let astray = wrap(place.heading + steer - pose.heading);
    if wrap(place.heading - pose.heading).abs() > ASTRAY + STEERING.1 {
        return Some(turning(wrap(place.heading - pose.heading), limits));
    }
    if astray.abs() > ASTRAY {
        return Some(turning(astray, limits));
    }
    let speed = (EAGER * left).clamp(SLOWEST.0, limits.speed.max(SLOWEST.0)) * libm::cos(astray);
    Some(limits.cap(Twist { linear: sign * speed, angular: EAGER * astray }))
}

fn turning(left: f64, limits: Limits) -> Twist {
    let speed = (EAGER * left.abs()).clamp(SLOWEST.1, limits.turning.max(SLOWEST.1));
    limits.cap(Twist { linear: 0.0, angular: speed.copysign(left) })
}
