//! All of what was learned.

use super::difference::difference;
use super::entries::entries;
use super::errors::errors;
use crate::ui::train::desk::Desk;
use crate::ui::train::lexicon::action::Action;
use crate::ui::train::lexicon::state::State;
use crate::ui::train::lexicon::words::Text;
use crate::worker::protocol::Confused;
use yew::{Callback, Html, html};

/// What was learned; `confused` is of what is held out.
pub(crate) fn panel(
    state: &State,
    desk: &Desk,
    confused: &[Confused],
    act: &Callback<Action>,
) -> Html {
    let text = Text::of(desk.language);
    html! {
        <div class="data">
            { entries(state, text, act) }
            { errors(state, confused, text, act) }
            { difference(state, text, act) }
        </div>
    }
}
