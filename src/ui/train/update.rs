//! Does what a person wants on the Train page.

use super::action::{Action, Wish};
use super::corpus::{Corpus, DEMO, DEMO_NAME};
use super::state::{FileNotice, SETTINGS, State, is_training};
use super::words::Text;
use crate::ui::page::effect::Effect;
use crate::ui::page::files::Fault;
use crate::ui::page::shared::Shared;
use crate::worker::protocol::{CorpusFile, Program, Request, SeedLexicon};

/// Does what a person wants; what is not the page's own to do is returned.
pub fn update(state: &mut State, shared: &mut Shared, action: Action) -> Option<Wish> {
    match action {
        Action::Offered(files) => return Some(Wish::Open(files)),
        Action::OpenDemo => open_demo(state, shared),
        Action::ToggleRow(row) => toggle_row(state, shared, row),
        Action::MoreRows => state.corpus.iter_mut().for_each(Corpus::more),
        Action::SaveCorpus => {
            for file in state.corpus.iter().flat_map(|corpus| corpus.files.iter()) {
                shared.want(Effect::GiveBack(file.clone()));
            }
        }
        Action::UseRejected => {
            let refused = state.file_notice.take().map(|notice| notice.rejected);
            let open = || state.corpus.as_ref().map(|corpus| corpus.files.to_vec());
            let files = refused.filter(|files| !files.is_empty()).or_else(open);
            read_corpus(state, shared, files.unwrap_or_default(), true);
        }
        Action::StopReading => {
            shared.learner.retain(|request| !matches!(request, Request::ReadCorpus { .. }));
            if state.reading.is_some() {
                shared.cancel(Program::Learner);
            }
        }
        Action::Train => train(state, shared),
        Action::CancelTraining => {
            shared.learner.retain(|request| !matches!(request, Request::Train { .. }));
            if is_training(shared) {
                shared.cancel(Program::Learner);
            }
        }
        Action::SaveModel => {
            if let Some(model) = &shared.document.model {
                let text = model.report.model.clone();
                shared.want(Effect::Save { name: "groundling.model".to_owned(), text });
            }
        }
    }
    None
}

/// The page was opened: it begins with the page's own sentences.
pub fn begin(state: &mut State, shared: &mut Shared) {
    let reads = |request: &Request| matches!(request, Request::ReadCorpus { .. });
    if state.corpus.is_none() && !shared.learner.is_at(reads) {
        open_demo(state, shared);
    }
}

/// Gives the engine files to read as one corpus.
pub fn read_corpus(
    state: &mut State,
    shared: &mut Shared,
    files: Vec<CorpusFile>,
    with_rejected: bool,
) {
    state.file_notice = None;
    shared.learner.retain(|r| !matches!(r, Request::ShowRow { .. } | Request::ReadCorpus { .. }));
    shared.send(Request::ReadCorpus { files, with_rejected }, false);
}

/// A file of this name was offered that cannot be read.
pub fn refuse(state: &mut State, shared: &mut Shared, name: &str, fault: Fault) {
    let message = (Text::of(shared.language).file_fault)(name, fault);
    shared.say(message.clone());
    state.file_notice = Some(FileNotice::of(message));
}

fn open_demo(state: &mut State, shared: &mut Shared) {
    let file = CorpusFile { name: DEMO_NAME.to_owned(), bytes: DEMO.into() };
    read_corpus(state, shared, vec![file], false);
}

fn toggle_row(state: &mut State, shared: &mut Shared, row: usize) {
    let Some(corpus) = &mut state.corpus else { return };
    corpus.open = (corpus.open != Some(row)).then_some(row);
    if corpus.open.is_some() && !corpus.pairs.contains_key(&row) {
        shared.send(Request::ShowRow { row }, false);
    }
}

fn train(state: &mut State, shared: &mut Shared) {
    if !state.can_train(shared) {
        return;
    }
    (state.notice, state.progress) = (None, None);
    shared.say(Text::of(shared.language).training_begun);
    // The page's own sentences are there to show that nouns and verbs are learned.
    let is_demo = state.corpus.as_ref().is_some_and(Corpus::is_demo);
    let lexicon = if is_demo { SeedLexicon::Demonstration } else { SeedLexicon::Domain };
    shared.send(Request::Train { lexicon, settings: SETTINGS }, true);
}
