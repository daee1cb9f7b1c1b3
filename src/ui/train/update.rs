//! The workbench's reducer: an action changes the state, and what is to be done comes back. Pure, as the page's.

use super::action::Action;
use super::effect::Effect;
use super::state::State;
use super::{data, hear, run};
use crate::ui::page::engines;

/// Changes the state as the action says, and returns what is to be done.
pub fn reduce(state: &mut State, action: Action) -> Vec<Effect> {
    let State { desk, data, run, shown } = state;
    match action {
        Action::Data(action) => data::update::update(data, desk, action),
        Action::Run(action) => {
            run::update::update(run, desk, action, data.commands(), data.lexicon());
        }

        Action::Shown(now) => {
            *shown = now;
            if now {
                data::update::begin(data, desk);
            }
        }
        Action::Speak(language) => desk.language = language,
        Action::Prefers(preferences) => desk.preferences = preferences,
        Action::Uses(model) => desk.in_use = Some(model),
        Action::Notice(words) => desk.model_notice = words,

        Action::Heard(program, envelope) => {
            let news = engines::heard(desk, program, envelope);
            hear::told(state, news);
        }
        Action::EngineBroke(program, why) => {
            let news = engines::stopped(desk, program, why);
            hear::told(state, Some(news));
        }
        Action::RestartEngine(program) => {
            engines::restart(desk, program);
            data::update::restore(data, desk);
        }
        Action::Look(program, watch) => {
            let news = engines::look(desk, program, watch);
            hear::told(state, news);
        }
    }
    state.desk.take_wanted()
}
