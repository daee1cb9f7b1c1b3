//! The workbench: a corpus is opened and looked at, a parser is trained on it.

use super::action::{Action, Effect};
use super::corpus::{Corpus, DEMO, DEMO_NAME, SMALL};
use super::files::{self, Kind};
use super::state::State;
use super::{model, share};
use crate::worker::protocol::{
    CorpusReport, PairText, Problem, Program, Progress, Request, SeedLexicon, TrainSettings,
};
use std::rc::Rc;

/// The paper's settings, which the page trains with.
pub const SETTINGS: TrainSettings =
    TrainSettings { epochs: 15, beam: 150, lexical_beam: 75, demonstrations: None, seed: 0 };

/// The training side of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Train {
    /// The corpus that is open.
    pub corpus: Option<Corpus>,
    /// What is wrong with the file that was opened last: words, and problems by line.
    pub file_notice: Option<FileNotice>,
    /// How far training is, while it runs.
    pub progress: Option<Progress>,
    /// What came of training, when it is not a model.
    pub notice: Option<String>,
}

/// What is wrong with a file that was offered.
#[derive(Clone, Debug, PartialEq)]
pub struct FileNotice {
    /// In words.
    pub message: String,
    /// By line and column.
    pub problems: Vec<Problem>,
}

/// What is trained.
pub(super) fn act(state: &mut State, action: Action, effects: &mut Vec<Effect>) {
    match action {
        Action::FileRead { name, text } => match files::kind(&name, &text) {
            Kind::Corpus => {
                read_corpus(state, name, text, effects);
                state.view = super::action::View::Train;
            }
            Kind::Model => model::open_file(state, text, effects),
            Kind::Session => share::act(state, Action::LinkOpened(Ok(text)), effects),
        },
        Action::FileRefused(name, fault) => {
            let message = (state.text().file_fault)(&name, fault);
            state.say(message.clone());
            state.train.file_notice = Some(FileNotice { message, problems: Vec::new() });
            state.view = super::action::View::Train;
        }
        Action::OpenDemo => read_corpus(state, DEMO_NAME.to_owned(), DEMO.to_owned(), effects),
        Action::ToggleRow(row) => toggle_row(state, row, effects),
        Action::MoreRows => state.train.corpus.iter_mut().for_each(Corpus::more),
        Action::SaveCorpus => effects.extend(state.train.corpus.as_ref().map(|corpus| {
            Effect::Save { name: corpus.report.name.clone(), text: corpus.text.to_string() }
        })),
        Action::Train if state.can_train() => {
            (state.train.notice, state.train.progress) = (None, None);
            let words = state.text().training_begun;
            state.say(words);
            let is_demo = state.train.corpus.as_ref().is_some_and(Corpus::is_demo);
            let train = Request::Train { lexicon: lexicon(is_demo), settings: SETTINGS };
            state.learner.send(train, true, effects);
        }
        Action::CancelTraining => {
            state.learner.retain(|request| !matches!(request, Request::Train { .. }));
            if state.learner.is_at(|request| matches!(request, Request::Train { .. })) {
                state.stop_at(Program::Learner, effects);
            }
        }
        Action::SaveModel => effects.extend(state.document.model.as_ref().map(|model| {
            Effect::Save { name: "groundling.model".to_owned(), text: model.report.model.clone() }
        })),
        _ => {}
    }
}

/// The page's own sentences are there to show that nouns and verbs are learned.
fn lexicon(is_demo: bool) -> SeedLexicon {
    if is_demo { SeedLexicon::Demonstration } else { SeedLexicon::Domain }
}

/// Gives the engine a corpus to read.
pub(super) fn read_corpus(
    state: &mut State,
    name: String,
    text: String,
    effects: &mut Vec<Effect>,
) {
    state.train.file_notice = None;
    state.learner.retain(|r| !matches!(r, Request::ShowRow { .. } | Request::ReadCorpus { .. }));
    state.learner.send(Request::ReadCorpus { name, text }, false, effects);
}

/// The view was opened: it begins with the page's own sentences.
pub(super) fn begin(state: &mut State, effects: &mut Vec<Effect>) {
    let reads = |request: &Request| matches!(request, Request::ReadCorpus { .. });
    if state.train.corpus.is_none() && !state.learner.is_at(reads) {
        read_corpus(state, DEMO_NAME.to_owned(), DEMO.to_owned(), effects);
    }
}

/// The engine that learns began anew: it knows no corpus.
pub(super) fn restore(state: &mut State, effects: &mut Vec<Effect>) {
    if let Some(corpus) = &state.train.corpus {
        let (name, text) = (corpus.report.name.clone(), corpus.text.to_string());
        state.learner.send(Request::ReadCorpus { name, text }, false, effects);
    }
}

/// A corpus was read.
pub(super) fn opened(
    state: &mut State,
    report: CorpusReport,
    text: String,
    effects: &mut Vec<Effect>,
) {
    let words = state.text();
    if report.rows.is_empty() {
        let message = (words.no_rows)(&report.name);
        state.say(message.clone());
        state.train.file_notice = Some(FileNotice { message, problems: report.problems });
        return;
    }
    state.say((words.corpus_open)(&report.name, report.rows.len()));
    state.train.file_notice = None;
    let corpus = Corpus::new(report, text);
    let small = corpus.report.rows.len();
    state.train.corpus = Some(corpus);
    if small <= SMALL {
        for row in 0..small {
            state.learner.send(Request::ShowRow { row }, false, effects);
        }
    }
}

/// A row's demonstrations have come.
pub(super) fn shown(state: &mut State, row: usize, pairs: Vec<PairText>) {
    if let Some(corpus) = &mut state.train.corpus {
        corpus.pairs.insert(row, Rc::new(pairs));
    }
}

fn toggle_row(state: &mut State, row: usize, effects: &mut Vec<Effect>) {
    let Some(corpus) = &mut state.train.corpus else { return };
    corpus.open = (corpus.open != Some(row)).then_some(row);
    if corpus.open.is_some() && !corpus.pairs.contains_key(&row) {
        state.learner.send(Request::ShowRow { row }, false, effects);
    }
}
