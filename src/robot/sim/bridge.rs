//! A simulated robot behind a rosbridge of its own: it takes the frames that a real one takes, and gives those that a real one
//! gives, late and with losses as its [`Noise`] says. So a simulated robot is driven through what drives a real one.

use super::base::{Base, Body, STEP};
use super::noise::{Dice, Noise};
use crate::domain::State;
use crate::robot::frame::Frame;
use crate::robot::geometry::{Pose, Twist, quaternion, wrap};
use crate::robot::message::{Command, Generation, Sighting};
use serde_json::{Value, json};
use std::collections::VecDeque;

/// Milliseconds between two poses.
const POSES: f64 = 50.0;

/// How it is wired.
#[derive(Clone, Debug, PartialEq)]
pub struct Plugs {
    /// Which ROS it seems to be.
    pub generation: Generation,
    /// How it takes velocities.
    pub command: Command,
    /// Where.
    pub velocity: String,
    /// How it says poses.
    pub sighting: Sighting,
    /// Where it says its own.
    pub pose: String,
    /// What the topic of an object begins with; nothing where none is tracked.
    pub bodies: Option<String>,
    /// Where the rooms' corner lies in what it says, and how they are turned: poses are seldom said in the rooms' own axes.
    pub origin: Pose,
}

impl Default for Plugs {
    /// A Turtlebot of ROS 2, out of the box.
    fn default() -> Plugs {
        Plugs {
            generation: Generation::Two,
            command: Command::TwistStamped,
            velocity: "/cmd_vel".to_owned(),
            sighting: Sighting::Odometry,
            pose: "/odom".to_owned(),
            bodies: Some("/tracked/".to_owned()),
            origin: Pose::default(),
        }
    }
}

/// A simulated robot behind its bridge.
#[derive(Clone, Debug)]
pub struct Bridge {
    /// The robot.
    pub base: Base,
    /// How it is wired.
    pub plugs: Plugs,
    /// What is not exact.
    pub noise: Noise,
    /// Whether it says where things are.
    pub tells: bool,
    names: Vec<String>,
    dice: Dice,
    now: f64,
    posed: f64,
    /// Whether somebody said that it publishes velocities.
    is_advertised: bool,
    /// Topics that are listened to.
    heard: Vec<String>,
    /// Velocities on their way in, frames on their way out, each with the time when it is there.
    inward: VecDeque<(f64, Twist)>,
    outward: VecDeque<(f64, String)>,
}

impl Bridge {
    /// A robot that stands as the world's does, at a time.
    pub fn new(world: &State, body: Body, noise: Noise, seed: u64, now: f64) -> Bridge {
        let mut dice = Dice::new(seed);
        Bridge {
            base: Base::new(world, body, &noise, &mut dice),
            plugs: Plugs::default(),
            noise,
            tells: true,
            names: world.objects.iter().map(|object| object.name.clone()).collect(),
            dice,
            now,
            posed: now,
            is_advertised: false,
            heard: Vec::new(),
            inward: VecDeque::new(),
            outward: VecDeque::new(),
        }
    }

    /// The topic of an object by its name, if it is tracked.
    pub fn topic_of(&self, name: &str) -> Option<String> {
        let is_name = self.names.iter().any(|own| own == name);
        self.plugs.bodies.as_ref().filter(|_| is_name).map(|start| format!("{start}{name}"))
    }

    /// Whoever was linked is gone: nothing is on its way to or from it any more.
    pub fn unlinked(&mut self) {
        self.heard.clear();
        self.is_advertised = false;
        self.inward.clear();
        self.outward.clear();
    }

    /// Takes a frame at a time.
    pub fn hear(&mut self, text: &str, now: f64) {
        match Frame::read(text) {
            Ok(Frame::Advertise { topic, kind, .. }) if topic == self.plugs.velocity => {
                self.is_advertised = kind == self.plugs.command.name(self.plugs.generation);
            }
            Ok(Frame::Unadvertise { topic, .. }) if topic == self.plugs.velocity => {
                self.is_advertised = false;
            }
            Ok(Frame::Subscribe { topic, .. }) if !self.heard.contains(&topic) => {
                self.heard.push(topic);
            }
            Ok(Frame::Unsubscribe { topic, .. }) => self.heard.retain(|heard| *heard != topic),
            Ok(Frame::Publish { topic, msg, .. }) if topic == self.plugs.velocity => {
                let twist = self.plugs.command.velocity(&msg);
                if let Ok(twist) = twist
                    && self.is_advertised
                    && !self.dice.happens(self.noise.loss)
                {
                    self.inward.push_back((now + self.noise.latency, twist));
                }
            }
            Ok(Frame::CallService { id, service, args }) => self.serve(id, service, &args, now),
            _ => {}
        }
    }

    /// Goes on to a time; the frames that have come out by then.
    pub fn pass(&mut self, now: f64) -> Vec<String> {
        while self.now + STEP <= now {
            self.now += STEP;
            while let Some(&(at, twist)) = self.inward.front().filter(|(at, _)| *at <= self.now) {
                self.base.wants(twist, at);
                self.inward.pop_front();
            }
            self.base.step(self.now, &self.noise, &mut self.dice);
            if self.now - self.posed >= POSES {
                self.posed = self.now;
                self.tell();
            }
        }
        let there = self.outward.iter().take_while(|(at, _)| *at <= now).count();
        self.outward.drain(..there).map(|(_, text)| text).collect()
    }

    /// Says where everything is that is listened to.
    fn tell(&mut self) {
        if !self.tells {
            return;
        }
        let own = (self.plugs.pose.clone(), self.plugs.sighting, self.base.pose);
        let things: Vec<_> = (0..self.names.len())
            .filter_map(|at| {
                let [x, y] = *self.base.things.get(at)?;
                let topic = self.topic_of(self.names.get(at)?)?;
                Some((topic, Sighting::PoseStamped, Pose { x, y, heading: 0.0 }))
            })
            .collect();
        for (topic, sighting, pose) in std::iter::once(own).chain(things) {
            if self.heard.contains(&topic) && !self.dice.happens(self.noise.loss) {
                let origin = self.plugs.origin;
                let (sin, cos) = (libm::sin(origin.heading), libm::cos(origin.heading));
                let seen = Pose {
                    x: origin.x + cos * pose.x - sin * pose.y
                        + self.noise.place * self.dice.normal(),
                    y: origin.y
                        + sin * pose.x
                        + cos * pose.y
                        + self.noise.place * self.dice.normal(),
                    heading: wrap(
                        origin.heading + pose.heading + self.noise.heading * self.dice.normal(),
                    ),
                };
                let msg = message(sighting, self.plugs.generation, seen);
                self.send(&Frame::Publish { id: None, topic, msg }, self.now);
            }
        }
    }

    fn serve(&mut self, id: Option<String>, service: String, args: &Value, now: f64) {
        let topic = args.get("topic").and_then(Value::as_str).unwrap_or_default();
        let Plugs { generation, command, velocity, sighting, pose, .. } = &self.plugs;
        let kind = match topic {
            _ if topic == velocity => command.name(*generation),
            _ if topic == pose => sighting.name(*generation),
            _ if self.names.iter().any(|name| self.topic_of(name).as_deref() == Some(topic)) => {
                Sighting::PoseStamped.name(*generation)
            }
            _ => String::new(),
        };
        let result = service == "/rosapi/topic_type";
        let values = if result {
            json!({ "type": kind })
        } else {
            json!(format!("Service {service} does not exist"))
        };
        self.send(&Frame::ServiceResponse { id, service: Some(service), values, result }, now);
    }

    fn send(&mut self, frame: &Frame, now: f64) {
        self.outward.push_back((now + self.noise.latency, frame.write()));
    }
}

/// A pose as a message.
fn message(sighting: Sighting, generation: Generation, pose: Pose) -> Value {
    let [x, y, z, w] = quaternion(pose.heading);
    let plain = json!({
        "position": { "x": pose.x, "y": pose.y, "z": 0.0 },
        "orientation": { "x": x, "y": y, "z": z, "w": w },
    });
    let stamp = match generation {
        Generation::One => json!({ "secs": 0, "nsecs": 0 }),
        Generation::Two => json!({ "sec": 0, "nanosec": 0 }),
    };
    let header = json!({ "stamp": stamp, "frame_id": "odom" });
    match sighting {
        Sighting::PoseStamped => json!({ "header": header, "pose": plain }),
        Sighting::Odometry => json!({
            "header": header, "child_frame_id": "base_footprint", "pose": { "pose": plain },
        }),
        Sighting::PoseWithCovariance => json!({ "header": header, "pose": { "pose": plain } }),
    }
}
