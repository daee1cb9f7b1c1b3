//! Poses and velocities in a plane, as ROS has them (REP 103): metres and radians, angles counter-clockwise from +x.

use std::f64::consts::{PI, TAU};

/// Where something is and which way it looks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// To the east.
    pub x: f64,
    /// To the north.
    pub y: f64,
    /// Counter-clockwise from +x, in (-π, π].
    pub heading: f64,
}

/// A velocity of a base that drives ahead and turns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Metres a second, ahead.
    pub linear: f64,
    /// Radians a second, counter-clockwise.
    pub angular: f64,
}

impl Twist {
    /// No velocity.
    pub const STOP: Twist = Twist { linear: 0.0, angular: 0.0 };

    /// Whether both parts are numbers that can be meant.
    pub fn is_finite(self) -> bool {
        self.linear.is_finite() && self.angular.is_finite()
    }

    /// The same, each part at most so large; a part that is no number is 0.
    pub fn capped(self, linear: f64, angular: f64) -> Twist {
        let cap = |part: f64, most: f64| if part.is_nan() { 0.0 } else { part.clamp(-most, most) };
        Twist { linear: cap(self.linear, linear), angular: cap(self.angular, angular) }
    }
}

impl Pose {
    /// The pose after this velocity was held for so many seconds: along the circle that it means.
    pub fn after(self, twist: Twist, seconds: f64) -> Pose {
        let turn = twist.angular * seconds;
        // The chord of the arc lies halfway between the headings.
        let way = twist.linear
            * seconds
            * if turn == 0.0 { 1.0 } else { libm::sin(turn / 2.0) / (turn / 2.0) };
        let middle = self.heading + turn / 2.0;
        Pose {
            x: self.x + way * libm::cos(middle),
            y: self.y + way * libm::sin(middle),
            heading: wrap(self.heading + turn),
        }
    }

    /// How far it is to a point.
    pub fn distance(self, x: f64, y: f64) -> f64 {
        libm::hypot(self.x - x, self.y - y)
    }
}

/// The same angle in (-π, π].
pub fn wrap(angle: f64) -> f64 {
    let turned = (angle + PI) % TAU;
    let positive = if turned <= 0.0 { turned + TAU } else { turned };
    positive - PI
}

/// The heading of a quaternion (x, y, z, w): its turn about the vertical. Nothing where it is no turn at all, as one of
/// zeros, which a driver sends that never set it.
pub fn yaw([x, y, z, w]: [f64; 4]) -> Option<f64> {
    let norm = x * x + y * y + z * z + w * w;
    let is_turn = (0.8..1.25).contains(&norm);
    is_turn.then(|| libm::atan2(2.0 * (w * z + x * y), norm - 2.0 * (y * y + z * z)))
}

/// The quaternion (x, y, z, w) of a heading.
pub fn quaternion(heading: f64) -> [f64; 4] {
    [0.0, 0.0, libm::sin(heading / 2.0), libm::cos(heading / 2.0)]
}
