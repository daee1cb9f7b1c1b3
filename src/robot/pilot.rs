//! A driver and a session with a rosbridge as one: what comes over the link and what a person does goes in with the time, and
//! the frames to send come out. The same for a robot that is simulated and for a real one. And the dry run: what must be
//! seen to be in order before anything may move.

use super::calibration::Calibration;
use super::driver::{Driver, STALE, step};
use super::geometry::Twist;
use super::session::{Bad, Kind, News, Role, Session};
use super::stage::{Deed, Event, Stage, Told};
use super::wiring::Wiring;
use crate::domain::State;

/// Milliseconds from one pose to the next at which a robot can be driven by them.
const SELDOM: f64 = 250.0;

/// A robot, as far as it can be seen from here.
#[derive(Clone, Debug, PartialEq)]
pub struct Pilot {
    /// Who drives.
    pub driver: Driver,
    /// What is said to it.
    pub session: Session,
    /// What was wrong last with what came in.
    pub bad: Option<Bad>,
    /// The velocity that was sent last.
    pub last: Option<Twist>,
}

/// Something that comes in.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// The link is open.
    Opened,
    /// It is closed.
    Closed,
    /// A text came over it.
    Heard(String),
    /// Something else.
    Event(Event),
}

/// Something that is to be done.
#[derive(Clone, Debug, PartialEq)]
pub enum Act {
    /// Send this over the link, now or never.
    Send(String),
    /// Think again: the run of this command so far, of which the last is the world as it is.
    Plan(Vec<State>),
    /// A person is to be told.
    Tell(Told),
}

/// What is looked at in a dry run, in the order in which it is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Check {
    Linked,
    Velocity,
    Poses,
    Bodies,
    Calibrated,
    Placed,
    Stops,
}

impl Check {
    /// All of them.
    pub const ALL: [Check; 7] = [
        Check::Linked,
        Check::Velocity,
        Check::Poses,
        Check::Bodies,
        Check::Calibrated,
        Check::Placed,
        Check::Stops,
    ];
}

impl Pilot {
    /// A robot in a world, which nothing is known of.
    pub fn new(world: State, wiring: Wiring) -> Pilot {
        let place =
            |(name, _): &(String, String)| world.objects.iter().position(|o| o.name == *name);
        // A topic of a thing that is not there moves nothing.
        let tracked = wiring.bodies.iter().map(|body| place(body).unwrap_or(usize::MAX)).collect();
        let mut driver = Driver::new(world);
        driver.tracked = tracked;
        Pilot { driver, session: Session::new(wiring), bad: None, last: None }
    }

    /// The world that it is in is another, or metres are mapped otherwise.
    pub fn place_in(&mut self, world: State, calibration: Option<Calibration>) {
        (self.driver.world, self.driver.calibration) = (world, calibration);
    }

    /// Takes what comes in at a time, in milliseconds; what is to be done.
    pub fn take(&mut self, input: Input, now: f64) -> Vec<Act> {
        let mut acts = Vec::new();
        match input {
            Input::Opened => {
                acts.extend(self.session.opened().into_iter().map(Act::Send));
                self.drive(Event::Linked, now, &mut acts);
            }
            Input::Closed => {
                self.session.closed();
                self.drive(Event::Unlinked, now, &mut acts);
            }
            Input::Heard(text) => {
                let (news, frames) = self.session.heard(&text);
                acts.extend(frames.into_iter().map(Act::Send));
                for news in news {
                    match news {
                        News::Robot(pose) => self.drive(Event::Robot(pose), now, &mut acts),
                        News::Body(n, pose) => self.drive(Event::Body(n, pose), now, &mut acts),
                        News::Known => {}
                        News::Bad(bad) => {
                            self.bad = Some(bad.clone());
                            self.drive(Event::Bad(bad), now, &mut acts);
                        }
                    }
                }
            }
            // Nothing moves that was not looked at.
            Input::Event(Event::Arm) if !self.is_fit(now) => {}
            Input::Event(event) => self.drive(event, now, &mut acts),
        }
        acts
    }

    fn drive(&mut self, event: Event, now: f64, acts: &mut Vec<Act>) {
        for deed in step(&mut self.driver, event, now) {
            match deed {
                Deed::Arm(is_armed) => {
                    acts.extend(self.session.arm(is_armed).into_iter().map(Act::Send))
                }
                Deed::Publish(twist) => {
                    self.last = Some(twist);
                    acts.extend(self.session.publish(twist).map(Act::Send));
                }
                Deed::Plan(state) => {
                    let mut run = self.driver.run();
                    run.push(*state);
                    acts.push(Act::Plan(run));
                }
                Deed::Tell(told) => acts.push(Act::Tell(told)),
            }
        }
    }

    /// Whether something is as it should be; nothing while that is not known.
    pub fn check(&self, check: Check, now: f64) -> Option<bool> {
        let driver = &self.driver;
        match check {
            Check::Linked => Some(self.session.is_open()),
            Check::Velocity => self.kinds(|role| role == Role::Velocity),
            Check::Poses => match driver.seen(now) {
                Some((age, period)) if period > 0.0 => Some(age < STALE && period < SELDOM),
                _ => self.kinds(|role| role == Role::Robot).filter(|is_known| !is_known),
            },
            Check::Bodies => self.kinds(|role| matches!(role, Role::Body(_))),
            Check::Calibrated => Some(driver.calibration.is_some()),
            Check::Placed => driver.look().map(|seen| seen.is_ok()),
            Check::Stops => match driver.stage {
                Stage::Trying(_) => None,
                _ => driver.stops.map(|_| true),
            },
        }
    }

    /// Whether everything is as it should be.
    pub fn is_fit(&self, now: f64) -> bool {
        Check::ALL.into_iter().all(|check| self.check(check, now) == Some(true))
    }

    /// Whether the base can be turned, to see whether it stops by itself: all is well but for that.
    pub fn can_try(&self, now: f64) -> bool {
        let is_off = self.driver.stage == Stage::Off;
        let before = Check::ALL.into_iter().filter(|&check| check != Check::Stops);
        is_off && before.into_iter().all(|check| self.check(check, now) == Some(true))
    }

    /// Whether all topics of such a role have a type that serves.
    fn kinds(&self, is_such: impl Fn(Role) -> bool) -> Option<bool> {
        let topics = self.session.topics().iter().filter(|topic| is_such(topic.role));
        let serves = |kind: &Kind| match kind {
            Kind::Unasked | Kind::Asked => None,
            Kind::Command(..) | Kind::Sighting(..) => Some(true),
            Kind::Absent | Kind::Other(_) | Kind::Failed(_) => Some(false),
        };
        topics.map(|topic| serves(&topic.kind)).try_fold(true, |all, one| Some(all && one?))
    }
}
