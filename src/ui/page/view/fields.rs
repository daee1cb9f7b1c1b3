//! Labelled fields of a form.

use web_sys::{Event, HtmlInputElement, HtmlSelectElement, InputEvent};
use yew::{AttrValue, Callback, Html, TargetCast, html};

/// A number between two others.
pub(crate) fn number(
    id: AttrValue,
    label: AttrValue,
    [value, least, most, step]: [f64; 4],
    off: bool,
    change: Callback<f64>,
) -> Html {
    let changed = change.reform(move |event: Event| {
        let input = event.target_dyn_into::<HtmlInputElement>();
        let written = input.map(|input| input.value_as_number()).filter(|n| n.is_finite());
        written.unwrap_or(value).clamp(least, most)
    });
    html! {
        <label class="field" for={id.clone()}>
            <span>{ label }</span>
            <input id={id.clone()} type="number" data-testid={id} value={value.to_string()} min={least.to_string()}
                max={most.to_string()} step={step.to_string()} disabled={off} onchange={changed} />
        </label>
    }
}

/// A line of text, of which every change is told.
pub(crate) fn line(
    id: &'static str,
    label: &'static str,
    kind: &'static str,
    value: &str,
    change: Callback<String>,
) -> Html {
    let typed = change.reform(|event: InputEvent| {
        event.target_dyn_into::<HtmlInputElement>().map_or(String::new(), |input| input.value())
    });
    html! {
        <label class="field grow" for={id}>
            <span>{ label }</span>
            <input {id} type={kind} data-testid={id} value={value.to_owned()} oninput={typed} autocomplete="off" />
        </label>
    }
}

/// A choice among named values, by their place.
pub(crate) fn choice(
    id: AttrValue,
    label: AttrValue,
    names: &[String],
    chosen: usize,
    choose: Callback<usize>,
) -> Html {
    let changed = choose.reform(|event: Event| {
        let place = event.target_dyn_into::<HtmlSelectElement>().map(|s| s.selected_index());
        place.and_then(|place| usize::try_from(place).ok()).unwrap_or(0)
    });
    html! {
        <label class="field" for={id.clone()}>
            <span>{ label }</span>
            <select id={id.clone()} data-testid={id} onchange={changed}>
                { for names.iter().enumerate().map(|(place, name)| html! {
                    <option selected={place == chosen}>{ name }</option>
                }) }
            </select>
        </label>
    }
}

/// Something that is so, or not.
pub(crate) fn tick(
    id: AttrValue,
    label: AttrValue,
    is_so: bool,
    off: bool,
    change: Callback<bool>,
) -> Html {
    let changed = change.reform(|event: Event| {
        event.target_dyn_into::<HtmlInputElement>().is_some_and(|input| input.checked())
    });
    html! {
        <label class="tick" for={id.clone()}>
            <input id={id.clone()} type="checkbox" data-testid={id} checked={is_so} disabled={off} onchange={changed} />
            <span>{ label }</span>
        </label>
    }
}
