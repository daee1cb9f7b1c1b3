//! What is in sight, and whether anybody is there: twice a second, while the page is seen and something was done with it
//! a little before, that time counts, and for every showing of which most is in the window. Time is the browser's own
//! that no clock changes.

use crate::ui::collect::action::Action;
use crate::ui::page::view::host;
use gloo_timers::callback::Interval;
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::Element;
use yew::Callback;

/// Milliseconds between two looks.
const EVERY: u32 = 500;
/// Milliseconds after which who does nothing may be away.
const AWAY: f64 = 20_000.0;
/// What marks a showing in the page.
const SHOWING: &str = "[data-showing]";

/// Watches as long as the page lives.
pub(super) fn watch(act: &Callback<Action>) {
    let last = Rc::new(Cell::new(host::now()));
    let Some(window) = web_sys::window() else { return };
    let done = {
        let last = last.clone();
        Closure::<dyn FnMut()>::new(move || last.set(host::now()))
    };
    for event in ["pointermove", "pointerdown", "keydown", "scroll"] {
        // A window that takes no listener counts no time.
        let _ = window.add_event_listener_with_callback_and_bool(
            event,
            done.as_ref().unchecked_ref(),
            true,
        );
    }
    done.forget();
    let again = act.reform(|()| Action::Again);
    let online = Closure::<dyn FnMut()>::new(move || again.emit(()));
    let _ = window.add_event_listener_with_callback("online", online.as_ref().unchecked_ref());
    online.forget();
    let act = act.clone();
    let mut before = host::now();
    let look = move || {
        let now = host::now();
        // A machine that slept was not looked at.
        let ms = (now - std::mem::replace(&mut before, now)).min(f64::from(2 * EVERY));
        let is_seen = web_sys::window().and_then(|w| w.document()).is_some_and(|d| !d.hidden());
        if is_seen && now - last.get() < AWAY {
            act.emit(Action::Spent(ms as u32, in_sight()));
        }
    };
    Interval::new(EVERY, look).forget();
}

/// Which showings are in the window for the most part.
pub(super) fn in_sight() -> Vec<bool> {
    let Some(window) = web_sys::window() else { return Vec::new() };
    let height = window.inner_height().ok().and_then(|height| height.as_f64()).unwrap_or(0.0);
    let all = window.document().and_then(|document| document.query_selector_all(SHOWING).ok());
    let Some(all) = all else { return Vec::new() };
    let showing = |at: u32| all.get(at).and_then(|node| node.dyn_into::<Element>().ok());
    let seen = |element: Element| {
        let place = element.get_bounding_client_rect();
        let shown = place.bottom().min(height) - place.top().max(0.0);
        shown >= 0.6 * place.height().min(height)
    };
    (0..all.length()).map(|at| showing(at).is_some_and(seen)).collect()
}
