//! The state of the corpus, and of the files that were opened.

use super::mapping::Desk as Columns;
use super::sheet::Sheet;
use crate::worker::protocol::{CorpusFile, Fault, FileReport, Lexicon, MappedFile, SeedLexicon};
use std::rc::Rc;

/// All that is known of the corpus.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// The corpus that is open.
    pub sheet: Option<Sheet>,
    /// What is wrong with the files that were opened last.
    pub refused: Option<Refused>,
    /// Bytes that are read and bytes in all, while files are read.
    pub reading: Option<(u64, u64)>,
    /// Rows that are judged and rows in all, while a model is asked about them.
    pub auditing: Option<(u32, u32)>,
    /// Columns that are mapped by hand.
    pub columns: Option<Columns>,
    /// Files whose columns are to be mapped, until it is known what they begin with.
    pub to_map: Rc<[CorpusFile]>,
}

/// What is wrong with files that were offered.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Refused {
    /// In words.
    pub message: String,
    /// By file.
    pub reports: Vec<FileReport>,
    /// By line and column.
    pub faults: Vec<Fault>,
    /// The files, as far as they could be read.
    pub files: Vec<MappedFile>,
}

impl Refused {
    /// Words alone.
    pub fn of(message: String) -> Refused {
        Refused { message, ..Refused::default() }
    }

    /// Whether their columns may be mapped by hand.
    pub fn can_be_mapped(&self) -> bool {
        !self.files.is_empty()
    }
}

impl State {
    /// Commands that are learned from.
    pub fn commands(&self) -> usize {
        self.sheet.as_ref().map_or(0, |sheet| sheet.care.train as usize)
    }

    /// Commands that are held out.
    pub fn held_out(&self) -> u32 {
        self.sheet.as_ref().map_or(0, |sheet| sheet.care.held_out)
    }

    /// What is known before it is learned from, unless a person says otherwise: the page's own sentences are there to
    /// show that nouns and verbs are learned.
    pub fn lexicon(&self) -> Lexicon {
        let is_demo = self.sheet.as_ref().is_some_and(Sheet::is_demo);
        Lexicon::Here(if is_demo { SeedLexicon::Demonstration } else { SeedLexicon::Domain })
    }
}
