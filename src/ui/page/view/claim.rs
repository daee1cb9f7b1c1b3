//! Which tab keeps a session: the one that holds the browser's lock on its name, which is let go of when the tab is
//! closed or dies. Linked by the program `keeper` alone.

use js_sys::{Function, Object, Promise, Reflect};
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

/// Claims a name for this tab; whether it has it now. With `steal` it is taken from the tab that has it. When another
/// takes it, `lost` is called. A browser without locks gives it to all.
pub async fn claim(name: &str, steal: bool, lost: impl FnOnce() + 'static) -> bool {
    let navigator = Reflect::get(&js_sys::global(), &"navigator".into());
    let locks = navigator.and_then(|navigator| Reflect::get(&navigator, &"locks".into()));
    let Some(locks) = locks.ok().filter(JsValue::is_object) else { return true };
    let locks: Locks = locks.unchecked_into();
    let options = Object::new();
    let how = if steal { "steal" } else { "ifAvailable" };
    let mut asked = Err(JsValue::NULL);
    let answer = Promise::new(&mut |resolve: Function, _| {
        let granted = Closure::once_into_js(move |lock: JsValue| {
            let is_ours = lock.is_truthy();
            // A function that only settles a promise does not throw.
            let _ = resolve.call1(&JsValue::NULL, &is_ours.into());
            // Held as long as the tab lives.
            if is_ours { Promise::new(&mut |_, _| ()).into() } else { JsValue::UNDEFINED }
        });
        asked = Reflect::set(&options, &how.into(), &true.into())
            .and_then(|_| locks.request(name, &options, &granted));
    });
    let Ok(held) = asked else { return true };
    spawn_local(async move {
        if JsFuture::from(held).await.is_err() {
            lost();
        }
    });
    JsFuture::from(answer).await.is_ok_and(|ours| ours.is_truthy())
}
