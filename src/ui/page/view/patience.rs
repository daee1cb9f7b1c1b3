//! A signal that ends what takes too long.

use js_sys::{Function, Reflect};
use wasm_bindgen::{JsCast, JsValue};

/// A signal that aborts after so many milliseconds; nothing in a browser without such.
pub(crate) fn patience(milliseconds: u32) -> Option<JsValue> {
    let signals = Reflect::get(&js_sys::global(), &"AbortSignal".into()).ok()?;
    let timeout: Function = Reflect::get(&signals, &"timeout".into()).ok()?.dyn_into().ok()?;
    timeout.call1(&signals, &milliseconds.into()).ok()
}
