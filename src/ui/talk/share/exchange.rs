//! A session goes out as a link or a file, and comes in: its world at once, its lessons and its command as soon as there
//! is a model for them.

use super::session::Session;
use super::state::{Link, Resume, Sharing};
use crate::ui::page::coming::Resource;
use crate::ui::page::document::Origin;
use crate::ui::page::effect::Effect;
use crate::ui::page::model;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask;
use crate::ui::talk::state::State;
use crate::ui::talk::teach::learn;
use crate::ui::talk::words::Text;

/// Has a link made.
pub(crate) fn share(shared: &mut Shared) {
    let text = Session::of(shared, false).write();
    shared.want(Effect::Share(text));
}

/// Saves a file.
pub(crate) fn save(shared: &mut Shared) {
    let text = Session::of(shared, true).write();
    shared.want(Effect::Save { name: "groundling.json".to_owned(), text });
}

/// A link was made, or could not be.
pub(crate) fn made(state: &mut State, shared: &mut Shared, made: Result<Link, String>) {
    let text = Text::of(shared.language);
    match &made {
        Ok(link) if link.copied => shared.say(text.link_copied),
        Ok(_) => shared.say(text.link_made),
        Err(why) => shared.say(why.clone()),
    }
    state.sharing.made = Some(made);
}

/// A link or a file was opened.
pub(crate) fn opened(state: &mut State, shared: &mut Shared, text: Result<String, String>) {
    let session = text.and_then(|text| Session::read(&text).map_err(|error| error.to_string()));
    match session {
        Ok(session) => open(state, shared, session),
        Err(why) => {
            let words = (Text::of(shared.language).bad_link)(&why);
            shared.say(words.clone());
            state.sharing.notice = Some(words);
        }
    }
}

fn open(state: &mut State, shared: &mut Shared, session: Session) {
    let Session { world, rules, command, form, depth, lessons, model, .. } = session;
    state.settle(shared);
    shared.record();
    state.watch.forget();
    shared.document.open(world, None);
    shared.document.rules = rules;
    shared.depth = depth;
    state.sharing = Sharing::default();
    state.command.input = command.clone().unwrap_or_default();
    state.resume = Resume { lessons: (!lessons.is_empty()).then_some(lessons), command, form };
    match model {
        Some(text) => model::open(shared, text, Origin::File),
        None => resume(state, shared),
    }
}

/// Goes on with a session that was opened, as far as there is a model for it.
pub(crate) fn resume(state: &mut State, shared: &mut Shared) {
    // A command may be of words that only the general resource knows.
    if !shared.can_ask() || shared.words == Resource::Coming {
        return;
    }
    if let Some(lessons) = state.resume.lessons.take() {
        learn::learn(state, shared, lessons);
    } else if let Some(command) = state.resume.command.take() {
        ask::ask_for(state, shared, command);
    }
}
