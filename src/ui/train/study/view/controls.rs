//! What the parts about studies are made of: a button, and how far something is.

use crate::ui::train::study::action::Action;
use yew::{Callback, Html, html};

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
