//! A choice among a few values, by name.

use web_sys::{Event, HtmlSelectElement};
use yew::{Callback, Html, Properties, TargetCast, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props<T: Clone + PartialEq + 'static> {
    pub(super) id: &'static str,
    pub(super) label: &'static str,
    pub(super) all: Vec<T>,
    pub(super) chosen: T,
    /// What a value is called.
    pub(super) name: Callback<T, String>,
    pub(super) choose: Callback<T>,
}

/// A labelled choice.
#[component]
pub(super) fn Select<T: Clone + PartialEq + 'static>(props: &Props<T>) -> Html {
    let Props { id, label, all, chosen, name, choose } = props;
    let changed = {
        let (all, choose) = (all.clone(), choose.clone());
        Callback::from(move |event: Event| {
            let place = event.target_dyn_into::<HtmlSelectElement>().map(|s| s.selected_index());
            let value = place.and_then(|place| all.get(usize::try_from(place).ok()?));
            if let Some(value) = value {
                choose.emit(value.clone());
            }
        })
    };
    html! {
        <label class="field" for={*id}>
            <span>{ *label }</span>
            <select id={*id} data-testid={*id} onchange={changed}>
                { for all.iter().map(|one| html! {
                    <option selected={one == chosen}>{ name.emit(one.clone()) }</option>
                }) }
            </select>
        </label>
    }
}
