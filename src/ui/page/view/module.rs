//! A program that comes when it is wanted: a module beside the page, imported and started.

use super::host::beside;
use js_sys::Promise;
use std::cell::RefCell;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, future_to_promise};

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = import)]
    fn import_module(url: &str) -> Promise;

    type Module;
    #[wasm_bindgen(method, structural, catch, js_name = default)]
    fn start(this: &Module) -> Result<Promise, JsValue>;
}

thread_local! {
    /// The modules that came or are coming, by address: who wants one that is on its way waits for the same, since a
    /// module that is started twice at once is there twice.
    static COMING: RefCell<Vec<(String, Promise)>> = const { RefCell::new(Vec::new()) };
}

/// The exports of the module of this name, once it is there; `again` counts the times that it was wanted before.
pub(crate) async fn import(name: &str, again: u32) -> Result<JsValue, JsValue> {
    let url = beside(name)?;
    if again > 0 {
        // A browser may remember that a module of an address did not come.
        url.set_search(&again.to_string());
    }
    let address = url.href();
    let known = COMING.with_borrow(|coming| {
        coming.iter().find(|(at, _)| *at == address).map(|(_, promise)| promise.clone())
    });
    let promise = known.unwrap_or_else(|| {
        let promise = future_to_promise(begin(address.clone()));
        COMING.with_borrow_mut(|coming| coming.push((address.clone(), promise.clone())));
        promise
    });
    let module = JsFuture::from(promise).await;
    if module.is_err() {
        COMING.with_borrow_mut(|coming| coming.retain(|(at, _)| *at != address));
    }
    module
}

async fn begin(address: String) -> Result<JsValue, JsValue> {
    let module: Module = JsFuture::from(import_module(&address)).await?.unchecked_into();
    JsFuture::from(module.start()?).await?;
    Ok(module.into())
}
