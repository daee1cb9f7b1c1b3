//! The corpus that is open on the page: what the engine said of it, its files (sent again to a new engine),
//! and which of its rows are open.

use crate::worker::protocol::{CorpusFile, CorpusReport, PairText};
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// The name of the page's own corpus.
pub const DEMO_NAME: &str = "six.csv";

/// The page's own corpus: six sentences, each with states before and after.
pub const DEMO: &str = include_str!("../../../../assets/corpus/six.csv");

/// Corpora with so few rows are shown with all their pictures at once.
pub const SMALL: usize = 12;

/// So many rows are shown, and again so many for every "more".
pub const PAGE: usize = 50;

/// The open corpus.
#[derive(Clone, Debug, PartialEq)]
pub struct Corpus {
    /// What the engine read.
    pub report: Rc<CorpusReport>,
    /// The files.
    pub files: Rc<[CorpusFile]>,
    /// Whether rows that were rejected are used.
    pub with_rejected: bool,
    /// The demonstrations of rows that have been asked for.
    pub pairs: FxHashMap<usize, Rc<Vec<PairText>>>,
    /// The row whose demonstrations are all shown.
    pub open: Option<usize>,
    /// How many rows are shown.
    pub shown: usize,
}

impl Corpus {
    /// A corpus just read, with no row open.
    pub fn new(report: CorpusReport, files: Vec<CorpusFile>, with_rejected: bool) -> Corpus {
        let shown = report.rows.len().min(PAGE);
        Corpus {
            report: Rc::new(report),
            files: files.into(),
            with_rejected,
            pairs: FxHashMap::default(),
            open: None,
            shown,
        }
    }

    /// Whether this is the page's own corpus.
    pub fn is_demo(&self) -> bool {
        matches!(&*self.files, [only] if only.bytes == DEMO.as_bytes())
    }

    /// Shows more rows.
    pub fn more(&mut self) {
        self.shown = (self.shown + PAGE).min(self.report.rows.len());
    }
}
