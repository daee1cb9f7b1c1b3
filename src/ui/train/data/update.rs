//! Does what a person wants with the corpus.

use super::action::Action;
use super::corpus::{Corpus, DEMO, DEMO_NAME};
use super::state::{FileNotice, State};
use crate::ui::page::files::{self, Fault, Offered};
use crate::ui::page::news::News;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::ui::train::words::Text;
use crate::worker::protocol::{CorpusFile, Request};

/// Does what a person wants.
pub fn update(state: &mut State, desk: &mut Desk, action: Action) {
    match action {
        Action::Offered(files) => open(state, desk, files),
        Action::OpenDemo => open_demo(state, desk),
        Action::ToggleRow(row) => toggle_row(state, desk, row),
        Action::MoreRows => state.corpus.iter_mut().for_each(Corpus::more),
        Action::SaveCorpus => {
            for file in state.corpus.iter().flat_map(|corpus| corpus.files.iter()) {
                desk.want(Effect::GiveBack(file.clone()));
            }
        }
        Action::UseRejected => {
            let refused = state.file_notice.take().map(|notice| notice.rejected);
            let open = || state.corpus.as_ref().map(|corpus| corpus.files.to_vec());
            let files = refused.filter(|files| !files.is_empty()).or_else(open);
            read(state, desk, files.unwrap_or_default(), true);
        }
        Action::StopReading => {
            desk.learner.retain(|request| !matches!(request, Request::ReadCorpus { .. }));
            if state.reading.is_some() {
                desk.cancel();
            }
        }
    }
}

/// The workbench is to be seen: it begins with the page's own sentences.
pub fn begin(state: &mut State, desk: &mut Desk) {
    let reads = |request: &Request| matches!(request, Request::ReadCorpus { .. });
    if state.corpus.is_none() && !desk.learner.is_at(reads) {
        open_demo(state, desk);
    }
}

/// The engine began anew: it is given its corpus again.
pub fn restore(state: &State, desk: &mut Desk) {
    if let Some(corpus) = &state.corpus {
        let (files, with_rejected) = (corpus.files.to_vec(), corpus.with_rejected);
        desk.send(Request::ReadCorpus { files, with_rejected }, false);
    }
}

/// Opens files: all corpora among them are one, the rest is the robot's. Where one cannot be read, none is.
fn open(state: &mut State, desk: &mut Desk, files: Vec<Offered>) {
    let (mut corpora, mut given) = (Vec::new(), Vec::new());
    for Offered { name, bytes } in files {
        let taken = bytes.and_then(|bytes| {
            if files::kind(&name, &bytes) == files::Kind::Corpus {
                corpora.push(CorpusFile { name: name.clone(), bytes });
            } else {
                given.extend(files::given(&name, bytes)?);
            }
            Ok(())
        });
        if let Err(fault) = taken {
            return refuse(state, desk, &name, fault);
        }
    }
    for given in given {
        desk.want(Effect::Tell(News::Give(given)));
    }
    if !corpora.is_empty() {
        read(state, desk, corpora, false);
    }
}

/// Gives the engine files to read as one corpus.
fn read(state: &mut State, desk: &mut Desk, files: Vec<CorpusFile>, with_rejected: bool) {
    state.file_notice = None;
    desk.learner.retain(|r| !matches!(r, Request::ShowRow { .. } | Request::ReadCorpus { .. }));
    desk.send(Request::ReadCorpus { files, with_rejected }, false);
}

/// A file of this name cannot be read.
fn refuse(state: &mut State, desk: &mut Desk, name: &str, fault: Fault) {
    let message = (Text::of(desk.language).file_fault)(name, fault);
    desk.say(message.clone());
    state.file_notice = Some(FileNotice::of(message));
}

fn open_demo(state: &mut State, desk: &mut Desk) {
    let file = CorpusFile { name: DEMO_NAME.to_owned(), bytes: DEMO.into() };
    read(state, desk, vec![file], false);
}

fn toggle_row(state: &mut State, desk: &mut Desk, row: usize) {
    let Some(corpus) = &mut state.corpus else { return };
    corpus.open = (corpus.open != Some(row)).then_some(row);
    if corpus.open.is_some() && !corpus.pairs.contains_key(&row) {
        desk.send(Request::ShowRow { row }, false);
    }
}
