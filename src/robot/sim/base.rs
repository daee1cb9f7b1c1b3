//! A simulated Turtlebot: two wheels, a round body with a flat front, walls that it cannot pass, things that it pushes, and
//! a base that stops by itself when no velocity comes. Lengths in cells' metres: cell (x, y) has its middle at
//! (size · x, size · y). Pure; advanced in steps of [`STEP`].

use super::noise::{Dice, Noise};
use crate::domain::{Cell, Direction, Lock, State, cell_at};
use crate::robot::geometry::{Pose, Twist, wrap};
use crate::robot::sight::{angle, cell};

/// Milliseconds of a step.
pub const STEP: f64 = 10.0;

/// What a base is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Metres that a cell measures.
    pub size: f64,
    /// The robot's radius in metres.
    pub radius: f64,
    /// Metres from its middle to that of a thing that it pushes.
    pub reach: f64,
    /// How fast it changes its speeds: metres and radians a second squared.
    pub pull: (f64, f64),
    /// Milliseconds without a velocity after which it stops.
    pub timeout: f64,
}

impl Default for Body {
    /// A Turtlebot 2 in cells of half a metre.
    fn default() -> Body {
        Body { size: 0.5, radius: 0.18, reach: 0.33, pull: (2.5, 10.0), timeout: 500.0 }
    }
}

/// A base at work.
#[derive(Clone, Debug)]
pub struct Base {
    /// What it is like.
    pub body: Body,
    /// Where it is.
    pub pose: Pose,
    /// How fast it goes.
    pub twist: Twist,
    /// Where the world's objects are.
    pub things: Vec<[f64; 2]>,
    /// How often it came against a wall.
    pub touches: u32,
    /// The nearest that it came to a wall, in metres between them.
    pub nearest: f64,
    world: State,
    wanted: Twist,
    since: f64,
    /// What its wheels make of a velocity, and how they pull to a side.
    wheels: f64,
    aside: f64,
}

impl Base {
    /// A base that stands as the world's robot does.
    pub fn new(world: &State, body: Body, noise: &Noise, dice: &mut Dice) -> Base {
        let metres = |x: i32, y: i32| [body.size * f64::from(x), body.size * f64::from(y)];
        let [x, y] = metres(world.agent.x, world.agent.y);
        let heading = angle(world.agent.direction);
        let drift = noise.drift;
        Base {
            body,
            pose: Pose { x, y, heading },
            twist: Twist::STOP,
            things: world.objects.iter().map(|object| metres(object.x, object.y)).collect(),
            touches: 0,
            nearest: f64::INFINITY,
            world: world.clone(),
            wanted: Twist::STOP,
            since: f64::NEG_INFINITY,
            wheels: 1.0 + drift * dice.normal(),
            aside: drift * dice.normal(),
        }
    }

    /// Whether it stands.
    pub fn stands(&self) -> bool {
        self.twist == Twist::STOP
    }

    /// A velocity came.
    pub fn wants(&mut self, twist: Twist, now: f64) {
        (self.wanted, self.since) = (twist, now);
    }

    /// A step of time that ends now.
    pub fn step(&mut self, now: f64, noise: &Noise, dice: &mut Dice) {
        if now - self.since > self.body.timeout {
            self.wanted = Twist::STOP;
        }
        let seconds = STEP / 1000.0;
        let towards = |is: f64, wanted: f64, pull: f64| {
            is + (wanted - is).clamp(-pull * seconds, pull * seconds)
        };
        let Twist { linear, angular } = self.wanted;
        self.twist = Twist {
            linear: towards(self.twist.linear, linear, self.body.pull.0),
            angular: towards(self.twist.angular, angular, self.body.pull.1),
        };
        let Twist { linear, angular } = self.twist;
        let real = Twist { linear: self.wheels * linear, angular: angular + self.aside * linear };
        let mut to = self.pose.after(real, seconds);
        // A degree for a quarter turn, in steps that add up to that.
        let quarters = (angular * seconds).abs() / std::f64::consts::FRAC_PI_2;
        to.heading = wrap(to.heading + noise.turn * quarters.sqrt() * dice.normal());
        self.moves(to);
        self.nearest = self.nearest.min(self.clearance(self.pose.x, self.pose.y, self.body.radius));
    }

    /// Moves there, pushing what is in the way; not into a wall.
    fn moves(&mut self, to: Pose) {
        let before = self.things.clone();
        if !self.pushes(to) || self.clearance(to.x, to.y, self.body.radius) <= 0.0 {
            // A robot that turns in place touches nothing that it did not touch.
            if (to.x, to.y) != (self.pose.x, self.pose.y) {
                self.touches += 1;
            }
            self.things = before;
            self.pose.heading = to.heading;
            return;
        }
        self.pose = to;
    }

    /// Pushes what stands before it along the way that it looks; whether that gives way.
    fn pushes(&mut self, to: Pose) -> bool {
        let (cos, sin) = (libm::cos(to.heading), libm::sin(to.heading));
        let reach = self.body.reach;
        for at in 0..self.things.len() {
            let [x, y] = self.things[at];
            let (dx, dy) = (x - to.x, y - to.y);
            let (ahead, beside) = (dx * cos + dy * sin, dy * cos - dx * sin);
            if ahead <= 0.0 || ahead >= reach || beside.abs() >= self.body.radius {
                continue;
            }
            let [x, y] = [x + (reach - ahead) * cos, y + (reach - ahead) * sin];
            let others = self.things.iter().enumerate().filter(|(other, _)| *other != at);
            let mut near = others.map(|(_, [ox, oy])| libm::hypot(ox - x, oy - y));
            let radius = reach - self.body.radius;
            if self.clearance(x, y, radius) <= 0.0 || near.any(|gap| gap < 2.0 * radius) {
                return false;
            }
            self.things[at] = [x, y];
        }
        true
    }

    /// Metres from a disc to the nearest wall.
    fn clearance(&self, x: f64, y: f64, radius: f64) -> f64 {
        let size = self.body.size;
        let at = Pose { x: x / size, y: y / size, heading: 0.0 };
        let (column, row) = cell(at);
        let mut least = f64::INFINITY;
        for (i, j) in (-2..=2).flat_map(|i| (-2..=2).map(move |j| (column + i, row + j))) {
            if self.is_wall(i, j) {
                let over = |at: f64, middle: i32| ((at - f64::from(middle)).abs() - 0.5).max(0.0);
                least = least.min(size * libm::hypot(over(at.x, i), over(at.y, j)));
            }
        }
        least - radius
    }

    fn is_wall(&self, x: i32, y: i32) -> bool {
        match cell_at(&self.world.rooms, &self.world.doors, x, y) {
            Cell::Wall => true,
            Cell::Floor => false,
            Cell::Door(door) => {
                self.world.doors.get(door).is_some_and(|door| door.lock == Lock::Locked)
            }
        }
    }

    /// The world as it is.
    pub fn state(&self) -> State {
        let mut state = self.world.clone();
        let cells = |[x, y]: [f64; 2]| {
            cell(Pose { x: x / self.body.size, y: y / self.body.size, heading: 0.0 })
        };
        (state.agent.x, state.agent.y) = cells([self.pose.x, self.pose.y]);
        state.agent.direction = crate::robot::sight::side(self.pose.heading);
        for (object, place) in state.objects.iter_mut().zip(&self.things) {
            (object.x, object.y) = cells(*place);
        }
        state
    }

    /// Somebody takes the robot elsewhere.
    pub fn carry(&mut self, x: i32, y: i32, direction: Direction) {
        let size = self.body.size;
        let [x, y] = [size * f64::from(x), size * f64::from(y)];
        self.pose = Pose { x, y, heading: angle(direction) };
    }
}
