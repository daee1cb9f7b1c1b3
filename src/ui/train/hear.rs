//! What the engine says to the workbench: each message goes to the part that asked.

use super::state::State;
use super::{data, run};
use crate::ui::page::engines::News;
use crate::worker::protocol::{Event, Request};

/// There is news of an engine, or none.
pub(super) fn told(state: &mut State, news: Option<News>) {
    let State { desk, data, run, .. } = state;
    match news {
        Some(News::Progress(Event::Progress(progress))) => run.progress = Some(progress),
        Some(News::Progress(Event::Reading { done, of })) => data.reading = Some((done, of)),
        Some(News::Answer(Request::Train { .. }, event)) => {
            let corpus = data.corpus.as_ref().map_or("", |corpus| &corpus.report.name);
            run::hear::ended(run, desk, event, corpus);
        }
        Some(News::Answer(request, event)) => data::hear::answered(data, desk, request, event),
        Some(News::Stopped) => (run.progress, data.reading) = (None, None),
        Some(News::Progress(_)) | None => {}
    }
}
