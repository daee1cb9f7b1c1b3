//! Which column of a file says what, chosen by a person who sees the file's first rows.

use crate::worker::protocol::{CorpusFile, MappedFile, Mapping, Preview, States};
use std::rc::Rc;

/// The most demonstrations that can be mapped by hand.
pub const MOST_PAIRS: usize = 12;

/// What a column can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(
    missing_docs,
    reason = "as of `Mapping`; states by the number of their demonstration, from 1"
)]
pub enum Column {
    Unused,
    Command,
    Task,
    Worker,
    Id,
    Status,
    Approve,
    Reject,
    Before(usize),
    After(usize),
}

impl Column {
    /// All that a column can be, with so many demonstrations.
    pub fn all(pairs: usize) -> Vec<Column> {
        let states = (1..=pairs).flat_map(|n| [Column::Before(n), Column::After(n)]);
        let single = [
            Column::Unused,
            Column::Command,
            Column::Task,
            Column::Worker,
            Column::Id,
            Column::Status,
            Column::Approve,
            Column::Reject,
        ];
        single.into_iter().chain(states).collect()
    }
}

/// Columns that are being mapped.
#[derive(Clone, Debug, PartialEq)]
pub struct Desk {
    /// The files, all of which are mapped alike.
    pub files: Rc<[CorpusFile]>,
    /// What the first of them begins with, once it is known.
    pub preview: Rc<Preview>,
    /// What each of its columns is.
    pub columns: Vec<Column>,
}

impl Desk {
    /// A file's columns as they seem to be.
    pub fn new(files: Rc<[CorpusFile]>, preview: Preview) -> Desk {
        let columns = of(&preview.columns, &preview.proposal);
        Desk { files, preview: Rc::new(preview), columns }
    }

    /// A column is this; no two are the same.
    pub fn choose(&mut self, at: usize, column: Column) {
        if column != Column::Unused {
            let others = self.columns.iter_mut().filter(|other| **other == column);
            others.for_each(|other| *other = Column::Unused);
        }
        if let Some(one) = self.columns.get_mut(at) {
            *one = column;
        }
    }

    /// The mapping of a file is used, as far as the columns are there.
    pub fn take(&mut self, mapping: &Mapping) {
        self.columns = of(&self.preview.columns, mapping);
    }

    /// How many demonstrations can be chosen: one more than there are.
    pub fn pairs(&self) -> usize {
        let number = |column: &Column| match column {
            Column::Before(n) | Column::After(n) => *n,
            _ => 0,
        };
        let most = self.columns.iter().map(number).max().unwrap_or(0);
        (most + 1).min(MOST_PAIRS)
    }

    /// The mapping as it is chosen: demonstrations of which one state is missing are none.
    pub fn mapping(&self) -> Mapping {
        let named = |wanted: Column| {
            let at = self.columns.iter().position(|column| *column == wanted)?;
            self.preview.columns.get(at).cloned()
        };
        let pair =
            |n| Some(States { pre: named(Column::Before(n))?, post: named(Column::After(n))? });
        Mapping {
            command: named(Column::Command),
            task: named(Column::Task),
            worker: named(Column::Worker),
            id: named(Column::Id),
            status: named(Column::Status),
            approve: named(Column::Approve),
            reject: named(Column::Reject),
            pairs: (1..=MOST_PAIRS).filter_map(pair).collect(),
        }
    }

    /// The files with their mapping.
    pub fn mapped(&self) -> Vec<MappedFile> {
        let mapping = self.mapping();
        let mapped =
            |file: &CorpusFile| MappedFile { file: file.clone(), mapping: mapping.clone() };
        self.files.iter().map(mapped).collect()
    }
}

/// What columns of these names are in a mapping.
fn of(names: &[String], mapping: &Mapping) -> Vec<Column> {
    let Mapping { command, task, worker, id, status, approve, reject, pairs } = mapping;
    let single = [
        (command, Column::Command),
        (task, Column::Task),
        (worker, Column::Worker),
        (id, Column::Id),
        (status, Column::Status),
        (approve, Column::Approve),
        (reject, Column::Reject),
    ];
    let column = |name: &String| {
        let found = single.iter().find(|(own, _)| own.as_ref() == Some(name)).map(|(_, it)| *it);
        let state = || {
            (1..).zip(pairs).find_map(|(n, States { pre, post })| match name {
                _ if name == pre => Some(Column::Before(n)),
                _ if name == post => Some(Column::After(n)),
                _ => None,
            })
        };
        found.or_else(state).unwrap_or(Column::Unused)
    };
    names.iter().map(column).collect()
}
