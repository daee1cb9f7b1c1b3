//! What the engines say, as far as it is about themselves: whether they live, and which request a message answers.
//! The rest is news, for whoever asked.

use super::engine::{Engine, Errand, Health};
use super::language::Language;
use super::words::Text;
use crate::worker::protocol::{Envelope, Event, Program, Request, StudySaid, VERSION};

/// Who has engines: the page, and the workbench its own.
pub trait Owner {
    /// What it wants done, engines among it.
    type Effect: From<Errand>;

    /// An engine, with where it leaves what it wants done.
    fn engine(&mut self, program: Program) -> (&mut Engine, &mut Vec<Self::Effect>);

    /// The language of what is said.
    fn language(&self) -> Language;

    /// A screen reader is to tell these words.
    fn say(&mut self, words: &str);
}

/// News from an engine.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// How far the request at work is.
    Progress(Event),
    /// A request has been answered.
    Answer(Request, Event),
    /// The engine has stopped: what it was at is lost.
    Stopped,
}

/// An engine said something.
pub fn heard(owner: &mut impl Owner, program: Program, envelope: Envelope<Event>) -> Option<News> {
    if envelope.groundling != VERSION {
        let why = Text::of(owner.language()).other_version;
        return Some(stopped(owner, program, why.to_owned()));
    }
    let (engine, wanted) = owner.engine(program);
    if matches!(engine.health, Health::Stopped(_)) {
        return None;
    }
    engine.heard();
    let id = envelope.id;
    match envelope.body {
        Event::Ready => {
            engine.ready(wanted);
            None
        }
        Event::Pong => None,
        Event::Crashed { message } => Some(stopped(owner, program, message)),
        progress @ (Event::Reading { .. }
        | Event::Auditing { .. }
        | Event::Study(
            StudySaid::Making(..) | StudySaid::Bringing(_) | StudySaid::Judging(..),
        )
        | Event::HeldOut { .. }
        | Event::Paused
        | Event::Progress(_)
        | Event::Planning(_)
        | Event::RollingOut(_)
        | Event::Experimenting(_)) => {
            let is_at_work = engine.pending.as_ref().is_some_and(|pending| pending.id == id);
            is_at_work.then_some(News::Progress(progress))
        }
        end => Some(News::Answer(engine.finish(id, wanted)?, end)),
    }
}

/// Time to see whether an engine still answers.
pub fn look(owner: &mut impl Owner, program: Program, watch: u32) -> Option<News> {
    let (engine, wanted) = owner.engine(program);
    if !engine.look(watch, wanted) {
        return None;
    }
    let why = Text::of(owner.language()).engine_silent;
    Some(stopped(owner, program, why.to_owned()))
}

/// An engine has died, or no longer answers.
pub fn stopped(owner: &mut impl Owner, program: Program, why: String) -> News {
    owner.engine(program).0.stop(why);
    owner.say(Text::of(owner.language()).engine_stopped_said);
    News::Stopped
}

/// A new engine takes an old one's place. It knows nothing.
pub fn restart(owner: &mut impl Owner, program: Program) {
    let (engine, wanted) = owner.engine(program);
    *engine = Engine::new(program);
    engine.wake(wanted);
    owner.say(Text::of(owner.language()).engine_starting);
}
