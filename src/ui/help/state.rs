//! The state of the guide: its text, as far as it has come.

use crate::ui::page::effect::Effect;
use crate::ui::page::language::Language;
use crate::ui::page::shared::Shared;
use std::rc::Rc;

/// All that the page knows by itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// The language that it was wanted in.
    wanted: Option<Language>,
    /// Its text, or why there is none.
    pub text: Option<Result<Rc<str>, String>>,
}

/// The page is open: it wants the guide in the page's language.
pub fn begin(state: &mut State, shared: &mut Shared) {
    if state.wanted != Some(shared.language) {
        state.wanted = Some(shared.language);
        shared.want(Effect::FetchGuide(shared.language));
    }
}

/// The guide has come, or has not: it is asked for again then.
pub fn came(state: &mut State, text: Result<String, String>) {
    if text.is_err() {
        state.wanted = None;
    }
    state.text = Some(text.map(Rc::from));
}
