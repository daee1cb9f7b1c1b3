//! The model that commands are read with: the one that comes with the page, one from a file, one that was trained
//! here; and what it was taught on top.

use super::action::Effect;
use super::document::{Model, Origin};
use super::state::State;
use super::{share, talk, teach};
use crate::worker::protocol::{Request, TrainReport};
use std::rc::Rc;

/// The model that comes with the page has come, or has not.
pub(super) fn fetched(state: &mut State, text: Result<String, String>, effects: &mut Vec<Effect>) {
    match text {
        Ok(text) if state.document.base.is_none() => {
            state.opening = Origin::Shipped;
            state.talker.send(Request::OpenModel { text }, true, effects);
        }
        Ok(_) => {}
        Err(why) => {
            let words = (state.text().no_model)(&why);
            state.say(words.clone());
            state.model_notice = Some(words);
        }
    }
}

/// Opens a model file.
pub(super) fn open_file(state: &mut State, text: String, effects: &mut Vec<Effect>) {
    state.model_notice = None;
    state.opening = Origin::File;
    state.talker.send(Request::OpenModel { text }, true, effects);
}

/// Goes on with this model: the engine that answers is given it.
pub(super) fn go_on_with(state: &mut State, model: Model, effects: &mut Vec<Effect>) {
    let text = model.report.model.clone();
    state.document.model = Some(model);
    state.talker.send(Request::OpenModel { text }, true, effects);
}

/// A model was trained here.
pub(super) fn trained(
    state: &mut State,
    report: TrainReport,
    corpus: String,
    effects: &mut Vec<Effect>,
) {
    state.record();
    let model = Model { report: Rc::new(report), origin: Origin::Trained(corpus) };
    state.document.base = Some(model.clone());
    if !learn_again(state, effects) {
        go_on_with(state, model, effects);
    }
}

/// The engine that answers has opened a model.
pub(super) fn opened(
    state: &mut State,
    text: &str,
    report: TrainReport,
    effects: &mut Vec<Effect>,
) {
    state.model_notice = None;
    let is_known = state.document.model.as_ref().is_some_and(|model| model.report.model == text);
    if !is_known {
        let origin = std::mem::replace(&mut state.opening, Origin::File);
        if origin != Origin::Shipped {
            state.record();
            let words = (state.text().model_opened)(report.entries);
            state.say(words);
        }
        let model = Model { report: Rc::new(report), origin };
        state.document.base = Some(model.clone());
        // What was done before the first model came is not undone by losing it.
        for document in state.history.iter_mut().filter(|document| document.base.is_none()) {
            document.base = Some(model.clone());
            document.model = Some(model.clone());
        }
        if learn_again(state, effects) {
            return;
        }
        state.document.model = Some(model);
    }
    share::resume(state, effects);
    talk::read(state, effects);
}

/// What was taught before is taught to the new model, too; whether there is anything.
fn learn_again(state: &mut State, effects: &mut Vec<Effect>) -> bool {
    let lessons = state.document.taught();
    let any = !lessons.is_empty();
    if any {
        teach::learn(state, lessons, effects);
    }
    any
}

/// The engine that answers began anew: it knows no model.
pub(super) fn restore(state: &mut State, effects: &mut Vec<Effect>) {
    match &state.document.model {
        Some(model) => {
            let text = model.report.model.clone();
            state.talker.send(Request::OpenModel { text }, false, effects);
        }
        None => effects.push(Effect::FetchModel),
    }
}
