//! The texts that sessions, lessons and worlds go out and come in as. What reads and writes them is in the keeper's
//! module, so that the first view need not carry it; the page itself holds them packed.

use super::host;
use super::module::import;
use crate::domain::State;
use js_sys::Uint8Array;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen]
extern "C" {
    /// The keeper's exports, as far as they are about texts.
    pub(crate) type Forms;
    #[wasm_bindgen(method, structural, catch)]
    pub(crate) fn read_session(this: &Forms, text: &str) -> Result<Uint8Array, JsValue>;
    #[wasm_bindgen(method, structural)]
    pub(crate) fn write_session(this: &Forms, packed: &[u8]) -> String;
    #[wasm_bindgen(method, structural)]
    pub(crate) fn write_lessons(this: &Forms, packed: &[u8]) -> String;
    #[wasm_bindgen(method, structural, catch)]
    fn read_world(this: &Forms, text: &str) -> Result<Uint8Array, JsValue>;
}

/// What reads and writes them, once it has come.
pub(crate) async fn forms() -> Result<Forms, String> {
    Ok(import("keeper.js", 0).await.map_err(|error| host::words(&error))?.unchecked_into())
}

/// A session, packed, from its text.
pub(crate) async fn session(text: String) -> Result<Vec<u8>, String> {
    packed(forms().await?.read_session(&text))
}

/// A world from JSON.
pub(crate) async fn world(text: String) -> Result<State, String> {
    let packed = packed(forms().await?.read_world(&text))?;
    postcard::from_bytes(&packed).map_err(|error| error.to_string())
}

/// What was packed, or why it was not.
pub(crate) fn packed(result: Result<Uint8Array, JsValue>) -> Result<Vec<u8>, String> {
    result.map(|packed| packed.to_vec()).map_err(|error| host::words(&error))
}
