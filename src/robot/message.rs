//! The messages of ROS that a robot is driven by and told of, as rosbridge has them in JSON. Types have other names in
//! ROS 2 (`geometry_msgs/msg/Twist`) than in ROS 1 (`geometry_msgs/Twist`), and stamps other fields.

use super::geometry::{Pose, Twist, yaw};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// Which ROS it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Generation {
    /// ROS 1.
    One,
    /// ROS 2.
    Two,
}

/// How a base takes its velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Command {
    /// `geometry_msgs/Twist`.
    Twist,
    /// `geometry_msgs/TwistStamped`, as the newer TurtleBot stacks of ROS 2 take it.
    TwistStamped,
}

/// How somebody says where something is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sighting {
    /// `nav_msgs/Odometry`: what the wheels say.
    Odometry,
    /// `geometry_msgs/PoseStamped`: what a motion capture says, one topic a body.
    PoseStamped,
    /// `geometry_msgs/PoseWithCovarianceStamped`: what a localiser such as AMCL says.
    PoseWithCovariance,
}

/// What is wrong with a message; the field by its way from the message.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Flaw {
    /// `null` stands in a number's place: what newer bridges write for NaN and infinity.
    #[error("null where a number belongs, in {0}")]
    Null(String),
    /// There is no such field, or no number in it: another type of message.
    #[error("no number in {0}")]
    Missing(String),
    /// The orientation is no turn, such as one of zeros.
    #[error("an orientation that is none")]
    NoTurn,
}

impl Generation {
    /// A type's name, of a package's and its own.
    fn name(self, package: &str, own: &str) -> String {
        match self {
            Generation::One => format!("{package}/{own}"),
            Generation::Two => format!("{package}/msg/{own}"),
        }
    }

    /// A stamp that says nothing of the time: a browser's clock is not the robot's, and a base that compares the two
    /// refuses what it takes to be old. For zero it takes its own.
    fn header(self) -> Value {
        match self {
            Generation::One => {
                json!({ "seq": 0, "stamp": { "secs": 0, "nsecs": 0 }, "frame_id": "" })
            }
            Generation::Two => json!({ "stamp": { "sec": 0, "nanosec": 0 }, "frame_id": "" }),
        }
    }
}

/// Package, own name and generation of a type's name.
fn parts(name: &str) -> Option<(&str, &str, Generation)> {
    let (package, own) = name.split_once('/')?;
    Some(match own.strip_prefix("msg/") {
        Some(own) => (package, own, Generation::Two),
        None => (package, own, Generation::One),
    })
}

impl Command {
    /// What a type's name says; nothing for a type that drives no base.
    pub fn of(name: &str) -> Option<(Command, Generation)> {
        let (package, own, generation) = parts(name)?;
        let command = match own {
            "Twist" => Command::Twist,
            "TwistStamped" => Command::TwistStamped,
            _ => return None,
        };
        (package == "geometry_msgs").then_some((command, generation))
    }

    /// The type's name.
    pub fn name(self, generation: Generation) -> String {
        let own = match self {
            Command::Twist => "Twist",
            Command::TwistStamped => "TwistStamped",
        };
        generation.name("geometry_msgs", own)
    }

    /// The message of a velocity; nothing where that is no number.
    pub fn message(self, generation: Generation, twist: Twist) -> Option<Value> {
        let vector = |x: f64, z: f64| json!({ "x": x, "y": 0.0, "z": z });
        let plain =
            json!({ "linear": vector(twist.linear, 0.0), "angular": vector(0.0, twist.angular) });
        twist.is_finite().then(|| match self {
            Command::Twist => plain,
            Command::TwistStamped => json!({ "header": generation.header(), "twist": plain }),
        })
    }

    /// The velocity of a message.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn velocity(self, message: &Value) -> Result<Twist, Flaw> {
        let way: &[&str] = match self {
            Command::Twist => &[],
            Command::TwistStamped => &["twist"],
        };
        let part = |vector, axis| number(message, &[way, &[vector, axis]].concat());
        Ok(Twist { linear: part("linear", "x")?, angular: part("angular", "z")? })
    }
}

impl Sighting {
    /// What a type's name says; nothing for a type that holds no pose.
    pub fn of(name: &str) -> Option<(Sighting, Generation)> {
        let (package, own, generation) = parts(name)?;
        let sighting = match (package, own) {
            ("nav_msgs", "Odometry") => Sighting::Odometry,
            ("geometry_msgs", "PoseStamped") => Sighting::PoseStamped,
            ("geometry_msgs", "PoseWithCovarianceStamped") => Sighting::PoseWithCovariance,
            _ => return None,
        };
        Some((sighting, generation))
    }

    /// The type's name.
    pub fn name(self, generation: Generation) -> String {
        let (package, own) = match self {
            Sighting::Odometry => ("nav_msgs", "Odometry"),
            Sighting::PoseStamped => ("geometry_msgs", "PoseStamped"),
            Sighting::PoseWithCovariance => ("geometry_msgs", "PoseWithCovarianceStamped"),
        };
        generation.name(package, own)
    }

    /// The pose of a message.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn pose(self, message: &Value) -> Result<Pose, Flaw> {
        let way: &[&str] = match self {
            Sighting::PoseStamped => &["pose"],
            Sighting::Odometry | Sighting::PoseWithCovariance => &["pose", "pose"],
        };
        let part = |group, name| number(message, &[way, &[group, name]].concat());
        let turn = |name| part("orientation", name);
        let orientation = [turn("x")?, turn("y")?, turn("z")?, turn("w")?];
        let heading = yaw(orientation).ok_or(Flaw::NoTurn)?;
        Ok(Pose { x: part("position", "x")?, y: part("position", "y")?, heading })
    }
}

fn number(message: &Value, way: &[&str]) -> Result<f64, Flaw> {
    let found = way.iter().try_fold(message, |value, name| value.get(*name));
    match found {
        Some(Value::Null) => Err(Flaw::Null(way.join("."))),
        found => found.and_then(Value::as_f64).ok_or_else(|| Flaw::Missing(way.join("."))),
    }
}
