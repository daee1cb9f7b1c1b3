//! The driver: what becomes of its state for an event at a time, and what is to be done. Pure: the time is passed in, in
//! milliseconds. Off by default; it sends velocities only while the dead man's key is held, and stops, three times over,
//! whenever anything is not as it should be. A stop stays until a person releases it.

use super::calibration::Calibration;
use super::controller::{Target, towards};
use super::estimate::Estimate;
use super::geometry::{Pose, Twist};
use super::route::Route;
use super::sight::{Unseen, look};
use super::stage::{Deed, Event, Halt, Stage, Told};
use super::trial::{Trial, Untried, Verdict};
use super::wiring::Limits;
use crate::domain::State;
use std::collections::VecDeque;

/// Milliseconds between two velocities.
pub const PERIOD: f64 = 100.0;
/// Milliseconds without a pose after which it stops.
pub const STALE: f64 = 500.0;
/// How often it says that it stops.
pub const STOPS: usize = 3;
/// Milliseconds after which a tick is late: a page that stood still.
const LATE: f64 = 500.0;
/// Metres and radians that a pose may be off what was expected.
const LEAP: (f64, f64) = (0.6, 1.3);
/// Milliseconds that a step may take.
const STEP: f64 = 30_000.0;
/// Bytes that may wait to leave: some dozen velocities.
const BACKLOG: u32 = 4_000;
/// Milliseconds that it stands and looks before it takes the world to be elsewhere.
const LOOKING: f64 = 700.0;
/// What one sight of a tracked thing corrects, and metres beyond which it is somewhere else.
const SIGHT: (f64, f64) = (0.3, 0.3);
/// A robot that has thought again so often for one command is lost.
const MOST_AGAIN: u32 = 20;

/// The driver of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    /// How far it is.
    pub stage: Stage,
    /// How metres are mapped to cells.
    pub calibration: Option<Calibration>,
    /// How fast it may go.
    pub limits: Limits,
    /// The world as it is believed to be.
    pub world: State,
    /// The object that each tracked thing is, by its place in the world.
    pub tracked: Vec<usize>,
    /// How long the base goes on by itself, once that was seen.
    pub stops: Option<u32>,
    estimate: Estimate,
    is_linked: bool,
    is_held: bool,
    /// When the last pose came, and how long it is from one to the next.
    seen: Option<(f64, f64)>,
    bodies: Vec<Option<Pose>>,
    route: Option<Route>,
    targets: VecDeque<Target>,
    /// The run of this command before the route began.
    before: Vec<State>,
    is_thinking: bool,
    /// Since when it stands and looks.
    looking: Option<f64>,
    again: u32,
    began: f64,
    sent: f64,
    ticked: f64,
}

impl Driver {
    /// A driver that is off, in a world.
    pub fn new(world: State) -> Driver {
        Driver {
            stage: Stage::Off,
            calibration: None,
            limits: Limits::default(),
            world,
            tracked: Vec::new(),
            stops: None,
            estimate: Estimate::default(),
            is_linked: false,
            is_held: false,
            seen: None,
            bodies: Vec::new(),
            route: None,
            targets: VecDeque::new(),
            before: Vec::new(),
            is_thinking: false,
            looking: None,
            again: 0,
            began: 0.0,
            sent: f64::NEG_INFINITY,
            ticked: 0.0,
        }
    }

    /// Where the robot is by now, in metres.
    pub fn pose(&self) -> Option<Pose> {
        self.estimate.pose()
    }

    /// Where it is by now, in cells.
    pub fn place(&self) -> Option<Pose> {
        Some(self.calibration?.to_cells(self.pose()?))
    }

    /// Milliseconds since the last pose came, and from one to the next.
    pub fn seen(&self, now: f64) -> Option<(f64, f64)> {
        self.seen.map(|(at, period)| (now - at, period))
    }

    /// The route, if there is one.
    pub const fn route(&self) -> Option<&Route> {
        self.route.as_ref()
    }

    /// The states that this command led through so far.
    pub fn run(&self) -> Vec<State> {
        let own = self.route.as_ref().map_or(&[][..], Route::run);
        self.before.iter().chain(own).cloned().collect()
    }

    /// Whether it waits for another plan.
    pub const fn is_thinking(&self) -> bool {
        self.is_thinking
    }

    /// The world as it is seen.
    ///
    /// # Errors
    /// Why that is no state; nothing where the robot is not seen at all.
    pub fn look(&self) -> Option<Result<State, Unseen>> {
        self.look_for(&self.world)
    }

    fn look_for(&self, believed: &State) -> Option<Result<State, Unseen>> {
        let calibration = self.calibration?;
        let seen = self.bodies.iter().zip(&self.tracked);
        let bodies =
            seen.filter_map(|(pose, &index)| Some((index, calibration.to_cells((*pose)?))));
        Some(look(believed, self.place()?, &bodies.collect::<Vec<_>>()))
    }
}

/// Changes the driver as the event says; what is to be done.
pub fn step(driver: &mut Driver, event: Event, now: f64) -> Vec<Deed> {
    let mut deeds = Vec::new();
    driver.hear(event, now, &mut deeds);
    deeds
}

impl Driver {
    fn hear(&mut self, event: Event, now: f64, deeds: &mut Vec<Deed>) {
        match event {
            Event::Tick => self.tick(now, deeds),
            Event::Linked => (self.is_linked, self.ticked) = (true, now),
            Event::Unlinked => {
                self.is_linked = false;
                self.forget();
                self.halt(Halt::Unlinked, deeds);
            }
            Event::Robot(pose) => self.saw(pose, now, deeds),
            Event::Body(number, pose) => self.saw_body(number, pose),
            Event::Bad(bad) => self.halt(Halt::Bad(bad), deeds),
            Event::Backlog(bytes) if bytes > BACKLOG => self.halt(Halt::Backlog, deeds),
            Event::Backlog(_) => {}
            Event::Held(is_held) => self.hold(is_held, now, deeds),
            Event::Emergency => {
                // Even a robot that was never driven from here is told to stop.
                deeds.push(Deed::Arm(true));
                self.stop(deeds);
                self.halted(Halt::Emergency, deeds);
            }
            Event::Release => self.release(deeds),
            Event::Hidden => self.halt(Halt::Hidden, deeds),
            Event::Closing | Event::Disarm => {
                if self.is_active() {
                    self.stop(deeds);
                }
                deeds.push(Deed::Arm(false));
                (self.stage, self.is_held) = (Stage::Off, false);
            }
            Event::Try if self.stage == Stage::Off && self.is_linked => {
                self.stops = None;
                self.stage = Stage::Trying(Trial::default());
                deeds.push(Deed::Arm(true));
            }
            Event::Arm if self.stage == Stage::Off && self.is_linked => {
                self.stage = Stage::Ready;
                deeds.push(Deed::Arm(true));
            }
            Event::Try | Event::Arm => {}
            Event::Route(states) => {
                self.pause(deeds);
                (self.again, self.is_thinking) = (0, false);
                self.before.clear();
                self.follow(states);
            }
            Event::Again(states) if self.is_thinking => {
                self.is_thinking = false;
                match states {
                    Some(states) => self.follow(states),
                    None => self.halt(Halt::NoWay, deeds),
                }
                match &self.route {
                    // What surprised it was that all is done.
                    Some(route) if route.next().is_none() => self.arrive(deeds),
                    _ => self.aim(now),
                }
            }
            Event::Again(_) => {}
        }
    }

    fn is_active(&self) -> bool {
        matches!(self.stage, Stage::Trying(_) | Stage::Ready | Stage::Driving)
    }

    /// Says that it stops, three times over.
    fn stop(&mut self, deeds: &mut Vec<Deed>) {
        deeds.extend([const { Deed::Publish(Twist::STOP) }; STOPS]);
        self.estimate.halt();
    }

    /// Stops for a reason, unless nothing was being sent.
    fn halt(&mut self, why: Halt, deeds: &mut Vec<Deed>) {
        if self.is_active() {
            self.stop(deeds);
            self.halted(why, deeds);
        }
    }

    fn halted(&mut self, why: Halt, deeds: &mut Vec<Deed>) {
        (self.stage, self.is_held, self.is_thinking) = (Stage::Halted(why.clone()), false, false);
        deeds.push(Deed::Tell(Told::Halted(why)));
    }

    /// Stops while it drives, and waits for the key again.
    fn pause(&mut self, deeds: &mut Vec<Deed>) {
        if self.stage == Stage::Driving {
            self.stop(deeds);
            self.stage = Stage::Ready;
            deeds.push(Deed::Tell(Told::Waits));
        }
    }

    /// What is known of the robot holds no more.
    fn forget(&mut self) {
        self.estimate.forget();
        (self.seen, self.stops) = (None, None);
        self.bodies.clear();
    }

    fn release(&mut self, deeds: &mut Vec<Deed>) {
        if let Stage::Halted(_) = self.stage {
            // Who stopped is to look first: it is armed anew.
            self.stage = Stage::Off;
            deeds.push(Deed::Arm(false));
        }
    }

    fn hold(&mut self, is_held: bool, now: f64, deeds: &mut Vec<Deed>) {
        self.is_held = is_held;
        match &mut self.stage {
            Stage::Trying(trial) if is_held && trial.is_waiting() => trial.begin(now),
            Stage::Trying(trial) if !is_held && !trial.is_waiting() => {
                self.stop(deeds);
                self.ended(Verdict::Untried(Untried::LetGo), deeds);
            }
            Stage::Ready if is_held => self.start(now, deeds),
            Stage::Driving if !is_held => self.pause(deeds),
            _ => {}
        }
    }

    /// The key is held: on from where the robot is.
    fn start(&mut self, now: f64, deeds: &mut Vec<Deed>) {
        let Some(route) = &mut self.route else { return };
        if route.next().is_none() {
            return;
        }
        self.stage = Stage::Driving;
        (self.ticked, self.sent) = (now, f64::NEG_INFINITY);
        deeds.push(Deed::Tell(Told::Drives));
        self.resume(now, deeds);
    }

    /// Goes on along the route from what is seen, which may be between two of its states.
    fn resume(&mut self, now: f64, deeds: &mut Vec<Deed>) {
        let Some(route) = &self.route else { return };
        let known = [route.here().cloned(), route.next().cloned()];
        let is_seen = |state: &State| self.look_for(state) == Some(Ok(state.clone()));
        match known.iter().position(|state| state.as_ref().is_some_and(is_seen)) {
            Some(0) => self.aim(now),
            Some(_) => self.advance(now, deeds),
            None => {
                let seen = known.iter().flatten().filter_map(|state| self.look_for(state));
                let seen = seen.reduce(|first, second| if first.is_ok() { first } else { second });
                self.rethink(seen, deeds);
            }
        }
    }

    /// Follows these states from now on.
    fn follow(&mut self, states: Vec<State>) {
        if let Some(first) = states.first() {
            self.world = first.clone();
        }
        self.targets.clear();
        self.route = Some(Route::new(states));
    }

    /// Aims at what the next step asks.
    fn aim(&mut self, now: f64) {
        let both = self.route.as_ref().zip(self.calibration.as_ref());
        let targets = both.map(|(route, calibration)| route.targets(calibration, self.limits));
        (self.targets, self.began) = (targets.unwrap_or_default().into(), now);
        self.looking = None;
    }

    /// A state of the route was reached: on to the next.
    fn advance(&mut self, now: f64, deeds: &mut Vec<Deed>) {
        let Some(route) = &mut self.route else { return };
        route.advance();
        if let Some(here) = route.here() {
            self.world = here.clone();
        }
        if route.next().is_some() {
            self.aim(now);
        } else {
            self.arrive(deeds);
        }
    }

    /// What was asked is done: stops, and waits for another command.
    fn arrive(&mut self, deeds: &mut Vec<Deed>) {
        self.targets.clear();
        if self.stage == Stage::Driving {
            self.stop(deeds);
            self.stage = Stage::Ready;
            deeds.push(Deed::Tell(Told::Arrived));
        }
    }

    /// The world is not where it was expected: stops, and thinks again from there.
    fn rethink(&mut self, seen: Option<Result<State, Unseen>>, deeds: &mut Vec<Deed>) {
        let state = match seen {
            Some(Ok(state)) => state,
            Some(Err(unseen)) => return self.halt(Halt::Unseen(unseen), deeds),
            None => return self.halt(Halt::NoPose, deeds),
        };
        self.again += 1;
        if self.again > MOST_AGAIN {
            return self.halt(Halt::TooOften, deeds);
        }
        self.stop(deeds);
        self.before = self.run();
        self.route = None;
        self.targets.clear();
        self.is_thinking = true;
        self.world = state.clone();
        deeds.extend([Deed::Tell(Told::Rethinks), Deed::Plan(Box::new(state))]);
    }

    fn saw(&mut self, pose: Pose, now: f64, deeds: &mut Vec<Deed>) {
        let period = match self.seen {
            Some((before, 0.0)) => now - before,
            Some((before, period)) => 0.8 * period + 0.2 * (now - before),
            None => 0.0,
        };
        self.seen = Some((now, period));
        let (off, turned) = self.estimate.saw(pose, now);
        if off > LEAP.0 || turned > LEAP.1 {
            self.estimate.forget();
            self.estimate.saw(pose, now);
            self.halt(Halt::Leapt, deeds);
        }
        if let Stage::Trying(trial) = &mut self.stage {
            trial.saw(pose, now);
        }
    }

    fn saw_body(&mut self, number: usize, pose: Pose) {
        if self.bodies.len() <= number {
            self.bodies.resize(number + 1, None);
        }
        let place = &mut self.bodies[number];
        let near = place.filter(|before| before.distance(pose.x, pose.y) < SIGHT.1);
        *place = Some(near.map_or(pose, |before| Pose {
            x: before.x + SIGHT.0 * (pose.x - before.x),
            y: before.y + SIGHT.0 * (pose.y - before.y),
            heading: pose.heading,
        }));
    }

    fn tick(&mut self, now: f64, deeds: &mut Vec<Deed>) {
        let late = now - std::mem::replace(&mut self.ticked, now) > LATE;
        self.estimate.pass(now);
        if !self.is_active() {
            return;
        }
        if self.seen.is_none_or(|(at, _)| now - at >= STALE) {
            return self.halt(Halt::NoPose, deeds);
        }
        if late && self.stage != Stage::Ready {
            return self.halt(Halt::Slept, deeds);
        }
        match &mut self.stage {
            Stage::Trying(trial) => {
                if let Some(verdict) = trial.verdict(now) {
                    self.stop(deeds);
                    self.ended(verdict, deeds);
                } else if now - self.sent >= PERIOD
                    && let Some(twist) = trial.twist(now)
                {
                    self.publish(twist, now, deeds);
                }
            }
            Stage::Driving if !self.is_thinking => self.drive(now, deeds),
            _ => {}
        }
    }

    /// The trial is over.
    fn ended(&mut self, verdict: Verdict, deeds: &mut Vec<Deed>) {
        (self.stage, self.is_held) = (Stage::Off, false);
        deeds.push(Deed::Arm(false));
        deeds.push(Deed::Tell(match verdict {
            Verdict::Stops(ms) => {
                self.stops = Some(ms);
                Told::Stops(ms)
            }
            Verdict::Untried(why) => Told::Untried(why),
        }));
    }

    fn drive(&mut self, now: f64, deeds: &mut Vec<Deed>) {
        if now - self.sent < PERIOD {
            return;
        }
        if now - self.began > STEP {
            return self.halt(Halt::Stuck, deeds);
        }
        let Some(pose) = self.pose() else { return self.halt(Halt::NoPose, deeds) };
        while let Some(&target) = self.targets.front() {
            if let Some(twist) = towards(pose, target, self.limits) {
                return self.publish(twist, now, deeds);
            }
            self.targets.pop_front();
        }
        let next = self.route.as_ref().and_then(Route::next).cloned();
        let Some(next) = next else { return self.pause(deeds) };
        match self.look_for(&next) {
            Some(Ok(seen)) if seen == next => self.advance(now, deeds),
            seen => match self.looking {
                None => {
                    self.looking = Some(now);
                    self.stop(deeds);
                }
                Some(since) if now - since < LOOKING => {}
                Some(_) => self.rethink(seen, deeds),
            },
        }
    }

    fn publish(&mut self, twist: Twist, now: f64, deeds: &mut Vec<Deed>) {
        let twist = self.limits.capped().cap(twist);
        self.sent = now;
        self.estimate.sent(twist, now);
        deeds.push(Deed::Publish(twist));
    }
}
