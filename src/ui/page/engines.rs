//! What the engines say, as far as it is about themselves: whether they live, and which request a message answers.
//! The rest is news, for the page that asked.

use super::engine::{Engine, Health};
use super::model;
use super::shared::Shared;
use super::words::Text;
use crate::worker::protocol::{Envelope, Event, Program, Request, VERSION};

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
pub fn heard(shared: &mut Shared, program: Program, envelope: Envelope<Event>) -> Option<News> {
    if envelope.groundling != VERSION {
        let why = Text::of(shared.language).other_version;
        return Some(stopped(shared, program, why.to_owned()));
    }
    let (engine, wanted) = shared.engine(program);
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
        Event::Crashed { message } => Some(stopped(shared, program, message)),
        progress @ (Event::Reading { .. }
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
pub fn look(shared: &mut Shared, program: Program, watch: u32) -> Option<News> {
    let (engine, wanted) = shared.engine(program);
    if !engine.look(watch, wanted) {
        return None;
    }
    let why = Text::of(shared.language).engine_silent;
    Some(stopped(shared, program, why.to_owned()))
}

/// An engine has died, or no longer answers.
pub fn stopped(shared: &mut Shared, program: Program, why: String) -> News {
    shared.engine(program).0.stop(why);
    shared.say(Text::of(shared.language).engine_stopped_said);
    News::Stopped
}

/// A new engine takes an old one's place. It knows nothing: the one that answers is given its model.
pub fn restart(shared: &mut Shared, program: Program) {
    *shared.engine(program).0 = Engine::new(program);
    shared.wake(program);
    if program == Program::Talker {
        model::restore(shared);
    }
    shared.say(Text::of(shared.language).engine_starting);
}
