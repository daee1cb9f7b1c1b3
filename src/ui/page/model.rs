//! The model that commands are read with: the one that comes with the page, one from a file, one that was trained
//! here; and the one before anything was taught.

use super::document::{Model, Origin};
use super::effect::Effect;
use super::resource;
use super::shared::Shared;
use super::words::Text;
use crate::worker::protocol::{Request, TrainReport};
use std::rc::Rc;

/// Gets the model that comes with the page.
pub fn fetch(shared: &mut Shared) {
    shared.model_notice = None;
    shared.want(Effect::FetchModel);
}

/// The model that comes with the page has come, or has not.
pub fn fetched(shared: &mut Shared, text: Result<String, String>) {
    match text {
        Ok(text) if shared.document.base.is_none() && !shared.talker.is_at(is_opening) => {
            send(shared, text, Origin::Shipped);
        }
        Ok(_) => {}
        Err(why) => {
            let words = (Text::of(shared.language).no_model)(&why);
            shared.say(words.clone());
            shared.model_notice = Some(words);
        }
    }
}

/// Opens a model, which comes from there.
pub fn open(shared: &mut Shared, text: String, origin: Origin) {
    shared.model_notice = None;
    // It takes the place of whatever waits to be opened.
    shared.talker.retain(|request| !is_opening(request));
    send(shared, text, origin);
}

/// Has the engine open a model; one that is being opened already comes from elsewhere.
fn send(shared: &mut Shared, text: String, origin: Origin) {
    let at = |text: &str| {
        shared
            .talker
            .is_at(|request| matches!(request, Request::OpenModel { text: it } if it == text))
    };
    shared.opening.retain(|(text, _)| at(text));
    shared.opening.push((text.clone(), origin));
    shared.send(Request::OpenModel { text }, true);
}

const fn is_opening(request: &Request) -> bool {
    matches!(request, Request::OpenModel { .. })
}

/// Goes on with this model: the engine that answers is given it.
pub fn go_on_with(shared: &mut Shared, model: Model) {
    let text = model.report.model.clone();
    shared.document.model = Some(model);
    shared.send(Request::OpenModel { text }, true);
}

/// The engine that answers has opened a model. Whether the lessons there are must be taught to it first.
pub fn opened(shared: &mut Shared, text: &str, report: TrainReport) -> bool {
    shared.model_notice = None;
    resource::fetch(shared);
    let place = shared.opening.iter().position(|(opening, _)| opening == text);
    let is_in_use = |model: &Model| model.report.model == text;
    if place.is_none() && shared.document.model.as_ref().is_some_and(is_in_use) {
        return false;
    }
    let origin = place.map_or(Origin::File, |place| shared.opening.remove(place).1);
    if origin != Origin::Shipped {
        shared.record();
        shared.say((Text::of(shared.language).model_opened)(report.entries));
    }
    let model = Model { report: Rc::new(report), origin };
    shared.document.base = Some(model.clone());
    // What was done before the first model came is not undone by losing it.
    for document in shared.history.iter_mut().filter(|document| document.base.is_none()) {
        document.base = Some(model.clone());
        document.model = Some(model.clone());
    }
    let teach = !shared.document.lessons.is_empty();
    if !teach {
        shared.document.model = Some(model);
    }
    teach
}

/// A model was refused, for a reason.
pub fn refused(shared: &mut Shared, message: String) {
    shared.say(message.clone());
    shared.model_notice = Some(message);
}

/// The engine that answers began anew: it knows no model.
pub fn restore(shared: &mut Shared) {
    resource::restore(shared);
    match &shared.document.model {
        Some(model) => {
            let text = model.report.model.clone();
            shared.send(Request::OpenModel { text }, false);
        }
        None => shared.want(Effect::FetchModel),
    }
}
