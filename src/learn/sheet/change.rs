//! Changes of a sheet as data: what was done to which rows, and what was there before, so that it is undone and done
//! again.

use super::row::Half;
use crate::corpus::Decision;
use serde::{Deserialize, Serialize};

/// The most changes that can be undone.
const MOST: usize = 100;

/// What is decided of rows.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// They are good.
    Approve,
    /// They are not to be used, and why.
    Reject(String),
    /// Nothing: as if nobody had looked at them.
    Reopen,
    /// They are in this half.
    Put(Half),
}

/// What was done, for words about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "the names say it")]
pub enum Deed {
    Approve,
    Reject,
    Reopen,
    Put(Half),
    Split,
}

/// What was done, and to how many rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Done {
    pub deed: Deed,
    pub rows: u32,
}

/// The rows that a change touched, with what was there before, or is there after it was undone.
#[derive(Clone, Debug)]
pub(super) enum Before {
    Decisions(Vec<(u32, Decision)>),
    Halves(Vec<(u32, Half)>),
}

#[derive(Clone, Debug)]
struct Change {
    done: Done,
    before: Before,
}

/// What was done and what was undone.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    past: Vec<Change>,
    future: Vec<Change>,
}

impl History {
    /// Something was done; if that touched rows, nothing can be done again from now on.
    pub(super) fn add(&mut self, deed: Deed, before: Before) -> Option<Done> {
        let rows = match &before {
            Before::Decisions(rows) => rows.len(),
            Before::Halves(rows) => rows.len(),
        };
        if rows == 0 {
            return None;
        }
        let done = Done { deed, rows: rows as u32 };
        self.future.clear();
        self.past.push(Change { done, before });
        if self.past.len() > MOST {
            self.past.remove(0);
        }
        Some(done)
    }

    /// What can be undone, and what done again.
    pub(super) fn next(&self) -> [Option<Done>; 2] {
        [&self.past, &self.future].map(|changes| changes.last().map(|change| change.done))
    }

    /// Undoes the last change, or does again what was undone last. `exchange` puts back what was there before and gives
    /// what it found.
    pub(super) fn turn(
        &mut self,
        back: bool,
        exchange: impl FnOnce(Before) -> Before,
    ) -> Option<Done> {
        let [from, to] = match back {
            true => [&mut self.past, &mut self.future],
            false => [&mut self.future, &mut self.past],
        };
        let Change { done, before } = from.pop()?;
        to.push(Change { done, before: exchange(before) });
        Some(done)
    }
}
