//! Driving a robot: frames and messages, sessions, calibration, what stops it, and runs of a simulated one.

#[path = "robot/brain.rs"]
mod brain;
#[path = "robot/calibrations.rs"]
mod calibrations;
#[path = "robot/frames.rs"]
mod frames;
#[path = "robot/runs.rs"]
mod runs;
#[path = "robot/sessions.rs"]
mod sessions;
#[path = "robot/sockets.rs"]
mod sockets;
#[path = "robot/stops.rs"]
mod stops;

use brain::Brain;
use groundling::domain::{State, text};
use groundling::robot::sim::{Body, Bridge, Noise};
use groundling::robot::{Act, Calibration, Event, Input, Pilot, Stage, Told, Wiring};

pub(crate) const WORLD: &str = include_str!("../../assets/worlds/three-rooms.txt");

/// A pilot and a simulated robot, with a link between them, by the simulation's clock.
pub(crate) struct Rig {
    pub(crate) pilot: Pilot,
    pub(crate) bridge: Bridge,
    pub(crate) now: f64,
    pub(crate) told: Vec<(f64, Told)>,
    pub(crate) sent: Vec<(f64, String)>,
    /// Whether what either says arrives at the other.
    pub(crate) is_linked: bool,
    brain: Option<Brain>,
}

impl Rig {
    /// A robot in a world, seen as its things are.
    pub(crate) fn new(world: &State, noise: Noise, seed: u64) -> Rig {
        let bridge = Bridge::new(world, Body::default(), noise, seed, 0.0);
        let objects = world.objects.iter().map(|object| object.name.clone());
        let bodies = objects.filter_map(|name| Some((name.clone(), bridge.topic_of(&name)?)));
        let wiring = Wiring { bodies: bodies.collect(), ..Wiring::default() };
        let mut pilot = Pilot::new(world.clone(), wiring);
        pilot.driver.calibration = Some(Calibration::plain(0.5, (0, 0), [0.0, 0.0]));
        Rig {
            pilot,
            bridge,
            now: 0.0,
            told: Vec::new(),
            sent: Vec::new(),
            is_linked: false,
            brain: None,
        }
    }

    /// One that was looked at, and may be driven.
    pub(crate) fn armed(world: &State, noise: Noise, seed: u64) -> Rig {
        let mut rig = Rig::new(world, noise, seed);
        rig.link();
        rig.pass(1_500.0);
        assert!(rig.pilot.can_try(rig.now), "{:?}", rig.pilot);
        rig.event(Event::Try);
        rig.event(Event::Held(true));
        rig.until(6_000.0, |rig| rig.pilot.driver.stage == Stage::Off);
        assert!(rig.pilot.driver.stops.is_some(), "{:?}", rig.told);
        rig.event(Event::Held(false));
        rig.event(Event::Arm);
        assert_eq!(rig.pilot.driver.stage, Stage::Ready);
        rig.pass(500.0);
        rig
    }

    /// One that drives towards something.
    pub(crate) fn driving(world: &State, noise: Noise, seed: u64, goal: &str) -> Rig {
        let mut rig = Rig::armed(world, noise, seed);
        rig.ask(goal);
        rig.event(Event::Held(true));
        rig.until(5_000.0, |rig| rig.bridge.base.twist.linear > 0.1);
        rig
    }

    pub(crate) fn link(&mut self) {
        self.is_linked = true;
        self.input(Input::Opened);
    }

    /// A command's goal: it is planned for from the world as it is seen.
    pub(crate) fn ask(&mut self, goal: &str) {
        let seen = self.pilot.driver.look().unwrap().unwrap();
        let brain = Brain::new(goal, &seen);
        let states = brain.plan(std::slice::from_ref(&seen));
        let states = states.unwrap_or_else(|| panic!("no plan for {goal} in {seen:?}"));
        self.brain = Some(brain);
        self.event(Event::Route(states));
    }

    pub(crate) fn event(&mut self, event: Event) {
        self.input(Input::Event(event));
    }

    pub(crate) fn input(&mut self, input: Input) {
        for act in self.pilot.take(input, self.now) {
            match act {
                Act::Send(text) => {
                    if self.is_linked {
                        self.bridge.hear(&text, self.now);
                    }
                    self.sent.push((self.now, text));
                }
                Act::Plan(run) => {
                    let states = self.brain.as_ref().and_then(|brain| brain.plan(&run));
                    self.event(Event::Again(states));
                }
                Act::Tell(told) => self.told.push((self.now, told)),
            }
        }
    }

    /// Lets time go by.
    pub(crate) fn pass(&mut self, ms: f64) {
        self.until(ms, |_| false);
    }

    /// Lets time go by until something is so; whether it came to that.
    pub(crate) fn until(&mut self, ms: f64, is_so: impl Fn(&Rig) -> bool) -> bool {
        let end = self.now + ms;
        while self.now < end {
            if is_so(self) {
                return true;
            }
            self.now += 10.0;
            for text in self.bridge.pass(self.now) {
                if self.is_linked {
                    self.input(Input::Heard(text));
                }
            }
            if self.now % 20.0 == 0.0 {
                self.event(Event::Tick);
            }
        }
        is_so(self)
    }

    /// Milliseconds until the base stands.
    pub(crate) fn stood(&mut self) -> f64 {
        let from = self.now;
        assert!(self.until(5_000.0, |rig| rig.bridge.base.stands()), "it goes on");
        self.now - from
    }
}

pub(crate) fn world() -> State {
    text::read_legal(WORLD).unwrap()
}
