//! A session goes out as a link or a file, and comes in: its world at once, its lessons and its command as soon as there
//! is a model for them.

use super::also::Also;
use super::session::Session;
use super::state::{Link, Resume, Sharing};
use crate::ui::page::coming::Resource;
use crate::ui::page::document::Origin;
use crate::ui::page::effect::Effect;
use crate::ui::page::keep::state::short;
use crate::ui::page::language::Language;
use crate::ui::page::model;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask;
use crate::ui::talk::state::State;
use crate::ui::talk::teach::learn;
use crate::ui::talk::words::Text;
use crate::worker::protocol::Request;
use std::rc::Rc;

/// Has a link made.
pub(crate) fn share(shared: &mut Shared) {
    let packed = Session::of(shared, false).pack();
    shared.want(Effect::Share(packed));
}

/// Saves a file.
pub(crate) fn save(shared: &mut Shared) {
    let packed = Session::of(shared, true).pack();
    shared.want(Effect::SaveSession(packed));
}

/// A link was made, or could not be.
pub(crate) fn made(state: &mut State, shared: &mut Shared, made: Result<Link, String>) {
    let text = Text::of(shared.language);
    match &made {
        Ok(link) if link.copied => shared.say(text.link_copied),
        Ok(_) => shared.say(text.link_made),
        Err(why) => shared.say(why.clone()),
    }
    if let Ok(Link { address, .. }) = &made {
        shared.keep.made = address.split_once('#').map(|(_, link)| short(link));
    }
    state.sharing.made = Some(made);
}

/// A file could not be made.
pub(crate) fn unsaved(state: &mut State, shared: &mut Shared, why: &str) {
    tell(state, shared, (Text::of(shared.language).not_saved)(why));
}

/// A link or a file was opened.
pub(crate) fn opened(state: &mut State, shared: &mut Shared, packed: Result<Vec<u8>, String>) {
    let unpacked = |packed: Vec<u8>| {
        Session::unpack(&packed).ok_or_else(|| "another build of this page read it".to_owned())
    };
    match packed.and_then(unpacked) {
        Ok(session) => open(state, shared, session),
        Err(why) => {
            let words = (Text::of(shared.language).bad_link)(&why);
            tell(state, shared, words);
        }
    }
}

/// Tells what went wrong.
fn tell(state: &mut State, shared: &mut Shared, words: String) {
    shared.say(words.clone());
    state.sharing = Sharing { made: None, notice: Some(words) };
}

fn open(state: &mut State, shared: &mut Shared, session: Session) {
    let Session { world, rules, command, form, depth, lessons, model, also, .. } = session;
    state.settle(shared);
    shared.record();
    state.watch.forget();
    shared.document.open(world, None);
    shared.document.rules = rules;
    shared.depth = depth;
    state.sharing = Sharing::default();
    state.command.input = command.clone().unwrap_or_default();
    let (lessons, is_quiet) = ((!lessons.is_empty()).then_some(lessons), also.is_some());
    state.resume = Resume { lessons, command, form, is_quiet };
    let also = also.as_deref().and_then(Also::unpack);
    let trained = also.and_then(|also| restore(state, shared, also));
    match model {
        Some(text) => {
            let origin = trained.map_or(Origin::File, Origin::Trained);
            model::open(shared, text, origin);
        }
        None => resume(state, shared),
    }
}

/// What only this machine kept comes back, too; what corpus the model was trained on here is returned.
fn restore(state: &mut State, shared: &mut Shared, also: Also) -> Option<String> {
    let Also { preset, origin, draft, lesson, input, lines, language, made, trained } = also;
    let document = &mut shared.document;
    document.preset = preset;
    document.origin = Rc::new(origin);
    document.draft = draft;
    state.teach.words = lesson;
    state.past.lines = lines;
    state.command.input = input;
    if let Some(language) = Language::of(&language) {
        shared.language = language;
        shared.want(Effect::SetLanguage(language));
    }
    shared.keep.made = made;
    trained
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
        // What stands in the box, as it was kept or as a person has typed it meanwhile, stays there.
        let input = state.command.input.clone();
        ask::ask_for(state, shared, command);
        state.command.input = input;
    }
}

/// Whether nothing of a session that was opened waits for a model.
pub fn is_settled(state: &State, shared: &Shared) -> bool {
    let Resume { lessons, command, .. } = &state.resume;
    let opens = |request: &Request| matches!(request, Request::OpenModel { .. });
    let waits = lessons.is_some() || command.is_some() || shared.talker.is_at(opens);
    !waits && shared.document.base.is_some() && !learn::is_teaching(shared)
}
