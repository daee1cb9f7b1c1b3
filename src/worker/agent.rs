//! An engine in its dedicated worker; wasm only. Messages come in as bytes, the engine is pumped in slices
//! of some milliseconds, and between slices the worker goes back to its event loop, so that a cancel or a
//! ping is heard while it works.

use super::job::{Engine, Role};
use super::protocol::{Envelope, Event, Request, VERSION, encode};
use super::reports::Reports;
use js_sys::{JsString, Uint8Array};
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Once;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{DedicatedWorkerGlobalScope, MessageChannel, MessageEvent, MessagePort};

/// Milliseconds of work between two looks at the event loop.
const SLICE_MS: f64 = 12.0;

/// Takes the worker's messages from now on, in a role.
pub fn listen<R: Role + 'static>() {
    report_panics();
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else { return };
    match Agent::<R>::start(&scope) {
        Ok(()) => post(&scope, 0, Event::Ready),
        Err(error) => post(&scope, 0, Event::Crashed { message: format!("{error:?}") }),
    }
}

/// The engine, and the channel on which the worker wakes itself.
struct Agent<R> {
    engine: RefCell<Engine<R>>,
    scope: DedicatedWorkerGlobalScope,
    wake: MessagePort,
    woken: Cell<bool>,
    reports: RefCell<Reports>,
}

impl<R: Role + 'static> Agent<R> {
    fn start(scope: &DedicatedWorkerGlobalScope) -> Result<(), JsValue> {
        // A message to oneself comes back after those already waiting, and sooner than any timer.
        let channel = MessageChannel::new()?;
        let agent = Rc::new(Agent {
            engine: RefCell::new(Engine::<R>::new()),
            scope: scope.clone(),
            wake: channel.port2(),
            woken: Cell::new(false),
            reports: RefCell::default(),
        });

        let worker = agent.clone();
        let work = Closure::<dyn FnMut()>::new(move || worker.work());
        channel.port1().set_onmessage(Some(work.as_ref().unchecked_ref()));
        // The worker lives as long as its listeners.
        work.forget();

        let message =
            Closure::<dyn FnMut(_)>::new(move |event: MessageEvent| agent.hear(&event.data()));
        scope.set_onmessage(Some(message.as_ref().unchecked_ref()));
        message.forget();
        Ok(())
    }

    fn hear(&self, data: &JsValue) {
        let bytes = data.dyn_ref::<Uint8Array>().map(Uint8Array::to_vec).unwrap_or_default();
        let envelope = match R::READ(&bytes) {
            Ok(envelope) => envelope,
            Err(error) => return self.refuse(&format!("This message is not a request: {error}.")),
        };
        match envelope.body {
            Request::Ping => return post(&self.scope, envelope.id, Event::Pong),
            request => self.engine.borrow_mut().start(envelope.id, composed(request)),
        }
        self.rouse();
    }

    fn refuse(&self, message: &str) {
        post(&self.scope, 0, Event::Refused { message: message.to_owned() });
    }

    /// Works for one slice; asks for the next one while there is work.
    fn work(&self) {
        self.woken.set(false);
        let end = self.now() + SLICE_MS;
        let mut engine = self.engine.borrow_mut();
        while engine.busy() {
            if let Some((id, event)) = engine.step() {
                for (id, event) in self.reports.borrow_mut().tell(self.now(), id, event) {
                    post(&self.scope, id, event);
                }
            }
            if self.now() >= end {
                break;
            }
        }
        if engine.busy() {
            self.rouse();
        }
    }

    fn rouse(&self) {
        if !self.woken.replace(true) && self.wake.post_message(&JsValue::NULL).is_err() {
            self.refuse("The engine cannot go on working in this browser.");
        }
    }

    fn now(&self) -> f64 {
        self.scope.performance().map_or(0.0, |p| p.now())
    }
}

/// A request whose command is in NFC, as the talker takes it.
fn composed(mut request: Request) -> Request {
    if let Request::Read { command, .. }
    | Request::Ask { command, .. }
    | Request::Explain { command } = &mut request
    {
        *command = JsString::from(command.as_str()).normalize("NFC").into();
    }
    request
}

fn post(scope: &DedicatedWorkerGlobalScope, id: u32, body: Event) {
    if let Ok(bytes) = encode(&Envelope { groundling: VERSION, id, body }) {
        // A page that is gone does not listen any more.
        let _ = scope.post_message(&Uint8Array::from(&bytes[..]));
    }
}

/// From now on a panic is told to the page in words; the first one is the one kept.
fn report_panics() {
    static FIRST: Once = Once::new();
    std::panic::set_hook(Box::new(|info| {
        let message = info.to_string();
        FIRST.call_once(|| {
            if let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() {
                post(&scope, 0, Event::Crashed { message });
            }
        });
    }));
}
