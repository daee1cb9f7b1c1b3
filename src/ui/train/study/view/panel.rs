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

/// A button that does something.
pub(super) fn button(
    id: &'static str,
    words: &str,
    off: bool,
    act: &Callback<Action>,
    action: Action,
) -> Html {
    let pressed = act.reform(move |_: yew::MouseEvent| action.clone());
    html! {
        <button type="button" class="quiet" data-testid={id} disabled={off} onclick={pressed}>{ words }</button>
    }
}

/// How far something is.
pub(super) fn bar(id: &'static str, words: &'static str, progress: Option<(u32, u32)>) -> Html {
    html! {
        if let Some((done, of)) = progress {
            <div class="bar" data-testid={id}>
                <progress aria-label={words} max={of.to_string()} value={done.to_string()} />
                <p class="dim">{ format!("{words}: {done} / {of}") }</p>
            </div>
        }
    }
}
