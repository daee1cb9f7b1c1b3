//! The state of the corpus, and of the files that were opened.

use super::corpus::Corpus;
use crate::worker::protocol::{CorpusFile, Problem, SeedLexicon};

/// All that is known of the corpus.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// The corpus that is open.
    pub corpus: Option<Corpus>,
    /// What is wrong with the file that was opened last: words, and problems by line.
    pub file_notice: Option<FileNotice>,
    /// Bytes that are read and bytes in all, while files are read.
    pub reading: Option<(u64, u64)>,
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
    /// Commands of the corpus that is open.
    pub fn commands(&self) -> usize {
        self.corpus.as_ref().map_or(0, |corpus| corpus.report.rows.len())
    }

    /// What is known before it is learned from: the page's own sentences are there to show that nouns and verbs are
    /// learned.
    pub fn lexicon(&self) -> SeedLexicon {
        let is_demo = self.corpus.as_ref().is_some_and(Corpus::is_demo);
        if is_demo { SeedLexicon::Demonstration } else { SeedLexicon::Domain }
    }
}
