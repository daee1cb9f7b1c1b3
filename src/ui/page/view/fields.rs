//! Labelled fields of a form.

use web_sys::{Event, HtmlInputElement, HtmlSelectElement, InputEvent};
use yew::{AttrValue, Callback, Html, Properties, TargetCast, component, html, use_state_eq};

/// A number between two others.
pub(crate) fn number(
    id: AttrValue,
    label: AttrValue,
    [value, least, most, step]: [f64; 4],
    off: bool,
    change: Callback<f64>,
) -> Html {
    html! { <Number {id} {label} {value} {least} {most} {step} {off} {change} /> }
}

#[derive(Properties, PartialEq)]
struct NumberProps {
    id: AttrValue,
    label: AttrValue,
    value: f64,
    least: f64,
    most: f64,
    step: f64,
    off: bool,
    change: Callback<f64>,
}

/// What is being typed is the field's own until it is left: a page that is drawn anew meanwhile does not set it back.
#[component]
fn Number(props: &NumberProps) -> Html {
    let &NumberProps { value, least, most, .. } = props;
    let draft = use_state_eq(|| None::<String>);
    let typed = {
        let draft = draft.clone();
        Callback::from(move |event: InputEvent| {
            draft.set(event.target_dyn_into::<HtmlInputElement>().map(|input| input.value()));
        })
    };
    let left = {
        let (draft, change) = (draft.clone(), props.change.clone());
        Callback::from(move |event: Event| {
            let input = event.target_dyn_into::<HtmlInputElement>();
            let written = input.map(|input| input.value_as_number()).filter(|n| n.is_finite());
            draft.set(None);
            change.emit(written.unwrap_or(value).clamp(least, most));
        })
    };
    let shown = draft.as_ref().map_or_else(|| value.to_string(), String::clone);
    html! {
        <label class="field" for={&props.id}>
            <span>{ &props.label }</span>
            <input id={&props.id} type="number" data-testid={&props.id} value={shown} min={least.to_string()}
                max={most.to_string()} step={props.step.to_string()} disabled={props.off} oninput={typed} onchange={left} />
        </label>
    }
}

/// A line of text, of which every change is told.
pub(crate) fn line(
    id: impl Into<AttrValue>,
    label: &'static str,
    kind: &'static str,
    value: &str,
    change: Callback<String>,
) -> Html {
    let typed = change.reform(|event: InputEvent| {
        event.target_dyn_into::<HtmlInputElement>().map_or(String::new(), |input| input.value())
    });
    let id: AttrValue = id.into();
    html! {
        <label class="field grow" for={&id}>
            <span>{ label }</span>
            <input id={&id} type={kind} data-testid={&id} value={value.to_owned()} oninput={typed} autocomplete="off" />
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
