//! An engine: one job at a time for one of the page's programs, pumped step by step by whoever owns it: the page's
//! worker, tests and benches alike; a step does a bounded amount of work. What there is to be done is its role's.

use super::protocol::{Event, Program, Request};
use std::collections::VecDeque;

/// What a program of the page keeps, and how it begins what is asked of it.
pub trait Role: Default {
    /// Which program that is.
    const PROGRAM: Program;

    /// Begins what is asked, or says why it cannot. Nothing that is kept may change before the job is over.
    ///
    /// # Errors
    /// In words: what is wrong with the request, or that it is the other program's.
    fn begin(&mut self, request: Request) -> Result<Job<Self>, String>;

    /// Answers a request that replaces nothing, whatever is at work.
    ///
    /// # Errors
    /// In words: what is wrong with the request, or that it is the other program's.
    fn answer(&mut self, request: Request) -> Result<Event, String> {
        Err(misdirected(&request, Self::PROGRAM))
    }

    /// Where what is at work may rest.
    fn rest(&self) -> Rest {
        Rest::Example
    }
}

/// Where work may rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rest {
    /// Not here.
    Nowhere,
    /// Behind an example, or anywhere where there are none.
    Example,
    /// Behind an epoch.
    Epoch,
}

/// How far work goes before it rests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Pace {
    /// To the end.
    #[default]
    Go,
    /// It rests as soon as it can.
    Pause,
    /// To the end of an example.
    Example,
    /// To the end of an epoch.
    Epoch,
    /// It rests.
    Rest,
}

/// Work in parts: each call does a bounded part.
pub type Job<R> = Box<dyn FnMut(&mut R) -> Step>;

/// What a part of a job comes to.
pub enum Step {
    /// There is more to do; and something to be said, now and then.
    Working(Option<Event>),
    /// The job is over: its last word.
    Over(Event),
}

/// An engine in a role.
#[derive(Default)]
pub struct Engine<R> {
    role: R,
    work: Option<(u32, Job<R>)>,
    pace: Pace,
    /// What must still be said before the work goes on: answers that take no work, and the ends of requests.
    said: VecDeque<(u32, Event)>,
}

impl<R: Role> Engine<R> {
    /// An engine that knows nothing.
    pub fn new() -> Engine<R> {
        Engine { role: R::default(), work: None, pace: Pace::Go, said: VecDeque::new() }
    }

    /// Takes a request; what was at work is cancelled, and what it would have replaced stays.
    pub fn start(&mut self, id: u32, request: Request) {
        if request == Request::Ping {
            return self.said.push_back((id, Event::Pong));
        }
        let pace = match request {
            Request::Pause => Some(Pace::Pause),
            Request::Resume => Some(Pace::Go),
            Request::StepExample => Some(Pace::Example),
            Request::StepEpoch => Some(Pace::Epoch),
            _ => None,
        };
        if let Some(pace) = pace {
            self.said.push_back((id, Event::Heard));
            self.go(pace);
            return;
        }
        if request.is_aside() {
            let answer = self.role.answer(request);
            let event = answer.unwrap_or_else(|message| Event::Refused { message });
            return self.said.push_back((id, event));
        }
        self.pace = Pace::Go;
        self.said.extend(self.work.take().map(|(id, _)| (id, Event::Cancelled)));
        if request == Request::Cancel {
            return;
        }
        match self.role.begin(request) {
            Ok(job) => self.work = Some((id, job)),
            Err(message) => self.said.push_back((id, Event::Refused { message })),
        }
    }

    /// Whether there is something to step.
    pub fn busy(&self) -> bool {
        !self.said.is_empty() || self.work.is_some() && self.pace != Pace::Rest
    }

    /// Goes on so; what cannot go on rests already.
    fn go(&mut self, pace: Pace) {
        if self.work.is_some() && (self.pace, pace) != (Pace::Rest, Pace::Pause) {
            self.pace = pace;
            self.rest(None);
        }
    }

    /// Rests, if it is time to; what was said last, if anything was.
    fn rest(&mut self, said: Option<&Event>) {
        let rest = self.role.rest();
        let is_time = match self.pace {
            Pace::Go | Pace::Rest => false,
            Pace::Pause => rest >= Rest::Example,
            Pace::Example => said.is_some() && rest >= Rest::Example,
            Pace::Epoch => said.is_some() && rest >= Rest::Epoch,
        };
        if let Some((id, _)) = self.work.as_ref().filter(|_| is_time) {
            self.said.push_back((*id, Event::Paused));
            self.pace = Pace::Rest;
        }
    }

    /// Does a bounded part of the work; what there is to say of it, with the id of its request.
    pub fn step(&mut self) -> Option<(u32, Event)> {
        if let Some(said) = self.said.pop_front() {
            return Some(said);
        }
        if self.pace == Pace::Rest {
            return None;
        }
        let (id, mut job) = self.work.take()?;
        let event = match job(&mut self.role) {
            Step::Over(event) => Some(event),
            Step::Working(event) => {
                self.work = Some((id, job));
                self.rest(event.as_ref());
                event
            }
        };
        event.map(|event| (id, event))
    }
}

/// A job that has nothing to do but to say something.
pub(super) fn say<R>(event: Event) -> Result<Job<R>, String> {
    let mut event = Some(event);
    Ok(Box::new(move |_| event.take().map_or(Step::Working(None), Step::Over)))
}

/// Why a request was not begun: it went to the wrong program.
pub(super) fn misdirected(request: &Request, program: Program) -> String {
    let other = request.program().map_or("no program", Program::name);
    format!("This is for the {other}, and was sent to the {}.", program.name())
}
