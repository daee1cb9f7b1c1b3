//! A button of the training panel.

use crate::ui::train::run::action::Action;
use yew::{Callback, Html, classes, html};

/// A button that does something about training.
pub(super) fn press(
    class: &'static str,
    id: &'static str,
    words: &'static str,
    off: bool,
    act: &Callback<Action>,
    action: Action,
) -> Html {
    let press = act.reform(move |_| action.clone());
    html! {
        <button type="button" class={classes!(class)} data-testid={id} disabled={off} onclick={press}>{ words }</button>
    }
}
