//! The general resource for words that no lexicon knows: it comes after the first model, and an engine that begins
//! anew is given it again. Without it everything works that is said in words of the lexicon.

use super::coming::Resource;
use super::effect::Effect;
use super::shared::Shared;
use crate::worker::protocol::Request;

/// Has it fetched, if it was not yet.
pub fn fetch(shared: &mut Shared) {
    if shared.words == Resource::Absent {
        shared.words = Resource::Coming;
        shared.want(Effect::FetchWords);
    }
}

/// It has come, or has not: whether it is settled that there is none.
pub fn fetched(shared: &mut Shared, text: Result<String, String>) -> bool {
    match text {
        Ok(text) => shared.send(Request::Words { text }, false),
        Err(_) => shared.words = Resource::Lost,
    }
    shared.words == Resource::Lost
}

/// The engine has read it, or cannot.
pub fn read(shared: &mut Shared, text: String, well: bool) {
    shared.words = if well { Resource::Here(text.into()) } else { Resource::Lost };
}

/// The engine that answers began anew.
pub(super) fn restore(shared: &mut Shared) {
    if let Resource::Here(text) = &shared.words {
        let text = text.to_string();
        shared.send(Request::Words { text }, false);
    }
}
