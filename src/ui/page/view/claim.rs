//! Which tab keeps a session: the one that holds the browser's lock on its name, which is let go of when the tab is
//! closed or dies. Linked by the program `keeper` alone.

use super::patience::patience;
use js_sys::{Function, Object, Promise, Reflect};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::prelude::{Closure, wasm_bindgen};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

#[wasm_bindgen]
extern "C" {
    type Locks;
    #[wasm_bindgen(method, catch)]
    fn request(
        this: &Locks,
        name: &str,
        options: &Object,
        granted: &JsValue,
    ) -> Result<Promise, JsValue>;
}

/// Milliseconds that a tab which was closed, or is being loaded anew, may take to let go of its lock: where its engines are
/// at work, or the machine is, it does so after the next one has opened.
const PATIENCE: u32 = 6_000;

/// Claims a name for this tab; whether it has it. With `steal` it is taken from the tab that has it, which is waited for
/// otherwise, six seconds. When another takes it, `lost` is called. A browser without locks gives it to all.
pub async fn claim(name: &str, steal: bool, lost: impl FnOnce() + Clone + 'static) -> bool {
    let navigator = Reflect::get(&js_sys::global(), &"navigator".into());
    let locks = navigator.and_then(|navigator| Reflect::get(&navigator, &"locks".into()));
    let Some(locks) = locks.ok().filter(JsValue::is_object) else { return true };
    let locks: Locks = locks.unchecked_into();
    let how = if steal { "steal" } else { "ifAvailable" };
    if request(&locks, name, (how, &JsValue::TRUE), lost.clone()).await {
        return true;
    }
    match patience(PATIENCE) {
        Some(signal) => request(&locks, name, ("signal", &signal), lost).await,
        None => false,
    }
}

/// Requests a lock in a way that the browser knows by name; whether it was granted.
async fn request(
    locks: &Locks,
    name: &str,
    (how, value): (&str, &JsValue),
    lost: impl FnOnce() + 'static,
) -> bool {
    let options = Object::new();
    let is_ours = Rc::new(Cell::new(false));
    let mut asked = Err(JsValue::NULL);
    let mut told = None;
    let answer = Promise::new(&mut |resolve: Function, _| {
        told = Some(resolve.clone());
        let is_ours = Rc::clone(&is_ours);
        let granted = Closure::once_into_js(move |lock: JsValue| {
            is_ours.set(lock.is_truthy());
            // A function that only settles a promise does not throw.
            let _ = resolve.call1(&JsValue::NULL, &is_ours.get().into());
            // Held as long as the tab lives.
            if is_ours.get() { Promise::new(&mut |_, _| ()).into() } else { JsValue::UNDEFINED }
        });
        asked = Reflect::set(&options, &how.into(), value)
            .and_then(|_| locks.request(name, &options, &granted));
    });
    let Ok(held) = asked else { return true };
    spawn_local(async move {
        match (JsFuture::from(held).await, told) {
            (Err(_), _) if is_ours.get() => lost(),
            // It was waited for in vain.
            (Err(_), Some(told)) => drop(told.call1(&JsValue::NULL, &JsValue::FALSE)),
            _ => {}
        }
    });
    JsFuture::from(answer).await.is_ok_and(|ours| ours.is_truthy())
}
