//! A live engine. The workers are web-sys's own and not gloo-worker's, since an engine that no longer answers must be
//! ended and another started.

use super::host::beside;
use super::save::object_url;
use crate::worker::protocol::{Envelope, Event, Program, Reader, Request, encode};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};
use yew::Callback;

/// The engine's script, beside the page: its address is made from the document's base, so that it is found
/// under any path.
const SCRIPT: &str = "engine.js";

/// What an engine says, or how it broke.
pub(crate) type Said = Result<Envelope<Event>, String>;

/// A live worker with its listeners; it ends when this is dropped.
pub(crate) struct Engine {
    worker: Worker,
    _message: Closure<dyn FnMut(MessageEvent)>,
    _error: Closure<dyn FnMut(web_sys::Event)>,
}

impl Drop for Engine {
    fn drop(&mut self) {
        self.worker.set_onmessage(None);
        self.worker.set_onerror(None);
        self.worker.terminate();
    }
}

impl Engine {
    /// Starts an engine; what it says goes to `told`, read by `read`.
    pub(crate) fn spawn(
        program: Program,
        read: Reader<Event>,
        told: &Callback<Said>,
    ) -> Result<Engine, JsValue> {
        let url = beside(SCRIPT)?;
        url.set_search(program.name());
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        // A worker that is loaded from an address has the policy that its host sends, which is none where a host sends
        // no headers. One of a text that the page makes has the page's own.
        let text = format!("import {:?}", url.href());
        let worker =
            Worker::new_with_options(&object_url(text.into(), "text/javascript")?, &options)?;

        let heard = told.clone();
        let message = Closure::new(move |event: MessageEvent| {
            let data = event.data();
            let bytes = data.dyn_ref::<Uint8Array>().map(Uint8Array::to_vec);
            // The script around the engine has nothing but words, for when there is no engine.
            let why =
                || data.as_string().unwrap_or_else(|| "It sent a message that is none.".to_owned());
            heard.emit(match bytes.map(|bytes| read(&bytes)) {
                Some(said) => said.map_err(|error| format!("A message is wrong: {error}.")),
                None => Err(why()),
            });
        });
        worker.set_onmessage(Some(message.as_ref().unchecked_ref()));

        let broke = told.clone();
        let error = Closure::new(move |event: web_sys::Event| {
            let detail = event.dyn_ref::<web_sys::ErrorEvent>().map(|e| e.message());
            let detail = detail.filter(|m| !m.is_empty());
            let why = || "The engine's files could not be loaded.".to_owned();
            broke.emit(Err(detail.unwrap_or_else(why)));
        });
        worker.set_onerror(Some(error.as_ref().unchecked_ref()));
        Ok(Engine { worker, _message: message, _error: error })
    }

    /// Sends it a request.
    pub(crate) fn post(&self, envelope: &Envelope<Request>) -> Result<(), JsValue> {
        let bytes = encode(envelope).map_err(|e| JsValue::from_str(&e.to_string()))?;
        let bytes = Uint8Array::from(&bytes[..]);
        // Its memory goes over: what is large is copied no more than it must.
        self.worker.post_message_with_transfer(&bytes, &Array::of1(&bytes.buffer()))
    }

    /// Gives it what is no request: what it is made of.
    pub(crate) fn give(&self, what: &JsValue) -> Result<(), JsValue> {
        self.worker.post_message(what)
    }
}
