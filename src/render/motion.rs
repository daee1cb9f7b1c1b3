//! The way from one state to the next, for animation: robot and pushed object glide, the heading turns the short
//! way round. Pure: the caller has the clock and says how far it is, `t` in 0..=1.

use super::options::Options;
use super::pose::Pose;
use super::scene::Scene;
use crate::domain::State;
use std::f32::consts::{PI, TAU};

/// The way from one state to another. Doors and new objects show as in the second from the start.
#[derive(Clone, Debug)]
pub struct Motion {
    from: Pose,
    to: Pose,
    state: State,
}

impl Motion {
    /// The share of the time in which the robot turns.
    const TURNING: f32 = 0.6;

    /// Between two states of one world; objects are the same when their names are.
    pub fn between(before: &State, after: &State) -> Self {
        let to = Pose::of(after);
        let mut from = Pose::of(before);
        from.objects = after
            .objects
            .iter()
            .map(|o| before.objects.iter().find(|b| b.name == o.name).unwrap_or(o))
            .map(|o| [o.x as f32, o.y as f32])
            .collect();
        Self { from, to, state: after.clone() }
    }

    /// Whether nothing moves.
    pub fn is_still(&self) -> bool {
        self.from == self.to
    }

    /// The pose at `t`, eased in and out; `t` is cut to 0..=1.
    pub fn pose(&self, t: f32) -> Pose {
        if t >= 1.0 || t.is_nan() {
            return self.to.clone();
        }
        let t = t.max(0.0);
        let glide = |a: [f32; 2], b: [f32; 2]| {
            let s = ease(t);
            [a[0] + (b[0] - a[0]) * s, a[1] + (b[1] - a[1]) * s]
        };
        let turned = short_way(self.to.turn - self.from.turn) * ease((t / Self::TURNING).min(1.0));
        let objects = self.from.objects.iter().zip(&self.to.objects);
        Pose {
            robot: glide(self.from.robot, self.to.robot),
            turn: self.from.turn + turned,
            objects: objects.map(|(a, b)| glide(*a, *b)).collect(),
        }
    }

    /// The picture at `t`.
    pub fn scene_at(&self, t: f32, options: &Options) -> Scene {
        Scene::posed(&self.state, &self.pose(t), options)
    }
}

/// Slow, fast, slow: the cubic with level ends.
fn ease(t: f32) -> f32 {
    t * t * (3.0 - 2.0 * t)
}

/// The same angle in -π..=π.
fn short_way(angle: f32) -> f32 {
    let mut angle = angle % TAU;
    if angle > PI {
        angle -= TAU;
    } else if angle < -PI {
        angle += TAU;
    }
    angle
}
