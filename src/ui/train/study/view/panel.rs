//! All about studies: making one, and reviewing answers.

use super::make::make;
use super::review::review;
use crate::ui::train::desk::Desk;
use crate::ui::train::study::action::Action;
use crate::ui::train::study::state::State;
use crate::ui::train::study::words::Text;
use yew::{Callback, Html, html};

/// The part about studies.
pub(crate) fn panel(state: &State, desk: &Desk, act: &Callback<Action>) -> Html {
    let text = Text::of(desk.language);
    html! {
        <div class="data">
            { make(state, desk, text, act) }
            { review(state, desk, text, act) }
        </div>
    }
}
