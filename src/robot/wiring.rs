//! How a robot is wired: which topic takes its velocity, which say where things are, and how fast it may go.

use super::geometry::Twist;
use super::message::{Command, Generation, Sighting};
use serde::{Deserialize, Serialize};

/// The highest speed that can be allowed, in metres a second.
pub const FASTEST: f64 = 0.5;
/// The highest turning that can be allowed, in radians a second.
pub const QUICKEST: f64 = 1.5;

/// The topics of a robot.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Wiring {
    /// Where it takes its velocity.
    pub velocity: String,
    /// Where it is told to be.
    pub pose: String,
    /// Things that are tracked: the object's name in the world, and the topic that says where it is.
    pub bodies: Vec<(String, String)>,
    /// The types, where they are not to be asked of the bridge.
    pub types: Option<Types>,
}

/// Types of the messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Types {
    /// Which ROS it is.
    pub generation: Generation,
    /// How the base takes its velocity.
    pub command: Command,
    /// How poses are said.
    pub sighting: Sighting,
}

impl Default for Wiring {
    /// That of every Turtlebot out of the box.
    fn default() -> Wiring {
        Wiring {
            velocity: "/cmd_vel".to_owned(),
            pose: "/odom".to_owned(),
            bodies: Vec::new(),
            types: None,
        }
    }
}

/// How fast a robot may go, and what is known of its shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Metres a second.
    pub speed: f64,
    /// Radians a second.
    pub turning: f64,
    /// Metres from the robot's middle to that of a thing that it pushes.
    pub reach: f64,
}

impl Default for Limits {
    /// Slower than the slowest Turtlebot can go.
    fn default() -> Limits {
        Limits { speed: 0.18, turning: 0.9, reach: 0.33 }
    }
}

impl Limits {
    /// The same within what can be allowed at all; what is no number is as slow as can be.
    pub fn capped(self) -> Limits {
        let within = |value: f64, least: f64, most: f64| {
            if value.is_finite() { value.clamp(least, most) } else { least }
        };
        Limits {
            speed: within(self.speed, 0.02, FASTEST),
            turning: within(self.turning, 0.1, QUICKEST),
            reach: within(self.reach, 0.0, 1.0),
        }
    }

    /// A velocity within them.
    pub fn cap(self, twist: Twist) -> Twist {
        twist.capped(self.speed, self.turning)
    }
}
