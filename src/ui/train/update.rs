//! The workbench's reducer: an action changes the state, and what is to be done comes back. Pure, as the page's.

use super::action::{Action, Tab};
use super::desk::Desk;
use super::effect::Effect;
use super::restart::restart;
use super::run::update::Ground;
use super::state::State;
use super::{data, experiments, hear, keeping, lexicon, returning, run, study};
use crate::ui::page::engines;

/// Changes the state as the action says, and returns what is to be done.
pub fn reduce(state: &mut State, action: Action) -> Vec<Effect> {
    let mut action = action;
    if let Action::Data(data::Action::Offered(files)) = &mut action {
        returning::take(state, files);
    }
    let State { desk, shown, tab, data, run, lexicon, .. } = state;
    match action {
        Action::Data(data::Action::Care(data::action::Care::Audit)) => audit(state),
        Action::Data(action) => {
            if action == data::Action::Stop {
                stop_audit(&mut state.experiments, data, desk);
            }
            if data::update::update(data, desk, action) {
                *tab = Tab::Data;
            }
        }
        Action::Run(action) => {
            let sheet = data.sheet.as_ref();
            let name = sheet.map_or(String::new(), |sheet| sheet.name.clone());
            let pack = sheet.map_or(String::new(), |sheet| sheet.pack());
            let seen = *shown && *tab == Tab::Run;
            let ground =
                Ground { name, pack, commands: data.commands(), lexicon: data.lexicon(), seen };
            run::update::update(run, desk, action, ground);
        }

        Action::Experiments(experiments::Action::Forget(at)) => keeping::forget(state, at),
        Action::Experiments(action) => {
            let ground = state.ground();
            let State { experiments, desk, data, .. } = state;
            let was_asking = experiments.asking().is_some();
            if experiments.asking().is_some_and(|pool| !pool.is_on(&ground.files)) {
                experiments::share::leave(experiments, desk);
            }
            experiments::update::update(experiments, desk, action, &ground);
            match experiments.asking() {
                Some(pool) => data.auditing = Some((pool.rows(), ground.rows)),
                None if was_asking && !desk.is_auditing() => data.auditing = None,
                None => {}
            }
        }
        Action::Lexicon(lexicon::Action::Row(row)) => {
            data::update::update(data, desk, data::Action::Look(data::action::Look::Row(row)));
            *tab = Tab::Data;
        }
        Action::Lexicon(action) => lexicon::update::update(lexicon, desk, action),
        Action::Study(action) => study::update::update(&mut state.study, desk, action),
        Action::Kept(action) => keeping::update(state, action),

        Action::Turn(to) => {
            *tab = to;
            if to == Tab::Lexicon {
                lexicon::update::update(lexicon, desk, lexicon::Action::Shown);
            }
        }
        Action::Shown(now) => {
            *shown = now;
            if now {
                data::update::begin(data, desk);
                keeping::begin(state);
            }
        }
        Action::Speak(language) => desk.language = language,
        Action::Cores(cores) => desk.cores = cores,
        Action::Prefers(preferences) => desk.preferences = preferences,
        Action::Uses(model) => {
            desk.in_use = Some(model);
            if lexicon.is_robots {
                lexicon::update::give(desk);
            }
        }
        Action::Notice(words) => desk.model_notice = words,

        Action::Heard(program, envelope) => {
            let news = engines::heard(desk, program, envelope);
            hear::told(state, news);
        }
        Action::EngineBroke(program, why) => {
            let news = engines::stopped(desk, program, why);
            hear::told(state, Some(news));
        }
        Action::RestartEngine(program) => restart(state, program),
        Action::Look(program, watch) => {
            let news = engines::look(desk, program, watch);
            hear::told(state, news);
        }
    }
    keeping::look(state);
    state.desk.take_wanted()
}

/// The robot's model is asked every row: by several engines where that helps.
fn audit(state: &mut State) {
    let ground = state.ground();
    let State { desk, data, experiments, .. } = state;
    if experiments::share::ask(experiments, desk, &ground) {
        data.auditing = Some((0, ground.rows));
    } else {
        let audit = data::Action::Care(data::action::Care::Audit);
        data::update::update(data, desk, audit);
    }
}

/// The model is not asked any more, if several engines are at that.
fn stop_audit(experiments: &mut experiments::State, data: &mut data::State, desk: &mut Desk) {
    if experiments.asking().is_some() {
        experiments::share::leave(experiments, desk);
        data.auditing = None;
    }
}
