//! Texts as a link holds them: deflated, in letters that an address need not escape. Packing is the browser's own
//! (`CompressionStream`), so that no program need carry any.

use js_sys::{Array, Uint8Array};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, ReadableWritablePair, Response, Window};

/// How a text is packed.
const FORMAT: &str = "deflate-raw";

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(extends = ReadableWritablePair)]
    type CompressionStream;
    #[wasm_bindgen(constructor, catch)]
    fn new(format: &str) -> Result<CompressionStream, JsValue>;

    #[wasm_bindgen(extends = ReadableWritablePair)]
    type DecompressionStream;
    #[wasm_bindgen(constructor, catch)]
    fn new(format: &str) -> Result<DecompressionStream, JsValue>;
}

/// A text as a link holds it: deflated, in the letters of base 64 that an address needs not escape.
pub(crate) async fn pack(window: &Window, text: &str) -> Result<String, JsValue> {
    let blob = Blob::new_with_str_sequence(&Array::of1(&JsValue::from_str(text)))?;
    let bytes = piped(&blob, &CompressionStream::new(FORMAT)?.into()).await?;
    let letters: String = bytes.to_vec().into_iter().map(char::from).collect();
    let letters = window.btoa(&letters)?;
    Ok(letters.replace('+', "-").replace('/', "_").trim_end_matches('=').to_owned())
}

/// The text that a link holds, if it is no longer than so many letters.
///
/// # Errors
/// In words, why it cannot be read.
pub(crate) async fn unpack(packed: &str, longest: usize) -> Result<String, String> {
    if packed.len() > longest {
        return Err("it is too long".to_owned());
    }
    let broken = |_: JsValue| "it is damaged, or was cut off on its way".to_owned();
    let window = web_sys::window().ok_or("there is no window")?;
    let letters = packed.replace('-', "+").replace('_', "/");
    let letters = window.atob(&letters).map_err(broken)?;
    let bytes: Vec<u8> = letters.chars().map(|c| c as u8).collect();
    let parts = Array::of1(&Uint8Array::from(bytes.as_slice()));
    let blob = Blob::new_with_u8_array_sequence(&parts).map_err(broken)?;
    let stream = DecompressionStream::new(FORMAT).map_err(broken)?;
    let bytes = piped(&blob, &stream.into()).await.map_err(broken)?;
    String::from_utf8(bytes.to_vec()).map_err(|_| "it is damaged".to_owned())
}

/// The bytes of a blob behind a stream that changes them. Deflate makes at most a thousand of one, and what comes in
/// is short.
async fn piped(blob: &Blob, through: &ReadableWritablePair) -> Result<Uint8Array, JsValue> {
    let changed = blob.stream().pipe_through(through);
    let response = Response::new_with_opt_readable_stream(Some(&changed))?;
    Ok(Uint8Array::new(&JsFuture::from(response.array_buffer()?).await?))
}
