//! Keys that work wherever one is on the page: undo, redo, and the list of them.
use crate::ui::app::action::Action;
use crate::ui::page::view::host;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{Element, HtmlInputElement, KeyboardEvent};
use yew::Callback;

/// Listens as long as the page lives.
pub(super) fn watch(act: &Callback<Action>) {
    let act = act.clone();
    let pressed = Closure::<dyn FnMut(_)>::new(move |event: KeyboardEvent| {
        let Some(meant) = meant(&event) else { return };
        event.prevent_default();
        match meant {
            Meant::Do(action) => act.emit(action),
            Meant::Help => host::go("help"),
        }
    });
    if let Some(document) = web_sys::window().and_then(|w| w.document()) {
        document.set_onkeydown(Some(pressed.as_ref().unchecked_ref()));
    }
    pressed.forget();
}

enum Meant {
    Do(Action),
    Help,
}

/// What a key means; nothing where it is for a text that is being written.
fn meant(event: &KeyboardEvent) -> Option<Meant> {
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let is_writing = target.is_some_and(|target| is_writing(&target));
    let command = event.ctrl_key() || event.meta_key();
    // Caps Lock makes a capital of every letter.
    match &*event.key().to_lowercase() {
        _ if is_writing || event.alt_key() => None,
        "z" if command && !event.shift_key() => Some(Meant::Do(Action::Undo)),
        "z" | "y" if command => Some(Meant::Do(Action::Redo)),
        "?" if !command => Some(Meant::Help),
        _ => None,
    }
}

/// Whether a text is being written there: an empty line, or one that was only filled in by the page, is none.
fn is_writing(target: &Element) -> bool {
    let Some(input) = target.dyn_ref::<HtmlInputElement>() else {
        return target.has_attribute("contenteditable") || target.tag_name() == "TEXTAREA";
    };
    match &*input.type_() {
        "text" | "number" => input.get_attribute("data-said").as_deref() != Some(&input.value()),
        _ => false,
    }
}
