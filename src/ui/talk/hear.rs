//! What the engines say to the Talk page: each answer goes to the part that asked.

use super::command::{answer, examples, say, wonder};
use super::room::worlds;
use super::share::exchange;
use super::state::State;
use super::teach::learn;
use super::watch::state::Values;
use super::watch::{ahead, values};
use super::words::Text;
use crate::ui::page::shared::Shared;
use crate::worker::protocol::{Event, Request};
use std::rc::Rc;

/// How far something is.
pub fn progressed(state: &mut State, shared: &Shared, event: Event) {
    let is_ahead = shared.talker.is_at(ahead::is_for);
    match event {
        Event::Planning(_) if is_ahead => {}
        Event::Planning(progress) => state.watch.report(progress),
        Event::RollingOut(runs) => state.watch.runs = Some(runs),
        _ => {}
    }
}

/// A request has been answered.
pub fn answered(state: &mut State, shared: &mut Shared, request: Request, event: Event) {
    match (event, request) {
        (Event::Planned(way), Request::GoOn { run, .. }) => {
            ahead::came(state, shared, run.len().saturating_sub(1), &way);
        }
        (_, Request::GoOn { .. }) => {}
        (Event::Answer(answer), Request::Read { .. })
            if wonder::was_read(state, shared, &answer) => {}
        (Event::Answer(answer), Request::Read { .. }) => answer::was_read(state, shared, *answer),
        (Event::Answer(answer), Request::Ask { state: world, .. }) => {
            answer::answered(state, shared, *answer, world);
        }
        (Event::Planned(plan), _) => answer::replanned(state, shared, *plan),
        (Event::Explained(studies), _) => state.command.studies = Some(Rc::new(studies)),
        (Event::Values(map), Request::Values { state: of, done }) => {
            state.watch.values = Some(Values { map: Rc::new(map), of, done });
            values::look(state, shared);
        }
        (Event::RolledOut(runs), _) => {
            state.watch.runs = Some(runs);
            shared.say((Text::of(shared.language).runs)(&runs));
        }
        (Event::Example { wanted, command }, Request::Example { state: room, rules, .. }) => {
            examples::came(state, shared, (&wanted, (&room, &rules)), command);
        }
        (Event::World(world), request) => worlds::came(state, shared, world, &request),
        (Event::WorldText { text }, _) => state.room.text = Some(text),
        (Event::Taught(report), Request::Teach { examples, .. }) => {
            learn::taught(state, shared, examples, *report);
        }
        (Event::Cancelled, Request::Ask { .. } | Request::Plan { .. }) => {
            let words = Text::of(shared.language).planning_stopped;
            state.command.notice = Some(words.to_owned());
            shared.say(words);
        }
        (Event::Refused { message }, request) => refused(state, shared, &request, message),
        _ => {}
    }
}

/// A request was refused: the person is told where they asked.
fn refused(state: &mut State, shared: &mut Shared, request: &Request, message: String) {
    shared.say(message.clone());
    match request {
        Request::Teach { .. } => learn::refused(state, message),
        Request::Draw { .. } | Request::ReadWorld { .. } | Request::WriteWorld { .. } => {
            state.room.notice = Some(message);
        }
        Request::Ask { .. } | Request::Plan { .. } => state.command.notice = Some(message),
        // Nobody asked for these by name.
        _ => {}
    }
}

/// Another model is open: the lessons there are are taught to it first, else what waits for it goes on.
pub fn model_opened(state: &mut State, shared: &mut Shared, teach: bool) {
    if teach {
        return learn::learn_again(state, shared);
    }
    can_hear(state, shared);
}

/// Commands are understood otherwise from now on: what waits for that goes on, and what is typed is read again.
pub fn can_hear(state: &mut State, shared: &mut Shared) {
    exchange::resume(state, shared);
    say::begin(state, shared);
}
