//! Does what a person wants about experiments.

use super::action::{Action, Saved};
use super::hear;
use super::matrix::Kind;
use super::picture::picture;
use super::pool::Work;
use super::share::{Ground, begin, give_up, leave, run, tell};
use super::state::State;
use super::words::Text;
use crate::ui::page::files::Offered;
use crate::ui::page::world::{Choice, WORLDS};
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{By, Lexicon, Request, SeedLexicon, Settings, Split};
use std::rc::Rc;

/// The share that is held out for a table of the paper, where nothing is: of a hundred.
const SHARE: u32 = 20;

/// What the six sentences are followed by: a command that none of them says.
const NEVER_HEARD: &str = "go to the blue room";

/// Does what a person wants.
pub fn update(state: &mut State, desk: &mut Desk, action: Action, ground: &Ground) {
    match action {
        Action::Choose(kind) => state.kind = kind,
        Action::Folds(folds) => state.folds = folds,
        Action::By(by) => state.by = by,
        Action::Seeds(seeds) => state.seeds = seeds,
        Action::Go => plan(state, desk, state.kind, ground),
        Action::Paper(kind) => {
            if ground.held_out == 0 {
                let seed = ground.settings.seed;
                let split = Split::Share { by: By::Command, percent: SHARE, seed };
                desk.ask(Request::Divide { split });
            }
            plan(state, desk, kind, ground);
        }
        Action::Six => six(state, desk, ground),
        Action::Told(seat, said) => hear::told(state, desk, seat, said),
        Action::Stop => {
            leave(state, desk);
            give_up(state);
            let words = Text::of(desk.language).stopped.to_owned();
            tell(state, desk, words);
        }
        Action::Repeat(files) => {
            state.notice = None;
            if let Some(Offered { bytes: Ok(bytes), .. }) = files.into_iter().next() {
                run(state, desk, String::from_utf8_lossy(&bytes).into_owned(), ground);
            }
        }
        Action::Save(at, what) => save(state, desk, at, what),
        // It is forgotten where it is kept.
        Action::Forget(_) => {}
    }
}

fn plan(state: &mut State, desk: &mut Desk, kind: Kind, ground: &Ground) {
    state.notice = None;
    let by = By::ALL.get(state.by).map_or(By::Command, |(_, by)| *by);
    let matrix = kind.matrix(state.folds, by, state.seeds);
    desk.ask(Request::PlanRuns { matrix, settings: Box::new(ground.settings.clone()) });
}

/// The paper's Section VII: learns from six sentences, then is told what none of them says.
fn six(state: &mut State, desk: &mut Desk, ground: &Ground) {
    state.notice = None;
    let Some(Some(world)) = WORLDS.first().map(Choice::open) else { return };
    let lexicon = Lexicon::Here(SeedLexicon::Demonstration);
    let settings = Box::new(Settings { lexicon, ..ground.settings.clone() });
    let command = NEVER_HEARD.to_owned();
    let request = Box::new(Request::Demonstrate { command, state: world, settings });
    begin(state, desk, Work::One(request), 1, (Rc::from([ground.six.clone()]), false));
}

fn save(state: &State, desk: &mut Desk, at: usize, what: Saved) {
    let Some(found) = state.results.get(at) else { return };
    let (name, text) = match what {
        Saved::Csv => ("experiment.csv", found.joined.csv.clone()),
        Saved::Svg => ("experiment.svg", picture(&found.joined, Text::of(desk.language).f1)),
        Saved::Json => ("experiment.json", found.joined.results.clone()),
        Saved::Report => ("experiment.md", found.joined.markdown.clone()),
        Saved::Plan => ("runs.json", found.plan.clone()),
    };
    desk.want(Effect::Save { name: name.to_owned(), text });
}
