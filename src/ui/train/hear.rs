//! What the engine that learns says to the Train page.

use super::action::Wish;
use super::corpus::{Corpus, SMALL};
use super::state::{FileNotice, State};
use super::words::Text;
use crate::ui::page::shared::Shared;
use crate::worker::protocol::{CorpusFile, CorpusReport, Event, Progress, Request};
use std::rc::Rc;

/// Training is so far.
pub fn progressed(state: &mut State, progress: Progress) {
    state.progress = Some(progress);
}

/// The engine has stopped.
pub fn stopped(state: &mut State) {
    (state.progress, state.reading) = (None, None);
}

/// The engine began anew: it knows no corpus.
pub fn restarted(state: &State, shared: &mut Shared) {
    if let Some(corpus) = &state.corpus {
        let (files, with_rejected) = (corpus.files.to_vec(), corpus.with_rejected);
        shared.send(Request::ReadCorpus { files, with_rejected }, false);
    }
}

/// A request has been answered; what is not the page's own to do is returned.
pub fn answered(
    state: &mut State,
    shared: &mut Shared,
    request: Request,
    event: Event,
) -> Option<Wish> {
    match request {
        Request::Train { .. } => state.progress = None,
        Request::ReadCorpus { .. } => state.reading = None,
        _ => {}
    }
    match (event, request) {
        (Event::Corpus(report), Request::ReadCorpus { files, with_rejected }) => {
            opened(state, shared, report, files, with_rejected);
        }
        (Event::Row { row, pairs }, _) => {
            if let Some(corpus) = &mut state.corpus {
                corpus.pairs.insert(row, Rc::new(pairs));
            }
        }
        (Event::Trained(report), _) => {
            shared.say((Text::of(shared.language).trained)(report.valid, report.examples));
            let corpus = state.corpus.as_ref().map(|corpus| corpus.report.name.clone());
            return Some(Wish::Use(report, corpus.unwrap_or_default()));
        }
        (Event::Cancelled, Request::Train { .. }) => {
            let words = Text::of(shared.language).training_stopped;
            state.notice = Some(words.to_owned());
            shared.say(words);
        }
        (Event::Cancelled, Request::ReadCorpus { .. }) => {
            let words = Text::of(shared.language).reading_stopped;
            state.file_notice = Some(FileNotice::of(words.to_owned()));
            shared.say(words);
        }
        (Event::Refused { message }, request) => {
            shared.say(message.clone());
            match request {
                Request::Train { .. } => state.notice = Some(message),
                Request::ReadCorpus { .. } => state.file_notice = Some(FileNotice::of(message)),
                // Nobody asked for these by name.
                _ => {}
            }
        }
        _ => {}
    }
    None
}

/// A corpus was read.
fn opened(
    state: &mut State,
    shared: &mut Shared,
    report: CorpusReport,
    files: Vec<CorpusFile>,
    with_rejected: bool,
) {
    let words = Text::of(shared.language);
    if report.rows.is_empty() {
        let message = (words.no_rows)(&report.name);
        shared.say(message.clone());
        let rejected = if report.rejected > 0 { files } else { Vec::new() };
        state.file_notice = Some(FileNotice { message, problems: report.problems, rejected });
        return;
    }
    let rows = report.rows.len();
    shared.say((words.corpus_open)(&report.name, rows));
    state.file_notice = None;
    state.corpus = Some(Corpus::new(report, files, with_rejected));
    if rows <= SMALL {
        for row in 0..rows {
            shared.send(Request::ShowRow { row }, false);
        }
    }
}
