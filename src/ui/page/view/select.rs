//! A choice among a few values, by name.

use web_sys::{Event, HtmlSelectElement};
use yew::{Callback, Html, TargetCast, html};

/// A labelled choice: what the values are called, in order, and the place of the one that is chosen.
pub(crate) fn select(
    id: &'static str,
    label: &'static str,
    names: impl Iterator<Item = &'static str>,
    chosen: usize,
    choose: Callback<usize>,
) -> Html {
    let changed = choose.reform(|event: Event| {
        let place = event.target_dyn_into::<HtmlSelectElement>().map(|s| s.selected_index());
        place.and_then(|place| usize::try_from(place).ok()).unwrap_or(0)
    });
    html! {
        <label class="field" for={id}>
            <span>{ label }</span>
            <select {id} data-testid={id} onchange={changed}>
                { for names.enumerate().map(|(place, name)| html! {
                    <option selected={place == chosen}>{ name }</option>
                }) }
            </select>
        </label>
    }
}
