//! Does what a person wants with what is kept. The page has no state of its own: the list is the store's.

use super::action::{Action, Wish};
use super::words::Text;
use crate::ui::page::effect::Effect;
use crate::ui::page::keep::ask::Ask;
use crate::ui::page::shared::Shared;

/// Does what a person wants; what is not the page's own to do is returned.
pub fn update(shared: &mut Shared, action: Action) -> Option<Wish> {
    let ask = match action {
        Action::Offered(file) => return Some(Wish::Open(file)),
        Action::Export(place) => Ask::Export(place),
        Action::Delete(place) => Ask::Delete(Some(place)),
        Action::DeleteAll => Ask::Delete(None),
    };
    if matches!(ask, Ask::Delete(_)) {
        shared.say(Text::of(shared.language).deleted);
    }
    shared.want(Effect::Keep(ask));
    None
}

/// The page was opened: the store is asked what it has.
pub fn begin(shared: &mut Shared) {
    shared.want(Effect::Keep(Ask::List));
}
