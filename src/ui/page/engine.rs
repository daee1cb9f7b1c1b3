//! What the page knows of an engine: whether it lives, what it is doing, and what it is to do next. An engine is
//! started when something is asked of it and does one thing at a time, so requests wait here; a watch notices when it
//! no longer answers.

use crate::worker::protocol::{Envelope, Program, Request, VERSION};
use std::collections::VecDeque;

/// Milliseconds between two looks at a busy engine.
pub const WATCH_MS: u32 = 2_000;

/// So many looks without a word, and the engine counts as stopped.
const PATIENCE: u32 = 4;

/// What is to be done for an engine; who has engines has an effect for each.
#[derive(Clone, Debug, PartialEq)]
pub enum Errand {
    /// Start a new engine, ending the one there is.
    Spawn(Program),
    /// Send an engine a message.
    Post(Program, Envelope<Request>),
    /// Look after so many milliseconds whether an engine still answers; the number tells a stale look from the one
    /// that counts.
    Watch(Program, u32, u32),
}

/// Whether the engine lives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Health {
    /// Nothing was asked of it yet.
    Asleep,
    /// It is being loaded.
    Starting,
    /// It answers.
    Ready,
    /// It died, or no longer answers; the text says how.
    Stopped(String),
}

/// A request at work.
#[derive(Clone, Debug, PartialEq)]
pub struct Pending {
    /// Its id.
    pub id: u32,
    /// The request.
    pub request: Request,
}

/// The engine as the page sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct Engine {
    program: Program,
    /// Whether it lives.
    pub health: Health,
    /// What it is doing.
    pub pending: Option<Pending>,
    waiting: VecDeque<Request>,
    last_id: u32,
    silent: u32,
    watch: u32,
}

impl Engine {
    /// An engine that nothing was asked of yet.
    pub fn new(program: Program) -> Engine {
        Engine {
            program,
            health: Health::Asleep,
            pending: None,
            waiting: VecDeque::new(),
            last_id: 0,
            silent: 0,
            watch: 0,
        }
    }

    /// Which program it runs.
    pub const fn program(&self) -> Program {
        self.program
    }

    /// Has it loaded, if it is not yet.
    pub fn wake<E: From<Errand>>(&mut self, effects: &mut Vec<E>) {
        if self.health == Health::Asleep {
            self.health = Health::Starting;
            effects.push(Errand::Spawn(self.program).into());
        }
    }

    /// Whether it is at such a request, or will be as soon as it can.
    pub fn is_at(&self, such: impl Fn(&Request) -> bool) -> bool {
        let at_work = self.pending.as_ref().map(|pending| &pending.request);
        at_work.into_iter().chain(&self.waiting).any(such)
    }

    /// Sends a request as soon as the engine is free; an `urgent` one goes before all that wait.
    pub fn send<E: From<Errand>>(&mut self, request: Request, urgent: bool, effects: &mut Vec<E>) {
        self.wake(effects);
        if urgent {
            self.waiting.push_front(request);
        } else {
            self.waiting.push_back(request);
        }
        self.pump(effects);
    }

    /// Forgets requests that wait and that `keep` does not hold.
    pub fn retain(&mut self, keep: impl Fn(&Request) -> bool) {
        self.waiting.retain(keep);
    }

    /// Asks the engine to stop what it is doing.
    pub fn cancel<E: From<Errand>>(&mut self, effects: &mut Vec<E>) {
        if let Some(pending) = &self.pending {
            effects.push(self.post(pending.id, Request::Cancel));
        }
    }

    /// The engine is up.
    pub fn ready<E: From<Errand>>(&mut self, effects: &mut Vec<E>) {
        self.health = Health::Ready;
        self.pump(effects);
    }

    /// The request at work has been answered: gives it back, and sends the next one.
    pub fn finish<E: From<Errand>>(&mut self, id: u32, effects: &mut Vec<E>) -> Option<Request> {
        let done = self.pending.take_if(|p| p.id == id)?;
        self.pump(effects);
        Some(done.request)
    }

    /// The engine said something.
    pub fn heard(&mut self) {
        self.silent = 0;
    }

    /// The engine died. The first reason is the one kept; what it was doing is given back.
    pub fn stop(&mut self, why: String) -> Option<Request> {
        if !matches!(self.health, Health::Stopped(_)) {
            self.health = Health::Stopped(why);
        }
        self.waiting.clear();
        self.watch = self.watch.wrapping_add(1);
        self.pending.take().map(|p| p.request)
    }

    /// A look at a busy engine; whether it must be given up.
    pub fn look<E: From<Errand>>(&mut self, watch: u32, effects: &mut Vec<E>) -> bool {
        if watch != self.watch || self.pending.is_none() {
            return false;
        }
        self.silent += 1;
        if self.silent > PATIENCE {
            return true;
        }
        effects.push(self.post(0, Request::Ping));
        effects.push(Errand::Watch(self.program, self.watch, WATCH_MS).into());
        false
    }

    fn pump<E: From<Errand>>(&mut self, effects: &mut Vec<E>) {
        if self.health != Health::Ready || self.pending.is_some() {
            return;
        }
        let Some(request) = self.waiting.pop_front() else { return };
        self.last_id = self.last_id.wrapping_add(1).max(1);
        let id = self.last_id;
        self.silent = 0;
        self.watch = self.watch.wrapping_add(1);
        effects.push(self.post(id, request.clone()));
        effects.push(Errand::Watch(self.program, self.watch, WATCH_MS).into());
        self.pending = Some(Pending { id, request });
    }

    fn post<E: From<Errand>>(&self, id: u32, body: Request) -> E {
        Errand::Post(self.program, Envelope { groundling: VERSION, id, body }).into()
    }
}
