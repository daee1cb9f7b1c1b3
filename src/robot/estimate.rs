//! Where the robot is by now: what was sent is driven on in thought, and every pose that comes in, which says where it was a
//! moment ago, corrects that. A filter of fixed gain over a short past, in metres.

use super::geometry::{Pose, Twist, wrap};
use std::collections::VecDeque;

/// Milliseconds from a velocity that is sent to a pose that shows it.
const LAG: f64 = 200.0;
/// Milliseconds of the past that are kept.
const KEPT: f64 = 800.0;
/// Milliseconds in which two thirds of a difference are made up.
const SETTLING: f64 = 350.0;
/// What one pose corrects at most.
const MOST_GAIN: f64 = 0.6;

/// Where the robot is by now, and was.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Times and poses, the newest last.
    past: VecDeque<(f64, Pose)>,
    twist: Twist,
    seen: f64,
}

impl Estimate {
    /// Where it is; nothing before the first pose.
    pub fn pose(&self) -> Option<Pose> {
        self.past.back().map(|&(_, pose)| pose)
    }

    /// Time has gone on.
    pub fn pass(&mut self, now: f64) {
        let Some(&(then, pose)) = self.past.back() else { return };
        if now > then {
            self.past.push_back((now, pose.after(self.twist, (now - then) / 1000.0)));
        }
        while self.past.len() > 1 && self.past.front().is_some_and(|(at, _)| now - at > KEPT) {
            self.past.pop_front();
        }
    }

    /// A velocity was sent.
    pub fn sent(&mut self, twist: Twist, now: f64) {
        self.pass(now);
        self.twist = twist;
    }

    /// It was told to stop.
    pub fn halt(&mut self) {
        self.twist = Twist::STOP;
    }

    /// A pose came in; how far off, in metres and radians, it was from where the robot was thought to be.
    pub fn saw(&mut self, pose: Pose, now: f64) -> (f64, f64) {
        self.pass(now);
        let since = now - std::mem::replace(&mut self.seen, now);
        let then = self.past.iter().rev().find(|(at, _)| now - at >= LAG).or(self.past.front());
        let Some(&(_, thought)) = then else {
            self.past.push_back((now, pose));
            return (0.0, 0.0);
        };
        let (x, y, turn) =
            (pose.x - thought.x, pose.y - thought.y, wrap(pose.heading - thought.heading));
        let gain = (1.0 - libm::exp(-since.max(0.0) / SETTLING)).min(MOST_GAIN);
        for (_, past) in &mut self.past {
            past.x += gain * x;
            past.y += gain * y;
            past.heading = wrap(past.heading + gain * turn);
        }
        (libm::hypot(x, y), turn.abs())
    }

    /// Forgets all: the robot may have been carried.
    pub fn forget(&mut self) {
        *self = Estimate::default();
    }
}
