//! What the engines say: each message goes to the page that asked.

use super::state::State;
use super::wish::grant;
use crate::ui::page::engines::{self, News};
use crate::ui::page::{model, resource};
use crate::ui::{talk, train};
use crate::worker::protocol::{Envelope, Event, Program, Request};

/// An engine said something.
pub(super) fn heard(state: &mut State, program: Program, envelope: Envelope<Event>) {
    let news = engines::heard(&mut state.shared, program, envelope);
    told(state, program, news);
}

/// There is news of an engine, or none.
pub(super) fn told(state: &mut State, program: Program, news: Option<News>) {
    let State { talk, train, .. } = state;
    match news {
        Some(News::Progress(Event::Progress(progress))) => {
            train::hear::progressed(train, progress);
        }
        Some(News::Progress(Event::Reading { done, of })) => train.reading = Some((done, of)),
        Some(News::Progress(event)) => talk::hear::progressed(talk, event),
        Some(News::Answer(request, event)) => answered(state, request, event),
        Some(News::Stopped) if program == Program::Learner => train::hear::stopped(train),
        Some(News::Stopped) | None => {}
    }
}

/// A person wants a new engine: the pages give it again what the old one had of theirs.
pub(super) fn restart(state: &mut State, program: Program) {
    let State { shared, talk, train, .. } = state;
    engines::restart(shared, program);
    match program {
        Program::Talker => talk.watch.has_policy = false,
        Program::Learner => train::hear::restarted(train, shared),
    }
}

/// A request has been answered.
fn answered(state: &mut State, request: Request, event: Event) {
    let State { shared, talk, train, .. } = state;
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
        (
            request
            @ (Request::ReadCorpus { .. } | Request::ShowRow { .. } | Request::Train { .. }),
            event,
        ) => {
            let wish = train::hear::answered(train, shared, request, event);
            grant(state, wish);
        }
        (request, event) => talk::hear::answered(talk, shared, request, event),
    }
}
