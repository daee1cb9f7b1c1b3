//! What is not exact about a simulated robot, and the dice that it is drawn with: a seed, no clock.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::TAU;

/// What is not exact. Standard deviations, where it is a length or an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// By what share the wheels turn more or less than they should, and pull to a side.
    pub drift: f64,
    /// Radians that a quarter turn ends beside.
    pub turn: f64,
    /// Milliseconds from a message that is sent to its being heard, each way.
    pub latency: f64,
    /// Metres that a pose is off, each way.
    pub place: f64,
    /// Radians that it is.
    pub heading: f64,
    /// The share of messages that are lost.
    pub loss: f64,
}

impl Noise {
    /// Everything exact, and at once.
    pub const NONE: Noise =
        Noise { drift: 0.0, turn: 0.0, latency: 0.0, place: 0.0, heading: 0.0, loss: 0.0 };
}

impl Default for Noise {
    /// What a Turtlebot with a camera over it is like at its worst.
    fn default() -> Noise {
        Noise {
            drift: 0.02,
            turn: 1.0_f64.to_radians(),
            latency: 100.0,
            place: 0.02,
            heading: 2.0_f64.to_radians(),
            loss: 0.01,
        }
    }
}

/// Dice of a seed.
#[derive(Clone, Debug)]
pub struct Dice(Pcg64Mcg);

impl Dice {
    /// Those of a seed.
    pub fn new(seed: u64) -> Dice {
        Dice(Pcg64Mcg::seed_from_u64(seed))
    }

    /// Normally distributed about 0, with a standard deviation of 1 (Box and Muller 1958).
    pub fn normal(&mut self) -> f64 {
        // Not 0, which has no logarithm.
        let u = 1.0 - self.0.random::<f64>();
        (-2.0 * libm::log(u)).sqrt() * libm::cos(TAU * self.0.random::<f64>())
    }

    /// Whether something of this chance happens.
    pub fn happens(&mut self, chance: f64) -> bool {
        self.0.random::<f64>() < chance
    }
}
