//! The keys that count wherever one is: Escape stops, the space bar is the dead man's key; and what lets that go.

use crate::ui::robot::action::Action;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{Element, Event, KeyboardEvent, Window};
use yew::Callback;

/// What takes the space bar for itself.
const TAKES: &str = "input, textarea, select, button:not([data-hold]), a, summary";

/// Watches as long as the page lives.
pub(super) fn watch(act: &Callback<Action>) {
    let Some(window) = web_sys::window() else { return };
    let pressed = act.clone();
    listen(&window, "keydown", move |event| {
        let Some(key) = event.dyn_ref::<KeyboardEvent>() else { return };
        match &*key.key() {
            "Escape" => pressed.emit(Action::Stop),
            " " if !is_taken(event) => {
                event.prevent_default();
                if !key.repeat() {
                    pressed.emit(Action::Held(true));
                }
            }
            _ => {}
        }
    });
    let released = act.clone();
    listen(&window, "keyup", move |event| {
        if event.dyn_ref::<KeyboardEvent>().is_some_and(|key| key.key() == " ") {
            released.emit(Action::Held(false));
        }
    });
    let gone = act.clone();
    listen(&window, "blur", move |_| gone.emit(Action::Held(false)));
    let closing = act.clone();
    listen(&window, "pagehide", move |_| closing.emit(Action::Closing));
}

fn is_taken(event: &Event) -> bool {
    let element = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    element.is_some_and(|element| element.closest(TAKES).ok().flatten().is_some())
}

fn listen(window: &Window, event: &str, told: impl FnMut(&Event) + 'static) {
    let mut told = told;
    let listener: Closure<dyn FnMut(Event)> = Closure::new(move |event: Event| told(&event));
    // A window that takes no listener has no keys.
    let _ = window.add_event_listener_with_callback_and_bool(
        event,
        listener.as_ref().unchecked_ref(),
        true,
    );
    listener.forget();
}
