//! A rosbridge of the tests' own, over real sockets: a simulated robot behind it, topics handed from client to client, and
//! faults at will. It speaks the protocol by tungstenite, and knows frames as texts and JSON alone, so that what the crate
//! writes is judged by another reader.

use groundling::domain::{Direction, State};
use groundling::robot::geometry::{Pose, Twist};
use groundling::robot::message::{Command, Generation};
use groundling::robot::sim::{Body, Bridge, Noise};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::ErrorKind;
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tungstenite::{Error, Message, WebSocket};

/// How long a client's thread waits for a message.
const PATIENCE: Duration = Duration::from_millis(4);

/// A peer that listens; it ends with the process.
#[derive(Clone)]
pub(crate) struct Peer {
    hub: Arc<Mutex<Hub>>,
    address: String,
}

struct Hub {
    bridge: Bridge,
    begun: Instant,
    clients: HashMap<u32, Client>,
    last: u32,
    /// Types that clients gave to topics.
    types: HashMap<String, String>,
    /// Who asked what, by the question's id.
    asked: HashMap<String, u32>,
    /// All that came in: who sent it, and the frame, or the text where it is no JSON.
    log: Vec<(u32, Value)>,
    /// Whether nothing goes through, though all sockets are open.
    is_cut: bool,
    /// Whether whoever comes is sent away.
    is_shut: bool,
    /// Milliseconds that everything takes on its way out.
    delay: f64,
}

#[derive(Default)]
struct Client {
    heard: Vec<String>,
    out: Vec<(f64, String)>,
    is_closing: bool,
}

impl Peer {
    /// Listens on a port of this machine, 0 for any, with a robot in a world.
    pub(crate) fn start(world: &State, port: u16) -> std::io::Result<Peer> {
        let listener = TcpListener::bind(("127.0.0.1", port))?;
        let address = format!("ws://{}", listener.local_addr()?);
        let noise = Noise { latency: 10.0, loss: 0.0, ..Noise::default() };
        let hub = Hub {
            bridge: Bridge::new(world, Body::default(), noise, 1, 0.0),
            begun: Instant::now(),
            clients: HashMap::new(),
            last: 0,
            types: HashMap::new(),
            asked: HashMap::new(),
            log: Vec::new(),
            is_cut: false,
            is_shut: false,
            delay: 0.0,
        };
        let hub = Arc::new(Mutex::new(hub));
        let peer = Peer { hub: hub.clone(), address };
        let clients = peer.clone();
        std::thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let peer = clients.clone();
                std::thread::spawn(move || peer.serve(stream));
            }
        });
        std::thread::spawn(move || {
            loop {
                lock(&hub).pass();
                std::thread::sleep(Duration::from_millis(5));
            }
        });
        Ok(peer)
    }

    /// Where it listens.
    pub(crate) fn address(&self) -> &str {
        &self.address
    }

    /// All that came in since the entry of this place.
    pub(crate) fn log(&self, from: usize) -> Vec<(u32, Value)> {
        lock(&self.hub).log.get(from..).unwrap_or_default().to_vec()
    }

    /// Does as a line says; what there is to report.
    pub(crate) fn command(&self, line: &str) -> Option<Value> {
        lock(&self.hub).command(line)
    }

    fn serve(&self, stream: TcpStream) {
        if lock(&self.hub).is_shut || stream.set_read_timeout(None).is_err() {
            return;
        }
        let Ok(mut socket) = tungstenite::accept(stream) else { return };
        if socket.get_ref().set_read_timeout(Some(PATIENCE)).is_err() {
            return;
        }
        let id = {
            let mut hub = lock(&self.hub);
            hub.last += 1;
            let id = hub.last;
            hub.clients.insert(id, Client::default());
            id
        };
        while self.turn(id, &mut socket) {}
        lock(&self.hub).left(id);
    }

    /// What a client sent and what it is sent, once; whether it is still there.
    fn turn(&self, id: u32, socket: &mut WebSocket<TcpStream>) -> bool {
        if lock(&self.hub).is_cut {
            // What is sent meanwhile waits in the machines between, as behind a cable that is pulled.
            std::thread::sleep(PATIENCE);
            return true;
        }
        match socket.read() {
            Ok(Message::Text(text)) => lock(&self.hub).hear(id, text.as_str()),
            Ok(Message::Close(_)) => return false,
            Ok(_) => {}
            Err(Error::Io(error))
                if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {}
            Err(_) => return false,
        }
        let (texts, is_closing) = lock(&self.hub).taken(id);
        for text in texts {
            // Who has gone takes nothing, but may have said something before that: reading tells when there is no more.
            let _ = socket.send(Message::text(text));
        }
        if is_closing {
            // It is going anyway.
            let _ = socket.close(None);
            let _ = socket.flush();
        }
        !is_closing
    }
}

fn lock(hub: &Mutex<Hub>) -> MutexGuard<'_, Hub> {
    hub.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Hub {
    fn now(&self) -> f64 {
        self.begun.elapsed().as_secs_f64() * 1000.0
    }

    fn left(&mut self, id: u32) {
        self.clients.remove(&id);
        if self.clients.is_empty() {
            self.bridge.unlinked();
        }
    }

    /// The robot goes on, and says what it says to whoever wants to hear it.
    fn pass(&mut self) {
        let now = self.now();
        for text in self.bridge.pass(now) {
            let Ok(frame) = serde_json::from_str::<Value>(&text) else { continue };
            match frame["op"].as_str() {
                Some("publish") => {
                    self.hand_on(0, frame["topic"].as_str().unwrap_or_default(), &text)
                }
                _ => {
                    let asker = frame["id"].as_str().and_then(|id| self.asked.remove(id));
                    self.send(asker.unwrap_or(0), text);
                }
            }
        }
    }

    fn send(&mut self, to: u32, text: String) {
        let at = self.now() + self.delay;
        if let Some(client) = self.clients.get_mut(&to) {
            client.out.push((at, text));
        }
    }

    /// A message of a topic, to all who want it but its sender.
    fn hand_on(&mut self, from: u32, topic: &str, text: &str) {
        let wants = |(id, client): (&u32, &Client)| {
            (*id != from && client.heard.iter().any(|heard| heard == topic)).then_some(*id)
        };
        let to: Vec<u32> = self.clients.iter().filter_map(wants).collect();
        for id in to {
            self.send(id, text.to_owned());
        }
    }

    /// What is due for a client, and whether it is to be closed.
    fn taken(&mut self, id: u32) -> (Vec<String>, bool) {
        let now = self.now();
        let Some(client) = self.clients.get_mut(&id) else { return (Vec::new(), true) };
        let due = client.out.iter().take_while(|(at, _)| *at <= now).count();
        (client.out.drain(..due).map(|(_, text)| text).collect(), client.is_closing)
    }

    fn hear(&mut self, from: u32, text: &str) {
        let now = self.now();
        let frame = serde_json::from_str(text).unwrap_or_else(|_| json!(text));
        self.log.push((from, frame.clone()));
        let word = |name: &str| frame[name].as_str().unwrap_or_default().to_owned();
        let topic = word("topic");
        match &*word("op") {
            "subscribe" => {
                self.clients.entry(from).or_default().heard.push(topic);
                self.bridge.hear(text, now);
            }
            "unsubscribe" => {
                self.clients.entry(from).or_default().heard.retain(|heard| *heard != topic);
                if !self.clients.values().any(|client| client.heard.contains(&topic)) {
                    self.bridge.hear(text, now);
                }
            }
            "advertise" => {
                self.types.insert(topic, word("type"));
                self.bridge.hear(text, now);
            }
            "publish" => {
                let handed = json!({ "op": "publish", "topic": topic, "msg": frame["msg"] });
                self.hand_on(from, &topic, &handed.to_string());
                self.bridge.hear(text, now);
            }
            "call_service" => {
                let asked = frame["args"]["topic"].as_str().unwrap_or_default();
                let own = [&self.bridge.plugs.velocity, &self.bridge.plugs.pose];
                match self.types.get(asked).filter(|_| !own.contains(&&asked.to_owned())) {
                    Some(kind) => {
                        let answer = json!({ "op": "service_response", "id": frame["id"],
                            "service": frame["service"], "values": { "type": kind }, "result": true });
                        self.send(from, answer.to_string());
                    }
                    None => {
                        self.asked.insert(word("id"), from);
                        self.bridge.hear(text, now);
                    }
                }
            }
            _ => self.bridge.hear(text, now),
        }
    }

    fn command(&mut self, line: &str) -> Option<Value> {
        let (word, rest) = line.trim().split_once(' ').unwrap_or((line.trim(), ""));
        let number = |at: usize| {
            rest.split(' ').nth(at).and_then(|word| word.parse::<f64>().ok()).unwrap_or(0.0)
        };
        match word {
            "mute" => self.bridge.tells = false,
            "unmute" => self.bridge.tells = true,
            "cut" => self.is_cut = true,
            "mend" => self.is_cut = false,
            "shut" => self.is_shut = true,
            "open" => self.is_shut = false,
            "close" => self.clients.values_mut().for_each(|client| client.is_closing = true),
            "delay" => self.delay = number(0),
            "timeout" => self.bridge.base.body.timeout = number(0),
            "say" => {
                let all: Vec<u32> = self.clients.keys().copied().collect();
                all.into_iter().for_each(|id| self.send(id, rest.to_owned()));
            }
            "flood" => {
                let all: Vec<u32> = self.clients.keys().copied().collect();
                for at in 0..number(0) as u32 {
                    let text = json!({ "op": "publish", "topic": "/scan", "msg": { "at": at } })
                        .to_string();
                    all.iter().for_each(|id| self.send(*id, text.clone()));
                }
            }
            "carry" => {
                let side = rest.split(' ').nth(2).and_then(|name| name.parse::<Direction>().ok());
                self.bridge.base.carry(
                    number(0) as i32,
                    number(1) as i32,
                    side.unwrap_or(Direction::East),
                );
            }
            "origin" => {
                self.bridge.plugs.origin = Pose { x: number(0), y: number(1), heading: number(2) };
            }
            "ros1" => {
                (self.bridge.plugs.generation, self.bridge.plugs.command) =
                    (Generation::One, Command::Twist);
            }
            "report" => {
                let Twist { linear, angular } = self.bridge.base.twist;
                let Pose { x, y, heading } = self.bridge.base.pose;
                let state = self.bridge.base.state();
                let agent = json!([state.agent.x, state.agent.y]);
                return Some(
                    json!({ "linear": linear, "angular": angular, "x": x, "y": y, "heading": heading,
                    "agent": agent, "touches": self.bridge.base.touches, "stands": self.bridge.base.stands() }),
                );
            }
            _ => {}
        }
        None
    }
}
