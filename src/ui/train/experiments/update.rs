//! Does what a person wants about experiments.

use super::action::{Action, Saved};
use super::state::{State, is_running};
use super::words::Text;
use crate::ui::page::files::Offered;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{By, Request, Settings};

/// Does what a person wants, with the settings that runs have in common.
pub fn update(state: &mut State, desk: &mut Desk, action: Action, settings: Settings) {
    match action {
        Action::Choose(kind) => state.kind = kind,
        Action::Folds(folds) => state.folds = folds,
        Action::By(by) => state.by = by,
        Action::Seeds(seeds) => state.seeds = seeds,
        Action::Go => {
            state.notice = None;
            let by = By::ALL.get(state.by).map_or(By::Command, |(_, by)| *by);
            let matrix = state.kind.matrix(state.folds, by, state.seeds);
            desk.ask(Request::PlanRuns { matrix, settings: Box::new(settings) });
        }
        Action::Stop => {
            desk.learner.retain(|request| !matches!(request, Request::RunShard { .. }));
            if is_running(desk) {
                desk.cancel();
            }
        }
        Action::Repeat(files) => repeat(state, desk, files),
        Action::Save(at, what) => save(state, desk, at, what),
        Action::Forget(at) => {
            if at < state.results.len() {
                state.results.remove(at);
            }
        }
    }
}

/// Runs all runs of a plan.
pub fn run(state: &mut State, desk: &mut Desk, plan: String) {
    let Some(runs) = n_runs(&plan) else {
        let words = Text::of(desk.language).no_plan.to_owned();
        desk.say(words.clone());
        state.notice = Some(words);
        return;
    };
    desk.say(Text::of(desk.language).begun);
    desk.send(Request::RunShard { plan, runs: (0..runs).collect() }, false);
}

fn repeat(state: &mut State, desk: &mut Desk, files: Vec<Offered>) {
    state.notice = None;
    if let Some(Offered { bytes: Ok(bytes), .. }) = files.into_iter().next() {
        run(state, desk, String::from_utf8_lossy(&bytes).into_owned());
    }
}

/// How many runs a plan has; nothing when it is none.
fn n_runs(plan: &str) -> Option<u32> {
    let plan: serde_json::Value = serde_json::from_str(plan).ok()?;
    u32::try_from(plan.get("runs")?.as_array()?.len()).ok().filter(|runs| *runs > 0)
}

fn save(state: &State, desk: &mut Desk, at: usize, what: Saved) {
    let Some(found) = state.results.get(at) else { return };
    let (name, text) = match what {
        Saved::Csv => ("experiment.csv", &found.joined.csv),
        Saved::Json => ("experiment.json", &found.joined.results),
        Saved::Report => ("experiment.md", &found.joined.markdown),
        Saved::Plan => ("runs.json", &found.plan),
    };
    desk.want(Effect::Save { name: name.to_owned(), text: text.clone() });
}
