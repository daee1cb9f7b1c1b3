//! What the engines say: each message goes to the page that asked.

use super::state::State;
use crate::ui::page::engines::{self, News};
use crate::ui::page::{model, resource};
use crate::ui::talk;
use crate::worker::protocol::{Envelope, Event, Program, Request};

/// An engine said something.
pub(super) fn heard(state: &mut State, program: Program, envelope: Envelope<Event>) {
    let news = engines::heard(&mut state.shared, program, envelope);
    told(state, news);
}

/// There is news of an engine, or none.
pub(super) fn told(state: &mut State, news: Option<News>) {
    match news {
        Some(News::Progress(event)) => {
            talk::hear::progressed(&mut state.talk, &state.shared, event)
        }
        Some(News::Answer(request, event)) => answered(state, request, event),
        Some(News::Stopped) | None => {}
    }
}

/// A person wants a new engine: the pages give it again what the old one had of theirs.
pub(super) fn restart(state: &mut State, program: Program) {
    engines::restart(&mut state.shared, program);
    if program == Program::Talker {
        model::restore(&mut state.shared);
        state.talk.watch.has_policy = false;
    }
}

/// A request has been answered.
fn answered(state: &mut State, request: Request, event: Event) {
    let State { shared, talk, .. } = state;
    match (request, event) {
        (Request::OpenModel { text }, Event::Opened(report)) => {
            let teach = model::opened(shared, &text, report);
            talk::hear::model_opened(talk, shared, teach);
        }
        (Request::Words { text }, event) => {
            resource::read(shared, text, event == Event::Words);
            talk::hear::can_hear(talk, shared);
        }
        (Request::OpenModel { .. }, Event::Refused { message }) => model::refused(shared, message),
        (request, event) => talk::hear::answered(talk, shared, request, event),
    }
}
