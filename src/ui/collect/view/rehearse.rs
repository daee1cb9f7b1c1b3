//! A participant that is simulated, in the real page: it presses the buttons that a person would, and types into the box.
//! Only the time that it looks is said and not spent.

use super::sight::in_sight;
use crate::ui::collect::action::Action;
use crate::ui::collect::runs::{is_shown, on_view};
use crate::ui::collect::state::{Stage, State};
use wasm_bindgen::JsCast;
use web_sys::{Document, Event, EventInit, HtmlElement, HtmlTextAreaElement};
use yew::Callback;

/// Does the next thing, if there is one to do.
pub(super) fn step(state: &State, act: &Callback<Action>) {
    let Some(script) = &state.script else { return };
    let Some(document) = web_sys::window().and_then(|window| window.document()) else { return };
    if state.keeping.is_some() {
        return;
    }
    match state.stage() {
        Stage::Welcome => press(&document, "agree"),
        Stage::Instructions => press(&document, "ready"),
        Stage::Turn(at) => {
            let Some(one) = script.acts.get(at) else { return };
            if let Some(run) = (0..on_view(state).len()).find(|&run| !is_shown(state, run)) {
                press(&document, &format!("step-{}", run + 1));
            } else if state.text != one.words {
                act.emit(Action::Spent(one.looks_ms, in_sight()));
                write(&document, &one.words);
            } else {
                press(&document, "next");
            }
        }
        Stage::End(_) if state.ending.is_done => press(&document, "ended"),
        Stage::End(_) => press(&document, "end"),
        _ => {}
    }
}

/// Presses what has this test id, if it is there.
fn press(document: &Document, id: &str) {
    let found = document.query_selector(&format!("[data-testid=\"{id}\"]")).ok().flatten();
    if let Some(button) = found.and_then(|found| found.dyn_into::<HtmlElement>().ok()) {
        button.click();
    }
}

/// Puts words into the box, as if they had been typed.
fn write(document: &Document, words: &str) {
    let field = document.get_element_by_id("command");
    if let Some(field) = field.and_then(|field| field.dyn_into::<HtmlTextAreaElement>().ok()) {
        field.set_value(words);
        let options = EventInit::new();
        options.set_bubbles(true);
        if let Ok(event) = Event::new_with_event_init_dict("input", &options) {
            // The page hears it as it hears a key.
            let _ = field.dispatch_event(&event);
        }
    }
}
