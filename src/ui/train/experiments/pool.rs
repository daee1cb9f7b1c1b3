//! Engines that share an experiment out: each has the same corpus and does one run after another, whichever is next. A
//! run is a pure function of its part of the plan, and what is found is joined in the plan's order: one engine or four
//! find the same. The engine of the data is not among them, and stays free for the person.

use crate::ui::page::engine::{Engine, Errand, Health};
use crate::worker::protocol::{
    Answered, Demonstrated, Envelope, Event, ExperimentProgress, MappedFile, Program, Request,
    VERSION,
};
use std::collections::VecDeque;
use std::rc::Rc;

/// The most engines that work at once.
pub const MOST_SEATS: u32 = 4;

/// What is to be done.
#[derive(Clone, Debug, PartialEq)]
pub enum Work {
    /// The runs of a plan.
    Plan(String),
    /// One request, whose answer is all.
    One(Box<Request>),
    /// A model is asked every row, a part of the commands a run.
    Rows(String),
}

/// Engines at work.
#[derive(Clone, Debug, PartialEq)]
pub struct Pool {
    work: Work,
    files: Rc<[MappedFile]>,
    with_rejected: bool,
    seats: Vec<Seat>,
    waiting: VecDeque<u32>,
    n_runs: usize,
    n_done: usize,
    shards: Vec<String>,
    answers: Vec<Answered>,
}

/// An engine with what it does.
#[derive(Clone, Debug, PartialEq)]
struct Seat {
    engine: Engine,
    run: Option<u32>,
    progress: Option<ExperimentProgress>,
    /// Rows that the model was asked in the run at work.
    rows: u32,
    /// Whether it took the place of one that died.
    is_second: bool,
}

/// What an engine of the pool said, or what became of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// It sent a message.
    Heard(Envelope<Event>),
    /// It could not be loaded, or died.
    Broke(String),
    /// It is time to see whether it still answers.
    Look(u32),
}

/// What came of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// The engines are at work.
    Works,
    /// All runs of a plan are done: the plan, and what each found.
    Found(String, Vec<String>),
    /// All rows were asked: the model, and what it makes of them.
    Asked(String, Vec<Answered>),
    /// The one request is answered.
    Demonstrated(Box<Demonstrated>),
    /// It cannot be done, and why.
    Failed(String),
}

/// What is to be done for an engine of the pool, by its seat.
pub type Errands = Vec<(u32, Errand)>;

impl Pool {
    /// Engines that begin: as many as there are runs, and at most so many.
    pub fn new(
        work: Work,
        runs: u32,
        seats: u32,
        (files, with_rejected): (Rc<[MappedFile]>, bool),
        errands: &mut Errands,
    ) -> Pool {
        let waiting: VecDeque<u32> = (0..runs).collect();
        let n_seats = seats.clamp(1, MOST_SEATS).min(runs.max(1));
        let seats = (0..n_seats).map(|_| Seat::new(false)).collect();
        let n_runs = waiting.len();
        let (shards, answers) = (Vec::new(), Vec::new());
        let mut pool =
            Pool { work, files, with_rejected, seats, waiting, n_runs, n_done: 0, shards, answers };
        pool.open(0, errands);
        pool
    }

    /// The number of runs in all.
    pub const fn n_runs(&self) -> usize {
        self.n_runs
    }

    /// The runs that are done.
    pub const fn done(&self) -> usize {
        self.n_done
    }

    /// The model that is asked every row, if that is the work.
    pub fn asks(&self) -> Option<&str> {
        match &self.work {
            Work::Rows(model) => Some(model),
            _ => None,
        }
    }

    /// Whether it is on these files.
    pub fn is_on(&self, files: &Rc<[MappedFile]>) -> bool {
        Rc::ptr_eq(&self.files, files)
    }

    /// Rows that it was asked.
    pub fn rows(&self) -> u32 {
        let known = self.answers.iter().map(|answered| answered.rows.len() as u32);
        known.chain(self.seats.iter().map(|seat| seat.rows)).sum()
    }

    /// The number of engines.
    pub fn n_seats(&self) -> u32 {
        self.seats.len() as u32
    }

    /// How far the runs at work are, each with its number from 0.
    pub fn progress(&self) -> impl Iterator<Item = (u32, &ExperimentProgress)> {
        self.seats.iter().filter_map(|seat| Some((seat.run?, seat.progress.as_ref()?)))
    }

    /// An engine said something.
    pub fn told(&mut self, at: u32, said: Said, errands: &mut Errands) -> Outcome {
        let Some(seat) = self.seats.get_mut(at as usize) else { return Outcome::Works };
        let mut own = Vec::new();
        let outcome = match said {
            Said::Broke(why) => return self.broke(at, why, errands),
            Said::Look(watch) => {
                let is_silent = seat.engine.look(watch, &mut own);
                errands.extend(own.into_iter().map(|errand| (at, errand)));
                return match is_silent {
                    true => self.broke(at, "it does not answer".to_owned(), errands),
                    false => Outcome::Works,
                };
            }
            Said::Heard(Envelope { groundling, id, body }) => {
                seat.engine.heard();
                match body {
                    Event::Crashed { message } => return self.broke(at, message, errands),
                    _ if groundling != VERSION => {
                        Outcome::Failed("page and engine are of different versions".to_owned())
                    }
                    Event::Ready => {
                        seat.engine.ready(&mut own);
                        Outcome::Works
                    }
                    Event::Experimenting(progress) => {
                        seat.progress = Some(progress);
                        Outcome::Works
                    }
                    Event::Auditing { done, .. } => {
                        seat.rows = done;
                        Outcome::Works
                    }
                    Event::Reading { .. } | Event::Pong => Outcome::Works,
                    event => {
                        let request = seat.engine.finish(id, &mut own);
                        errands.extend(own.drain(..).map(|errand| (at, errand)));
                        self.answered(at, request, event, errands)
                    }
                }
            }
        };
        errands.extend(own.into_iter().map(|errand| (at, errand)));
        outcome
    }

    /// A request has been answered.
    fn answered(
        &mut self,
        at: u32,
        request: Option<Request>,
        event: Event,
        errands: &mut Errands,
    ) -> Outcome {
        match event {
            Event::Sheet(_) => {
                // The next engine reads once this one has: the corpus is not copied for all of them at the same time.
                let next = at + 1;
                let is_asleep = |seat: &Seat| seat.engine.health == Health::Asleep;
                if self.seats.get(next as usize).is_some_and(is_asleep) {
                    self.open(next, errands);
                }
                self.next(at, errands);
                Outcome::Works
            }
            Event::Shard { text } => {
                self.shards.push(text);
                self.done_one(at, errands)
            }
            Event::Answered { commands } => {
                self.answers.extend(commands);
                self.done_one(at, errands)
            }
            Event::Demonstrated(found) => Outcome::Demonstrated(found),
            Event::Refused { message } if request.is_some() => Outcome::Failed(message),
            _ => Outcome::Works,
        }
    }

    /// A run is done; what came of all of them, once they are.
    fn done_one(&mut self, at: u32, errands: &mut Errands) -> Outcome {
        self.n_done += 1;
        self.next(at, errands);
        match &self.work {
            Work::Plan(plan) if self.n_done == self.n_runs => {
                Outcome::Found(plan.clone(), std::mem::take(&mut self.shards))
            }
            Work::Rows(model) if self.n_done == self.n_runs => {
                Outcome::Asked(model.clone(), std::mem::take(&mut self.answers))
            }
            _ => Outcome::Works,
        }
    }

    /// Gives an engine its corpus.
    fn open(&mut self, at: u32, errands: &mut Errands) {
        let (files, with_rejected) = (self.files.to_vec(), self.with_rejected);
        self.send(at, Request::OpenSheet { files, with_rejected }, errands);
    }

    /// Gives an engine the next run, if there is one.
    fn next(&mut self, at: u32, errands: &mut Errands) {
        let Some(seat) = self.seats.get_mut(at as usize) else { return };
        (seat.progress, seat.rows) = (None, 0);
        seat.run = self.waiting.pop_front();
        let Some(run) = seat.run else { return };
        let request = match &self.work {
            Work::Plan(plan) => Request::RunShard { plan: plan.clone(), runs: vec![run] },
            Work::Rows(model) => {
                let of = self.n_runs as u32;
                Request::AskPart { model: model.clone(), part: run, of }
            }
            Work::One(request) => (**request).clone(),
        };
        self.send(at, request, errands);
    }

    fn send(&mut self, at: u32, request: Request, errands: &mut Errands) {
        let mut own = Vec::new();
        if let Some(seat) = self.seats.get_mut(at as usize) {
            seat.engine.send(request, false, &mut own);
        }
        errands.extend(own.into_iter().map(|errand| (at, errand)));
    }

    /// An engine died: another takes its place and does its run anew. If that one dies, too, it is not tried again.
    fn broke(&mut self, at: u32, why: String, errands: &mut Errands) -> Outcome {
        let Some(seat) = self.seats.get_mut(at as usize) else { return Outcome::Works };
        if seat.is_second {
            return Outcome::Failed(why);
        }
        self.waiting.extend(seat.run);
        *seat = Seat::new(true);
        self.open(at, errands);
        Outcome::Works
    }
}

impl Seat {
    fn new(is_second: bool) -> Seat {
        Seat {
            engine: Engine::new(Program::Learner),
            run: None,
            progress: None,
            rows: 0,
            is_second,
        }
    }
}
