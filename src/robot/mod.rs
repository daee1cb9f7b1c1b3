//! Driving a robot: plans put on a Turtlebot as velocities over ROS, as in the paper (Section V), by rosbridge's protocol
//! version 2.
//!
//! Pure but for `link`, the socket. Frames (`frame`) and messages (`message`) make a conversation (`session`); poses in
//! metres become cells (`calibration`) and a state of the world (`sight`); a plan (`route`) becomes velocities
//! (`controller`) from where the robot is by now (`estimate`). The driver (`driver`) is a function of its state, an event
//! and the time, and safety is its first concern; `pilot` joins it with the conversation. A simulated robot (`sim`) sits
//! behind frames as a real one does.

pub mod geometry;
pub mod frame;
pub mod message;
pub mod wiring;
pub mod address;
pub mod session;
pub mod sight;
pub mod calibration;
pub mod estimate;
pub mod controller;
pub mod route;
pub mod trial;
pub mod stage;
pub mod driver;
pub mod pilot;
pub mod sim;
#[cfg(target_arch = "wasm32")]
pub mod link;

pub use calibration::{Calibration, Mark};
pub use driver::Driver;
pub use frame::Frame;
pub use geometry::{Pose, Twist};
pub use pilot::{Act, Check, Input, Pilot};
pub use session::Session;
pub use stage::{Event, Halt, Stage, Told};
pub use wiring::{Limits, Wiring};
