//! A program that comes when it is wanted: a module beside the page, imported and started.

use super::host::beside;
use js_sys::Promise;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = import)]
    fn import_module(url: &str) -> Promise;

    type Module;
    #[wasm_bindgen(method, structural, catch, js_name = default)]
    fn start(this: &Module) -> Result<Promise, JsValue>;
}

/// The exports of the module of this name, once it is there; `again` counts the times that it was wanted before.
pub(crate) async fn import(name: &str, again: u32) -> Result<JsValue, JsValue> {
    let url = beside(name)?;
    if again > 0 {
        // A browser may remember that a module of an address did not come.
        url.set_search(&again.to_string());
    }
    let module: Module = JsFuture::from(import_module(&url.href())).await?.unchecked_into();
    JsFuture::from(module.start()?).await?;
    Ok(module.into())
}
