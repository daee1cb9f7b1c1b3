//! What the page knows of an engine: whether it lives, what it is doing, and what it is to do next. An engine is
//! started when something is asked of it and does one thing at a time, so requests wait here; a watch notices when it
//! no longer answers.

use super::effect::{Effect, Timer};
use crate::worker::protocol::{Envelope, Program, Request, VERSION};
use std::collections::VecDeque;

/// Milliseconds between two looks at a busy engine.
pub const WATCH_MS: u32 = 2_000;

/// So many looks without a word, and the engine counts as stopped.
const PATIENCE: u32 = 4;

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
    pub fn wake(&mut self, effects: &mut Vec<Effect>) {
        if self.health == Health::Asleep {
            self.health = Health::Starting;
            effects.push(Effect::SpawnEngine(self.program));
        }
    }

    /// Whether it is at such a request, or will be as soon as it can.
    pub fn is_at(&self, such: impl Fn(&Request) -> bool) -> bool {
        let at_work = self.pending.as_ref().map(|pending| &pending.request);
        at_work.into_iter().chain(&self.waiting).any(such)
    }

    /// Sends a request as soon as the engine is free; an `urgent` one goes before all that wait.
    pub fn send(&mut self, request: Request, urgent: bool, effects: &mut Vec<Effect>) {
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
    pub fn cancel(&mut self, effects: &mut Vec<Effect>) {
        if let Some(pending) = &self.pending {
            effects.push(self.post(pending.id, Request::Cancel));
        }
    }

    /// The engine is up.
    pub fn ready(&mut self, effects: &mut Vec<Effect>) {
        self.health = Health::Ready;
        self.pump(effects);
    }

    /// The request at work has been answered: gives it back, and sends the next one.
    pub fn finish(&mut self, id: u32, effects: &mut Vec<Effect>) -> Option<Request> {
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
    pub fn look(&mut self, watch: u32, effects: &mut Vec<Effect>) -> bool {
        if watch != self.watch || self.pending.is_none() {
            return false;
        }
        self.silent += 1;
        if self.silent > PATIENCE {
            return true;
        }
        effects.push(self.post(0, Request::Ping));
        effects.push(Effect::StartTimer(Timer::Watch(self.program, self.watch), WATCH_MS));
        false
    }

    fn pump(&mut self, effects: &mut Vec<Effect>) {
        if self.health != Health::Ready || self.pending.is_some() {
            return;
        }
        let Some(request) = self.waiting.pop_front() else { return };
        self.last_id = self.last_id.wrapping_add(1).max(1);
        let id = self.last_id;
        self.silent = 0;
        self.watch = self.watch.wrapping_add(1);
        effects.push(self.post(id, request.clone()));
        effects.push(Effect::StartTimer(Timer::Watch(self.program, self.watch), WATCH_MS));
        self.pending = Some(Pending { id, request });
    }

    fn post(&self, id: u32, body: Request) -> Effect {
        Effect::Post(self.program, Envelope { groundling: VERSION, id, body })
    }
}
