//! The corpus that is open: what the engine said of it, its files (sent again to a new engine, with all that was done
//! since), and what of it is looked at.

use super::demo;
use super::table::Table;
use crate::worker::protocol::{
    Care, Facets, Fault, MappedFile, Request, RowReading, SheetReport, Shown,
};
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// Corpora with so few rows are shown with a picture each.
pub const SMALL: u32 = 12;

/// The open corpus.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The names of its files.
    pub name: String,
    /// The files.
    pub files: Rc<[MappedFile]>,
    /// Whether rows that were rejected are used.
    pub with_rejected: bool,
    /// What came of reading it.
    pub report: Rc<SheetReport>,
    /// How it stands.
    pub care: Care,
    /// What there is to filter by.
    pub facets: Rc<Facets>,
    /// The rows that are looked at.
    pub table: Table,
    /// The row that is open.
    pub open: Option<Open>,
    /// The first demonstrations of a small corpus, by row.
    pub pairs: FxHashMap<u32, Rc<Vec<Shown>>>,
    /// What was done to it, in order: an engine that begins anew is asked all of it again.
    pub log: Rc<Vec<Request>>,
    /// Whether a model was asked about all rows.
    pub is_audited: bool,
}

/// A row that is open.
#[derive(Clone, Debug, PartialEq)]
pub struct Open {
    /// The row.
    pub row: u32,
    /// Its demonstrations, once they are known.
    pub pairs: Option<Rc<Vec<Shown>>>,
    /// What the model makes of it, once that is known.
    pub reading: Option<Rc<RowReading>>,
}

impl Sheet {
    /// A corpus just read, with no row open.
    pub fn new(report: SheetReport, files: Vec<MappedFile>, with_rejected: bool) -> Sheet {
        let names: Vec<&str> = files.iter().map(|one| one.file.name.as_str()).collect();
        Sheet {
            name: names.join(", "),
            files: files.into(),
            with_rejected,
            care: report.care.clone(),
            report: Rc::new(report),
            facets: Rc::default(),
            table: Table::new(),
            open: None,
            pairs: FxHashMap::default(),
            log: Rc::default(),
            is_audited: false,
        }
    }

    /// The name that it is kept under unless a person gives it one: its own, and the beginning of its fingerprint, since
    /// files of one name may differ.
    pub fn pack(&self) -> String {
        let sum: String = self.report.corpus.chars().take(8).collect();
        format!("{} {sum}", self.name)
    }

    /// Whether this is the page's own corpus.
    pub fn is_demo(&self) -> bool {
        matches!(&*self.files, [only] if *only.file.bytes == demo::TEXT.as_bytes())
    }

    /// Whether it is the page's own corpus, and nothing was done to it.
    pub fn is_untouched(&self) -> bool {
        self.is_demo() && self.log.is_empty()
    }

    /// Whether every row is shown with a picture.
    pub fn is_small(&self) -> bool {
        self.care.rows <= SMALL
    }

    /// Rows left out because something is wrong with them.
    pub fn left_out(&self) -> u32 {
        self.report.files.iter().map(|file| file.left_out).sum()
    }

    /// What is wrong with its files.
    pub fn faults(&self) -> &[Fault] {
        &self.report.faults
    }
}
