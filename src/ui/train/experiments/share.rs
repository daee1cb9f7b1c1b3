//! Experiments are shared out: what they are on, how engines begin and end, and what is said when there is no result.

use super::pool::{Pool, Work};
use super::state::{Begun, State};
use super::words::Text;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{MappedFile, Settings};
use std::rc::Rc;

/// With fewer rows one engine has asked a model all of them before others have read the corpus.
const LEAST_ROWS: u32 = 200;

/// Parts of the commands that a model is asked: some more than engines, since none takes as long as another.
const PARTS: u32 = 12;

/// What experiments are on.
pub struct Ground {
    /// The files of the corpus that is open.
    pub files: Rc<[MappedFile]>,
    /// Whether its rejected rows are used.
    pub with_rejected: bool,
    /// Its rows.
    pub rows: u32,
    /// Rows of it that are held out.
    pub held_out: u32,
    /// The settings that runs have in common.
    pub settings: Settings,
    /// The page's own six sentences.
    pub six: MappedFile,
}

/// Runs all runs of a plan.
pub(super) fn run(state: &mut State, desk: &mut Desk, plan: String, ground: &Ground) {
    let Some(runs) = n_runs(&plan) else {
        let words = Text::of(desk.language).no_plan.to_owned();
        return tell(state, desk, words);
    };
    let on = (ground.files.clone(), ground.with_rejected);
    begin(state, desk, Work::Plan(plan.clone()), runs, on);
    give_up(state);
    state.begun.push(Begun { plan, name: String::new(), is_given_up: false });
}

/// Engines begin to share work out.
pub(super) fn begin(
    state: &mut State,
    desk: &mut Desk,
    work: Work,
    runs: u32,
    on: (Rc<[MappedFile]>, bool),
) {
    leave(state, desk);
    if !matches!(work, Work::Rows(_)) {
        desk.say(Text::of(desk.language).begun);
    }
    let mut errands = Vec::new();
    state.pool = Some(Pool::new(work, runs, desk.cores, on, &mut errands));
    for (seat, errand) in errands {
        desk.want(Effect::Pool(seat, errand));
    }
}

/// Has a model be asked every row by several engines; whether that helps.
pub(in crate::ui::train) fn ask(state: &mut State, desk: &mut Desk, ground: &Ground) -> bool {
    let Some(model) = &desk.in_use else { return false };
    if desk.cores < 2 || ground.rows < LEAST_ROWS || state.pool.is_some() {
        return false;
    }
    let work = Work::Rows(model.report.model.clone());
    begin(state, desk, work, PARTS, (ground.files.clone(), ground.with_rejected));
    true
}

/// Ends the engines at work.
pub(in crate::ui::train) fn leave(state: &mut State, desk: &mut Desk) {
    if state.pool.take().is_some() {
        desk.want(Effect::EndPool);
    }
}

/// What was begun is given up.
pub(super) fn give_up(state: &mut State) {
    state.begun.iter_mut().for_each(|begun| begun.is_given_up = true);
}

/// How many runs a plan has; nothing when it is none.
fn n_runs(plan: &str) -> Option<u32> {
    let plan: serde_json::Value = serde_json::from_str(plan).ok()?;
    u32::try_from(plan.get("runs")?.as_array()?.len()).ok().filter(|runs| *runs > 0)
}

/// Says what came of an experiment, when it is no result.
pub(super) fn tell(state: &mut State, desk: &mut Desk, words: String) {
    desk.say(words.clone());
    state.notice = Some(words);
}
