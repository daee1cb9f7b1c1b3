//! A pilot over real sockets, against the peer: what is bad, much, late or gone, and what comes back after it.

use super::world;
use crate::peer::Peer;
use groundling::robot::{Act, Calibration, Check, Event, Halt, Input, Pilot, Stage, Wiring};
use serde_json::Value;
use std::io::ErrorKind;
use std::net::TcpStream;
use std::time::{Duration, Instant};
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Error, Message, WebSocket, connect};

/// A pilot with a socket, by the clock.
struct Client {
    pilot: Pilot,
    peer: Peer,
    socket: Option<WebSocket<MaybeTlsStream<TcpStream>>>,
    begun: Instant,
}

impl Client {
    fn new() -> Client {
        let peer = Peer::start(&world(), 0).unwrap();
        let mut pilot = Pilot::new(world(), Wiring::default());
        pilot.driver.calibration = Some(Calibration::plain(0.5, (0, 0), [0.0, 0.0]));
        let mut client = Client { pilot, peer, socket: None, begun: Instant::now() };
        client.connect();
        client
    }

    fn connect(&mut self) {
        let (socket, _) = connect(self.peer.address()).unwrap();
        if let MaybeTlsStream::Plain(stream) = socket.get_ref() {
            stream.set_read_timeout(Some(Duration::from_millis(4))).unwrap();
        }
        self.socket = Some(socket);
        self.take(Input::Opened);
    }

    fn take(&mut self, input: Input) {
        let now = self.begun.elapsed().as_secs_f64() * 1000.0;
        for act in self.pilot.take(input, now) {
            if let (Act::Send(text), Some(socket)) = (act, &mut self.socket) {
                // A socket that is gone says so when it is read.
                let _ = socket.send(Message::text(text));
            }
        }
    }

    /// Goes on until something is so; fails after some seconds.
    #[track_caller]
    fn until(&mut self, is_so: impl Fn(&Client) -> bool) {
        let end = Instant::now() + Duration::from_secs(20);
        while !is_so(self) {
            assert!(Instant::now() < end, "{:?}", self.pilot);
            self.turn();
        }
    }

    fn turn(&mut self) {
        let Some(socket) = &mut self.socket else { return };
        match socket.read() {
            Ok(Message::Text(text)) => self.take(Input::Heard(text.to_string())),
            Ok(Message::Close(_)) => self.closed(),
            Ok(_) => {}
            Err(Error::Io(error))
                if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {}
            Err(_) => self.closed(),
        }
        self.take(Input::Event(Event::Tick));
    }

    fn closed(&mut self) {
        self.socket = None;
        self.take(Input::Closed);
    }

    fn now(&self) -> f64 {
        self.begun.elapsed().as_secs_f64() * 1000.0
    }

    /// Armed, after the base was seen to stop.
    fn armed() -> Client {
        let mut client = Client::new();
        client.until(|client| client.pilot.can_try(client.now()));
        client.take(Input::Event(Event::Try));
        client.take(Input::Event(Event::Held(true)));
        client.until(|client| client.pilot.driver.stops.is_some());
        client.take(Input::Event(Event::Arm));
        assert_eq!(client.pilot.driver.stage, Stage::Ready);
        client
    }

    /// What it sent since an entry of the peer's log: the frames' kinds.
    fn ops(&self, from: usize) -> Vec<String> {
        let op = |(_, frame): (u32, Value)| frame["op"].as_str().unwrap_or_default().to_owned();
        self.peer.log(from).into_iter().map(op).collect()
    }
}

#[test]
fn a_robot_is_looked_at_and_stopped_over_a_socket() {
    let mut client = Client::armed();
    assert!(client.peer.command("report").unwrap()["heading"].as_f64().is_some());
    // A flood changes nothing.
    client.peer.command("flood 5000");
    let from = client.now();
    client.until(|client| client.now() - from > 700.0);
    assert_eq!(client.pilot.driver.stage, Stage::Ready);
    // What is bad stops it, three times over.
    let before = client.peer.log(0).len();
    client.peer.command(r#"say {"op":"publish","topic":"/odom","msg":{"x":NaN}}"#);
    client.until(|client| matches!(client.pilot.driver.stage, Stage::Halted(Halt::Bad(_))));
    let from = client.now();
    client.until(|client| client.now() - from > 200.0);
    assert_eq!(client.ops(before), ["publish"; 3]);
}

#[test]
fn a_link_that_breaks_and_comes_back_brings_nothing_of_before() {
    let mut client = Client::armed();
    client.peer.command("close");
    client.until(|client| client.socket.is_none());
    assert_eq!(client.pilot.driver.stage, Stage::Halted(Halt::Unlinked));
    for event in [Event::Held(true), Event::Emergency, Event::Release] {
        client.take(Input::Event(event));
    }
    let before = client.peer.log(0).len();
    client.connect();
    client.until(|client| client.pilot.check(Check::Poses, client.now()) == Some(true));
    let mut ops = client.ops(before);
    ops.sort();
    assert_eq!(ops, ["call_service", "call_service", "subscribe"]);
    assert_eq!(
        client.pilot.check(Check::Stops, client.now()),
        None,
        "the base is to be seen to again"
    );
}

#[test]
fn poses_that_come_too_late_or_not_at_all_are_seen() {
    let mut client = Client::armed();
    client.peer.command("mute");
    client.until(|client| client.pilot.driver.stage == Stage::Halted(Halt::NoPose));
    client.peer.command("unmute");
    client.take(Input::Event(Event::Release));
    client.until(|client| client.pilot.check(Check::Poses, client.now()) == Some(true));
    client.peer.command("cut");
    client.until(|client| client.pilot.check(Check::Poses, client.now()) == Some(false));
    client.peer.command("mend");
    client.until(|client| client.pilot.check(Check::Poses, client.now()) == Some(true));
}

/// A page that is left goes with poses unread, and its socket is reset: what it said before that has arrived all the same.
#[test]
fn the_last_words_of_who_leaves_are_heard() {
    let mut client = Client::armed();
    client.peer.command("cut");
    let before = client.peer.log(0).len();
    client.take(Input::Event(Event::Closing));
    // Poses for who is gone are waiting when what it said is read.
    std::thread::sleep(Duration::from_millis(200));
    client.socket = None;
    client.peer.command("mend");
    // Its thread reads in its own time, on a machine that is busy with other tests.
    let end = Instant::now() + Duration::from_secs(20);
    while client.ops(before).last().is_none_or(|op| op != "unadvertise") && Instant::now() < end {
        std::thread::sleep(Duration::from_millis(5));
    }
    let last = ["advertise", "publish", "publish", "publish", "unadvertise"];
    let ops = client.ops(before);
    assert!(ops.ends_with(&last.map(str::to_owned)), "{ops:?}");
}
