//! What the engines say: each message goes to the part of the page that asked.

use super::action::Effect;
use super::engine::{Engine, Health};
use super::room::{self, Mode};
use super::state::State;
use super::watch::{self, Values};
use super::{model, talk, teach, train};
use crate::worker::protocol::{Envelope, Event, Program, Request, VERSION};
use std::rc::Rc;

/// An engine said something.
pub(super) fn heard(
    state: &mut State,
    program: Program,
    envelope: Envelope<Event>,
    effects: &mut Vec<Effect>,
) {
    if envelope.groundling != VERSION {
        let why = state.text().other_version;
        return stopped(state, program, why.to_owned());
    }
    let engine = state.engine(program);
    if matches!(engine.health, Health::Stopped(_)) {
        return;
    }
    engine.heard();
    let id = envelope.id;
    match envelope.body {
        Event::Ready => engine.ready(effects),
        Event::Pong => {}
        Event::Crashed { message } => stopped(state, program, message),
        news @ (Event::Progress(_)
        | Event::Planning(_)
        | Event::RollingOut(_)
        | Event::Experimenting(_)) => {
            if engine.pending.as_ref().is_some_and(|pending| pending.id == id) {
                progressed(state, news);
            }
        }
        end => {
            if let Some(request) = engine.finish(id, effects) {
                finished(state, request, end, effects);
            }
        }
    }
}

/// An engine has died, or no longer answers.
pub(super) fn stopped(state: &mut State, program: Program, why: String) {
    state.engine(program).stop(why);
    if program == Program::Learner {
        state.train.progress = None;
    }
    let words = state.text().engine_stopped_said;
    state.say(words);
}

/// A new engine knows nothing: it is given what the old one had.
pub(super) fn restart(state: &mut State, program: Program, effects: &mut Vec<Effect>) {
    *state.engine(program) = Engine::new(program);
    state.engine(program).wake(effects);
    match program {
        Program::Talker => {
            state.watch.has_policy = false;
            model::restore(state, effects);
        }
        Program::Learner => train::restore(state, effects),
    }
    let words = state.text().engine_starting;
    state.say(words);
}

/// How far something is.
fn progressed(state: &mut State, news: Event) {
    match news {
        Event::Progress(progress) => state.train.progress = Some(progress),
        Event::Planning(progress) => state.watch.report(progress),
        Event::RollingOut(runs) => state.watch.runs = Some(runs),
        _ => {}
    }
}

/// A request has been answered.
fn finished(state: &mut State, request: Request, event: Event, effects: &mut Vec<Effect>) {
    if matches!(request, Request::Train { .. }) {
        state.train.progress = None;
    }
    match (event, request) {
        (Event::Opened(report), Request::OpenModel { text }) => {
            model::opened(state, &text, report, effects);
        }
        (Event::Answer(answer), Request::Read { .. }) => talk::was_read(state, *answer),
        (Event::Answer(answer), Request::Ask { state: world, .. }) => {
            talk::answered(state, *answer, world, effects);
        }
        (Event::Planned(plan), _) => talk::replanned(state, *plan, effects),
        (Event::Explained(studies), _) => state.talk.studies = Some(Rc::new(studies)),
        (Event::Values(map), Request::Values { state: of }) => {
            state.watch.values = Some(Values { map: Rc::new(map), of });
            watch::look(state, effects);
        }
        (Event::RolledOut(runs), _) => {
            state.watch.runs = Some(runs);
            let words = (state.text().runs)(&runs);
            state.say(words);
        }
        (Event::World(world), request) => {
            if matches!(request, Request::Draw { .. }) {
                state.room.seed = state.room.seed.wrapping_add(1);
            }
            room::open(state, world, None, effects);
            if matches!(request, Request::ReadWorld { .. }) {
                state.room.text = None;
            }
        }
        (Event::WorldText { text }, _) => state.room.text = Some(text),

        (Event::Corpus(report), Request::ReadCorpus { text, .. }) => {
            train::opened(state, report, text, effects);
        }
        (Event::Row { row, pairs }, _) => train::shown(state, row, pairs),
        (Event::Trained(report), _) => {
            let words = (state.text().trained)(report.valid, report.examples);
            state.say(words);
            let corpus = state.train.corpus.as_ref().map(|c| c.report.name.clone());
            model::trained(state, report, corpus.unwrap_or_default(), effects);
        }
        (Event::Taught(report), Request::Teach { examples, .. }) => {
            teach::taught(state, examples, *report, effects);
        }
        (Event::Refused { message }, request) => refused(state, request, message),
        (Event::Cancelled, Request::Train { .. }) => {
            let words = state.text().training_stopped;
            state.train.notice = Some(words.to_owned());
            state.say(words);
        }
        (Event::Cancelled, Request::Ask { .. } | Request::Plan { .. }) => {
            let words = state.text().planning_stopped;
            state.talk.notice = Some(words.to_owned());
            state.say(words);
        }
        _ => {}
    }
}

/// A request was refused: the person is told where they asked.
fn refused(state: &mut State, request: Request, message: String) {
    state.say(message.clone());
    match request {
        Request::ReadCorpus { .. } => {
            state.train.file_notice = Some(train::FileNotice { message, problems: Vec::new() });
        }
        Request::Train { .. } => state.train.notice = Some(message),
        Request::Teach { .. } => {
            state.teach.notice = Some(message);
            state.room.mode = Mode::Teach;
        }
        Request::OpenModel { .. } => state.model_notice = Some(message),
        Request::Draw { .. } | Request::ReadWorld { .. } | Request::WriteWorld { .. } => {
            state.room.notice = Some(message);
        }
        Request::Ask { .. } | Request::Plan { .. } => state.talk.notice = Some(message),
        // Nobody asked for these by name.
        _ => {}
    }
}
