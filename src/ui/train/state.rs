//! The state of the Train page.

use super::corpus::Corpus;
use crate::ui::page::engine::Health;
use crate::ui::page::shared::Shared;
use crate::worker::protocol::{CorpusFile, Problem, Progress, Request, TrainSettings};

/// The paper's settings, which the page trains with.
pub const SETTINGS: TrainSettings =
    TrainSettings { epochs: 15, beam: 150, lexical_beam: 75, demonstrations: None, seed: 0 };

/// All that the Train page knows by itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// The corpus that is open.
    pub corpus: Option<Corpus>,
    /// What is wrong with the file that was opened last: words, and problems by line.
    pub file_notice: Option<FileNotice>,
    /// Bytes that are read and bytes in all, while files are read.
    pub reading: Option<(u64, u64)>,
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
    /// The files, where rows of them were rejected and may be used all the same.
    pub rejected: Vec<CorpusFile>,
}

impl FileNotice {
    /// A notice of words alone.
    pub fn of(message: String) -> FileNotice {
        FileNotice { message, problems: Vec::new(), rejected: Vec::new() }
    }
}

impl State {
    /// Whether training can begin.
    pub fn can_train(&self, shared: &Shared) -> bool {
        let rows = self.corpus.as_ref().map_or(0, |c| c.report.rows.len());
        rows > 0 && shared.learner.health == Health::Ready && !is_training(shared)
    }
}

/// Whether it is training, or will be as soon as it can.
pub fn is_training(shared: &Shared) -> bool {
    shared.learner.is_at(|request| matches!(request, Request::Train { .. }))
}
