//! What is said to a rosbridge, frame by frame: the types are asked of `rosapi`, poses subscribed to, and velocities
//! advertised and published once that is allowed. It knows no socket: it is told what opens, closes and comes in, and
//! gives the frames to send.
//!
//! Invariants: while the link is closed nothing is kept to be sent, since a velocity of a minute ago is none of now. What is
//! open after an outage is asked for anew: listening and publishing each for itself, and nothing that was given up. No
//! number that is none leaves.

use super::frame::{Frame, Misread};
use super::geometry::{Pose, Twist};
use super::message::{Command, Flaw, Generation, Sighting};
use super::wiring::{Types, Wiring};
use serde_json::{Value, json};

/// The service that says which type a topic has.
const ASK: &str = "/rosapi/topic_type";
/// Characters of a complaint that are kept.
const MOST_WORDS: usize = 300;

/// A conversation with a rosbridge.
#[derive(Clone, Debug, PartialEq)]
pub struct Session {
    wiring: Wiring,
    is_open: bool,
    /// Whether velocities may be published.
    is_armed: bool,
    last_id: u32,
    topics: Vec<Topic>,
    /// The id by which velocities are advertised, while they are.
    advertised: Option<String>,
}

/// A topic, and how far it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Topic {
    /// Its name.
    pub name: String,
    /// What it is for.
    pub role: Role,
    /// What is known of its type.
    pub kind: Kind,
    /// The id of the question at work, or of the subscription.
    id: Option<String>,
}

/// What a topic is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The base takes its velocity there.
    Velocity,
    /// The robot's pose is said there.
    Robot,
    /// The pose of the tracked thing of this number is.
    Body(usize),
}

/// What is known of a topic's type.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// Nobody was asked.
    Unasked,
    /// The bridge was.
    Asked,
    /// It takes velocities so.
    Command(Command, Generation),
    /// It says poses so.
    Sighting(Sighting, Generation),
    /// There is no such topic on the robot.
    Absent,
    /// It has another type, which does not serve.
    Other(String),
    /// The bridge could not say, and why.
    Failed(String),
}

/// News of a session.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// The robot is here.
    Robot(Pose),
    /// The tracked thing of this number is here.
    Body(usize, Pose),
    /// Something is known of a topic's type.
    Known,
    /// What came in is not as it should be.
    Bad(Bad),
}

/// What can be wrong with what comes in.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Bad {
    /// It is no frame.
    #[error(transparent)]
    Frame(#[from] Misread),
    /// A message of a topic has a flaw.
    #[error("{0}: {1}")]
    Message(String, Flaw),
    /// A service failed, in the bridge's words.
    #[error("{0} failed: {1}")]
    Service(String, String),
    /// The bridge complains.
    #[error("the bridge says: {0}")]
    Status(String),
}

impl Session {
    /// A conversation that has not begun.
    pub fn new(wiring: Wiring) -> Session {
        Session {
            topics: topics(&wiring),
            wiring,
            is_open: false,
            is_armed: false,
            last_id: 0,
            advertised: None,
        }
    }

    /// Whether there is a link.
    pub const fn is_open(&self) -> bool {
        self.is_open
    }

    /// The topics, that of the velocity first.
    pub fn topics(&self) -> &[Topic] {
        &self.topics
    }

    /// How the base takes its velocity, once that is known.
    pub fn command(&self) -> Option<(Command, Generation)> {
        self.topics.iter().find_map(|topic| match topic.kind {
            Kind::Command(command, generation) => Some((command, generation)),
            _ => None,
        })
    }

    /// The link is there, for the first time or again: the frames that ask for all that is wanted.
    pub fn opened(&mut self) -> Vec<String> {
        self.is_open = true;
        self.advertised = None;
        self.topics = topics(&self.wiring);
        let mut frames = Vec::new();
        for at in 0..self.topics.len() {
            match self.wiring.types {
                Some(types) => self.know(at, given(types, self.topics[at].role), &mut frames),
                None => frames.push(self.ask(at)),
            }
        }
        frames
    }

    /// The link is gone.
    pub fn closed(&mut self) {
        self.is_open = false;
        self.advertised = None;
    }

    /// Velocities may be published from now on, or no more. What is given up is not asked for again.
    pub fn arm(&mut self, is_armed: bool) -> Vec<String> {
        self.is_armed = is_armed;
        if !is_armed {
            let (id, topic) = (self.advertised.take(), self.wiring.velocity.clone());
            return id
                .map(|id| Frame::Unadvertise { id: Some(id), topic }.write())
                .into_iter()
                .collect();
        }
        self.advertise().into_iter().collect()
    }

    /// The frame that publishes a velocity; nothing while that may not be, or where it is no number.
    pub fn publish(&mut self, twist: Twist) -> Option<String> {
        let (command, generation) = self.command()?;
        self.advertised.as_ref().filter(|_| self.is_open)?;
        let msg = command.message(generation, twist)?;
        let topic = self.wiring.velocity.clone();
        let id = Some(self.next_id("publish", &topic));
        Some(Frame::Publish { id, topic, msg }.write())
    }

    /// A text came in: what it says, and what is to be sent for it.
    pub fn heard(&mut self, text: &str) -> (Vec<News>, Vec<String>) {
        let mut frames = Vec::new();
        let news = match Frame::read(text) {
            Ok(Frame::Publish { topic, msg, .. }) => self.message(&topic, &msg),
            Ok(Frame::ServiceResponse { id, values, result, .. }) => {
                self.answer(id.as_deref(), &values, result, &mut frames)
            }
            Ok(Frame::Status { level, msg }) if matches!(&*level, "error" | "warning") => {
                vec![News::Bad(Bad::Status(words(&msg)))]
            }
            Ok(_) => Vec::new(),
            Err(misread) => vec![News::Bad(misread.into())],
        };
        (news, frames)
    }

    fn message(&self, name: &str, message: &Value) -> Vec<News> {
        // Of a topic that two listen to, both are told.
        let listening = self.topics.iter().filter(|topic| topic.name == name);
        let news = listening.filter_map(|topic| {
            let Kind::Sighting(sighting, _) = topic.kind else { return None };
            Some(match (sighting.pose(message), topic.role) {
                (Ok(pose), Role::Body(number)) => News::Body(number, pose),
                (Ok(pose), _) => News::Robot(pose),
                (Err(flaw), _) => News::Bad(Bad::Message(name.to_owned(), flaw)),
            })
        });
        news.collect()
    }

    fn answer(
        &mut self,
        id: Option<&str>,
        values: &Value,
        result: bool,
        frames: &mut Vec<String>,
    ) -> Vec<News> {
        let asked = |topic: &Topic| topic.kind == Kind::Asked && topic.id.as_deref() == id;
        let Some(at) = self.topics.iter().position(asked) else { return Vec::new() };
        if !result {
            let why = words(values);
            self.topics[at].kind = Kind::Failed(why.clone());
            return vec![News::Bad(Bad::Service(ASK.to_owned(), why))];
        }
        let name = values.get("type").and_then(Value::as_str).unwrap_or_default();
        let known = match self.topics[at].role {
            _ if name.is_empty() => None,
            Role::Velocity => Command::of(name).map(|(command, of)| Kind::Command(command, of)),
            _ => Sighting::of(name).map(|(sighting, of)| Kind::Sighting(sighting, of)),
        };
        let other = || if name.is_empty() { Kind::Absent } else { Kind::Other(cut(name)) };
        self.know(at, known.unwrap_or_else(other), frames);
        vec![News::Known]
    }

    /// A topic's type is known: poses are subscribed to, velocities advertised if they may be.
    fn know(&mut self, at: usize, kind: Kind, frames: &mut Vec<String>) {
        let name = self.topics[at].name.clone();
        if let Kind::Sighting(sighting, generation) = kind {
            let id = self.next_id("subscribe", &name);
            self.topics[at].id = Some(id.clone());
            frames.push(
                Frame::Subscribe {
                    id: Some(id),
                    kind: Some(sighting.name(generation)),
                    topic: name,
                    compression: Some("none".to_owned()),
                    throttle_rate: 0,
                    // Where something was is of no use once it is known where it is.
                    queue_length: 1,
                }
                .write(),
            );
        }
        self.topics[at].kind = kind;
        if self.topics[at].role == Role::Velocity {
            frames.extend(self.advertise());
        }
    }

    fn ask(&mut self, at: usize) -> String {
        let topic = self.topics[at].name.clone();
        let id = self.next_id("call_service", ASK);
        self.topics[at].kind = Kind::Asked;
        self.topics[at].id = Some(id.clone());
        let args = json!({ "topic": topic });
        Frame::CallService { id: Some(id), service: ASK.to_owned(), args }.write()
    }

    fn advertise(&mut self) -> Option<String> {
        let (command, generation) = self.command()?;
        if !self.is_open || !self.is_armed || self.advertised.is_some() {
            return None;
        }
        let topic = self.wiring.velocity.clone();
        let id = self.next_id("advertise", &topic);
        self.advertised = Some(id.clone());
        let kind = command.name(generation);
        Some(Frame::Advertise { id: Some(id), kind, topic, latch: false, queue_size: 1 }.write())
    }

    fn next_id(&mut self, op: &str, name: &str) -> String {
        self.last_id = self.last_id.wrapping_add(1);
        format!("{op}:{name}:{}", self.last_id)
    }
}

/// The topics of a wiring, of which nothing is known.
fn topics(wiring: &Wiring) -> Vec<Topic> {
    let own = [(&wiring.velocity, Role::Velocity), (&wiring.pose, Role::Robot)];
    let bodies = wiring.bodies.iter().enumerate();
    let bodies = bodies.map(|(number, (_, topic))| (topic, Role::Body(number)));
    let topic = |(name, role): (&String, Role)| Topic {
        name: name.clone(),
        role,
        kind: Kind::Unasked,
        id: None,
    };
    own.into_iter().chain(bodies).map(topic).collect()
}

/// The type that a person gave a topic.
const fn given(types: Types, role: Role) -> Kind {
    match role {
        Role::Velocity => Kind::Command(types.command, types.generation),
        Role::Robot | Role::Body(_) => Kind::Sighting(types.sighting, types.generation),
    }
}

/// What a value says, for a person.
fn words(value: &Value) -> String {
    cut(&value.as_str().map_or_else(|| value.to_string(), str::to_owned))
}

fn cut(words: &str) -> String {
    words.chars().take(MOST_WORDS).collect()
}
