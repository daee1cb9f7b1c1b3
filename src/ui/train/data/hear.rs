//! What the engine says of the corpus.

use super::corpus::{Corpus, SMALL};
use super::state::{FileNotice, State};
use crate::ui::train::desk::Desk;
use crate::ui::train::words::Text;
use crate::worker::protocol::{CorpusFile, CorpusReport, Event, Request};
use std::rc::Rc;

/// A request has been answered.
pub fn answered(state: &mut State, desk: &mut Desk, request: Request, event: Event) {
    if matches!(request, Request::ReadCorpus { .. }) {
        state.reading = None;
    }
    match (event, request) {
        (Event::Corpus(report), Request::ReadCorpus { files, with_rejected }) => {
            opened(state, desk, report, files, with_rejected);
        }
        (Event::Row { row, pairs }, _) => {
            if let Some(corpus) = &mut state.corpus {
                corpus.pairs.insert(row, Rc::new(pairs));
            }
        }
        (Event::Cancelled, Request::ReadCorpus { .. }) => {
            let words = Text::of(desk.language).reading_stopped;
            state.file_notice = Some(FileNotice::of(words.to_owned()));
            desk.say(words);
        }
        (Event::Refused { message }, request) => {
            desk.say(message.clone());
            if matches!(request, Request::ReadCorpus { .. }) {
                state.file_notice = Some(FileNotice::of(message));
            }
        }
        _ => {}
    }
}

/// A corpus was read.
fn opened(
    state: &mut State,
    desk: &mut Desk,
    report: CorpusReport,
    files: Vec<CorpusFile>,
    with_rejected: bool,
) {
    let words = Text::of(desk.language);
    if report.rows.is_empty() {
        let message = (words.no_rows)(&report.name);
        desk.say(message.clone());
        let rejected = if report.rejected > 0 { files } else { Vec::new() };
        state.file_notice = Some(FileNotice { message, problems: report.problems, rejected });
        return;
    }
    let rows = report.rows.len();
    desk.say((words.corpus_open)(&report.name, rows));
    state.file_notice = None;
    state.corpus = Some(Corpus::new(report, files, with_rejected));
    if rows <= SMALL {
        for row in 0..rows {
            desk.send(Request::ShowRow { row }, false);
        }
    }
}
