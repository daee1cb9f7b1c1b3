//! Watching a plan: where in it the robot is, how fast it goes, and what else there is to see.

pub mod playback;
pub mod course;
pub mod chart;
pub mod state;
pub mod values;
pub mod play;
pub mod ahead;
