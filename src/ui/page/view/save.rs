//! Gives what there is to the person as a file, and addresses to what the page has made.

use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, Url};

/// An address for a text, or for bytes, of a type.
///
/// # Errors
/// When the browser makes none.
pub fn object_url(content: JsValue, kind: &str) -> Result<String, JsValue> {
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    let parts = js_sys::Array::of1(&content);
    Url::create_object_url_with_blob(&Blob::new_with_str_sequence_and_options(&parts, &options)?)
}

/// Offers a text, or bytes, as a file of this name.
///
/// # Errors
/// When the browser makes no file.
pub fn save(name: &str, content: JsValue) -> Result<(), JsValue> {
    let url = object_url(content, "text/plain;charset=utf-8")?;
    let document = web_sys::window().and_then(|w| w.document()).ok_or("no document")?;
    let link: HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    link.set_href(&url);
    link.set_download(name);
    link.click();
    Url::revoke_object_url(&url)
}
