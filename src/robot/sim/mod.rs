//! A simulated Turtlebot: the base (`base`), what is not exact about it (`noise`), and the bridge that it is driven through
//! (`bridge`), which speaks the protocol of a real one.

pub mod noise;
pub mod base;
pub mod bridge;
pub mod rehearsal;

pub use base::{Base, Body};
pub use bridge::{Bridge, Plugs};
pub use noise::{Dice, Noise};
pub use rehearsal::{Rehearsal, rehearse};
