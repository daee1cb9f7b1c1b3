//! The one reducer: an action changes the state, and what is to be done comes back. Pure: no browser, no clock but
//! what the caller says. Nothing that is loaded is lost but by being replaced with a good one.

use super::action::Action;
use super::state::State;
use super::words::Text;
use super::{bench, hear};
use crate::ui::page::document::Document;
use crate::ui::page::effect::{Effect, Timer};
use crate::ui::page::history::History;
use crate::ui::page::words::Text as Common;
use crate::ui::page::{engines, model, resource};
use crate::ui::talk;
use crate::ui::talk::command::examples;
use crate::worker::protocol::Program;

/// Changes the state as the action says, and returns what is to be done.
pub fn reduce(state: &mut State, action: Action) -> Vec<Effect> {
    let State { shared, talk, .. } = state;
    match action {
        Action::Talk(action) => talk::update::update(talk, shared, action),

        Action::Opened(language) => {
            shared.language = language;
            shared.wake(Program::Talker);
            shared.want(Effect::FetchModel);
            shared.want(Effect::SetLanguage(language));
            shared.want(Effect::Focus("command"));
        }
        Action::Prefers(preferences) => shared.preferences = preferences,
        Action::Go(to) => bench::go(state, to),
        Action::Deepen(depth) => {
            shared.depth = depth;
            talk::update::deepened(talk, shared);
        }
        Action::Speak(language) => {
            shared.language = language;
            shared.want(Effect::SetLanguage(language));
        }
        Action::Undo => travel(state, History::undo, |text| text.undone),
        Action::Redo => travel(state, History::redo, |text| text.redone),
        Action::Given(given) => bench::give(state, given),
        Action::Loaded(came) => bench::loaded(state, came),
        Action::Bench(news) => bench::told(state, news),
        Action::Copied(well) => {
            let text = Common::of(shared.language);
            shared.say(if well { text.copied } else { text.not_copied });
        }

        Action::Heard(program, envelope) => hear::heard(state, program, envelope),
        Action::EngineBroke(program, why) => {
            let news = engines::stopped(shared, program, why);
            hear::told(state, Some(news));
        }
        Action::RestartEngine(program) => hear::restart(state, program),
        Action::Rang(Timer::Watch(program, watch)) => {
            let news = engines::look(shared, program, watch);
            hear::told(state, news);
        }
        Action::Rang(Timer::Examples(number)) => examples::rang(talk, shared, number),
        Action::Rang(Timer::Demo(number)) => talk::demo::run::rang(talk, shared, number),
        Action::Rang(Timer::Play(play)) => talk::watch::play::rang(talk, shared, play),
        Action::Fetched(text) => model::fetched(shared, text),
        Action::FetchedWords(text) => {
            if resource::fetched(shared, text) {
                talk::hear::can_hear(talk, shared);
            }
        }
    }
    talk::demo::run::begin(&mut state.talk, &mut state.shared);
    examples::keep_up(&mut state.talk, &mut state.shared);
    state.shared.take_wanted()
}

/// Goes through the history: the document becomes another, and what hangs on it is brought along.
fn travel(
    state: &mut State,
    step: fn(&mut History<Document>, &mut Document) -> bool,
    words: fn(&Text) -> &str,
) {
    let State { shared, talk, .. } = state;
    talk.settle(shared);
    let before = shared.document.model.clone();
    if !step(&mut shared.history, &mut shared.document) {
        return;
    }
    if shared.document.model != before
        && let Some(model) = shared.document.model.clone()
    {
        model::go_on_with(shared, model);
    }
    talk::update::travelled(talk, shared, words(Text::of(shared.language)));
}
