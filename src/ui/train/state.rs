//! The state of the workbench: what its parts share, and each part's own.

use super::action::Tab;
use super::desk::Desk;
use super::{data, experiments, kept, lexicon, run, study};
use crate::worker::protocol::Confused;
use std::rc::Rc;

/// All that the workbench knows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// What the parts are lent.
    pub desk: Desk,
    /// Whether it is to be seen.
    pub shown: bool,
    /// The part that is seen.
    pub tab: Tab,
    /// The corpus.
    pub data: data::State,
    /// Training.
    pub run: run::State,
    /// Experiments.
    pub experiments: experiments::State,
    /// What was learned.
    pub lexicon: lexicon::State,
    /// Studies.
    pub study: study::State,
    /// What is kept.
    pub kept: kept::State,
}

impl State {
    /// What experiments are on.
    pub fn ground(&self) -> experiments::share::Ground {
        let sheet = self.data.sheet.as_ref();
        experiments::share::Ground {
            files: sheet.map_or_else(|| Rc::from([]), |sheet| sheet.files.clone()),
            with_rejected: sheet.is_some_and(|sheet| sheet.with_rejected),
            rows: sheet.map_or(0, |sheet| sheet.care.rows),
            held_out: self.data.held_out(),
            settings: self.run.settings(self.data.lexicon()),
            six: data::demo::file(),
        }
    }

    /// What wrong answers to what is held out did instead, of the last model that was judged on it.
    pub fn confused(&self) -> &[Confused] {
        let points = self.run.run.as_ref().map(|run| &run.points[..]).unwrap_or_default();
        let last = points.iter().rev().find_map(|point| point.judgement.as_ref());
        last.map(|judgement| &judgement.confusion[..]).unwrap_or_default()
    }
}
