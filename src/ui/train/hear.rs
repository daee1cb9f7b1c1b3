//! What the engine says to the workbench: each message goes to the part that asked.

use super::action::Tab;
use super::restart::restart;
use super::state::State;
use super::{data, experiments, keeping, lexicon, run, study};
use crate::ui::page::engines::News;
use crate::worker::protocol::{Event, Program, Request};

/// There is news of an engine, or none.
pub(super) fn told(state: &mut State, news: Option<News>) {
    let State { desk, tab, data, run, lexicon, study, .. } = state;
    match news {
        Some(News::Progress(
            event @ (Event::Progress(_) | Event::HeldOut { .. } | Event::Paused),
        )) => run::hear::progressed(run, desk, event),
        Some(News::Progress(Event::Study(said))) => study::hear::progressed(study, &said),
        Some(News::Progress(event)) => data::hear::progressed(data, &event),
        Some(News::Answer(Request::Learn { .. }, event)) => {
            run::hear::ended(run, desk, event);
            state.kept.came_back = None;
            learned(state);
        }
        Some(News::Answer(Request::Recall { .. }, _)) => learned(state),
        Some(News::Answer(Request::Look | Request::Checkpoint | Request::ModelSoFar, event)) => {
            run::hear::answered(run, desk, event)
        }
        Some(News::Answer(Request::Decisions, event)) => {
            if let Event::Decisions { text } = &event {
                keeping::decided(state, text);
            }
            let State { desk, run, .. } = state;
            run::hear::answered(run, desk, event);
        }
        Some(News::Answer(
            request @ (Request::PlanRuns { .. } | Request::JoinRuns { .. }),
            event,
        )) => {
            let ground = state.ground();
            let State { desk, experiments, .. } = state;
            experiments::hear::answered(experiments, desk, request, event, &ground);
        }
        Some(News::Answer(
            request @ (Request::Entries { .. }
            | Request::Errors
            | Request::Without { .. }
            | Request::KeepModel { .. }
            | Request::Compare { .. }),
            event,
        )) => lexicon::hear::answered(lexicon, desk, &request, event),
        Some(News::Answer(Request::Study(ask), event)) => {
            if let Some(corpus) = study::hear::answered(study, desk, ask, event) {
                data::update::update(data, desk, data::Action::Offered(vec![corpus]));
                *tab = Tab::Data;
            }
        }
        Some(News::Answer(request, event)) => data::hear::answered(data, desk, request, event),
        Some(News::Stopped) => {
            (data.reading, data.auditing) = (None, None);
            (study.making, study.bringing, study.judging) = (None, None, None);
            if run::update::retry(run) {
                restart(state, Program::Learner);
            }
        }
        None => {}
    }
}

/// The engine knows something else by now: what was learned is looked at anew, if it is to be seen.
fn learned(State { desk, lexicon, tab, .. }: &mut State) {
    if *tab == Tab::Lexicon {
        lexicon::update::update(lexicon, desk, lexicon::Action::Shown);
    }
}
