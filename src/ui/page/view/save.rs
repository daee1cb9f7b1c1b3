//! Gives a text or bytes to the person as a file.

use js_sys::Uint8Array;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, Url};

/// Offers a text as a file of this name.
///
/// # Errors
/// When the browser makes no file.
pub fn save(name: &str, text: &str) -> Result<(), JsValue> {
    give(name, JsValue::from_str(text))
}

/// Offers bytes as a file of this name.
///
/// # Errors
/// When the browser makes no file.
pub fn save_bytes(name: &str, bytes: &[u8]) -> Result<(), JsValue> {
    give(name, Uint8Array::from(bytes).into())
}

/// An address for a text, or for bytes, of a type.
pub(super) fn object_url(content: JsValue, kind: &str) -> Result<String, JsValue> {
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    let parts = js_sys::Array::of1(&content);
    Url::create_object_url_with_blob(&Blob::new_with_str_sequence_and_options(&parts, &options)?)
}

fn give(name: &str, content: JsValue) -> Result<(), JsValue> {
    let url = object_url(content, "text/plain;charset=utf-8")?;
    let document = web_sys::window().and_then(|w| w.document()).ok_or("no document")?;
    let link: HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    link.set_href(&url);
    link.set_download(name);
    link.click();
    Url::revoke_object_url(&url)
}
