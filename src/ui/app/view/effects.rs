//! Carries effects out: the workers, timers, downloads, links. The workers are web-sys's own and not gloo-worker's,
//! since the page must be able to end an engine that no longer answers and start another.

use super::address;
use crate::ui::app::action::Action;
use crate::ui::page::effect::Effect;
use crate::ui::page::view::host;
use crate::ui::page::view::keeper::Keeper;
use crate::ui::page::view::save::{object_url, save};
use crate::worker::protocol::{Program, decode, encode};
use gloo_timers::callback::Timeout;
use js_sys::Uint8Array;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{MessageEvent, Response, Url, Worker};
use web_sys::{WorkerOptions, WorkerType};
use yew::Callback;

/// The engine's script, beside the page: its address is made from the document's base, so that it is found
/// under any path.
const SCRIPT: &str = "engine.js";

/// The model that comes with the page, beside it.
const MODEL: &str = "cleanup.model";

/// The general resource for words, beside it.
const WORDS: &str = "words.txt";

/// Carries effects out, and tells the page what comes of them.
pub(super) struct Effects {
    act: Callback<Action>,
    keeper: Keeper,
    talker: Option<Engine>,
    learner: Option<Engine>,
}

/// A live worker with its listeners.
struct Engine {
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

impl Effects {
    /// Results go to `act`.
    pub(super) fn new(act: Callback<Action>) -> Effects {
        let keeper = Keeper::new(act.reform(Action::Stored));
        Effects { act, keeper, talker: None, learner: None }
    }

    /// Carries effects out, in order.
    pub(super) fn run(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            let program = match &effect {
                Effect::SpawnEngine(program) | Effect::Post(program, _) => *program,
                _ => Program::Talker,
            };
            if let Err(error) = self.carry_out(effect) {
                self.act.emit(Action::EngineBroke(program, host::words(&error)));
            }
        }
    }

    fn carry_out(&mut self, effect: Effect) -> Result<(), JsValue> {
        match effect {
            Effect::SpawnEngine(program) => {
                *self.engine(program) = None;
                *self.engine(program) = Some(spawn(program, &self.act)?);
            }
            Effect::Post(program, envelope) => {
                let bytes = encode(&envelope).map_err(|e| JsValue::from_str(&e.to_string()))?;
                if let Some(engine) = self.engine(program) {
                    engine.worker.post_message(&Uint8Array::from(&bytes[..]))?;
                }
            }
            Effect::StartTimer(timer, ms) => {
                let act = self.act.clone();
                Timeout::new(ms, move || act.emit(Action::Rang(timer))).forget();
            }
            Effect::FetchModel => self.fetch(MODEL.to_owned(), Action::Fetched),
            Effect::FetchWords => self.fetch(WORDS.to_owned(), Action::FetchedWords),
            Effect::FetchGuide(language) => {
                self.fetch(format!("help.{}.html", language.code()), Action::FetchedGuide);
            }
            Effect::Keep(ask) => self.keeper.ask(ask),
            Effect::SetLanguage(language) => host::set_language(language.code()),
            Effect::Share(text) => address::share(text, self.act.clone()),
            Effect::Copy(text) => {
                let act = self.act.clone();
                spawn_local(async move { act.emit(Action::Copied(host::copy(&text).await)) });
            }
            // The element may be in what is about to be drawn.
            Effect::Focus(id) => spawn_local(async move { host::focus(id) }),
            Effect::Save { name, text } => save(&name, JsValue::from_str(&text))?,
            Effect::GiveBack(file) => save(&file.name, Uint8Array::from(&file.bytes[..]).into())?,
            Effect::Reveal(id) => spawn_local(async move { host::reveal(id) }),
        }
        Ok(())
    }

    /// Gets a file beside the page, and tells the page of its text.
    fn fetch(&self, name: String, told: fn(Result<String, String>) -> Action) {
        let act = self.act.clone();
        spawn_local(async move {
            act.emit(told(fetch(&name).await.map_err(|error| host::words(&error))));
        });
    }

    const fn engine(&mut self, program: Program) -> &mut Option<Engine> {
        match program {
            Program::Talker => &mut self.talker,
            Program::Learner => &mut self.learner,
        }
    }
}

/// The address of a file beside the page.
fn beside(name: &str) -> Result<Url, JsValue> {
    let window = web_sys::window().ok_or("no window")?;
    let base = window.document().ok_or("no document")?.base_uri()?.ok_or("no base address")?;
    Url::new_with_base(name, &base)
}

/// The text of a file beside the page.
async fn fetch(name: &str) -> Result<String, JsValue> {
    let window = web_sys::window().ok_or("no window")?;
    let response = JsFuture::from(window.fetch_with_str(&beside(name)?.href())).await?;
    let response: Response = response.dyn_into()?;
    if !response.ok() {
        return Err(JsValue::from_str(&format!("status {}", response.status())));
    }
    let text = JsFuture::from(response.text()?).await?;
    text.as_string().ok_or_else(|| JsValue::from_str("no text"))
}

fn spawn(program: Program, act: &Callback<Action>) -> Result<Engine, JsValue> {
    let url = beside(SCRIPT)?;
    url.set_search(program.name());
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    // A worker that is loaded from an address has the policy that its host sends, which is none where a host sends no
    // headers. One of a text that the page makes has the page's own.
    let program_text = format!("import {:?}", url.href());
    let worker =
        Worker::new_with_options(&object_url(program_text.into(), "text/javascript")?, &options)?;
    if program == Program::Talker {
        worker.post_message(&own_program()?)?;
    }

    let heard = act.clone();
    let message = Closure::new(move |event: MessageEvent| {
        let data = event.data();
        let bytes = data.dyn_ref::<Uint8Array>().map(Uint8Array::to_vec);
        // The script around the engine has nothing but words, for when there is no engine.
        let why =
            || data.as_string().unwrap_or_else(|| "It sent a message that is none.".to_owned());
        heard.emit(match bytes.map(|bytes| decode(&bytes)) {
            Some(Ok(envelope)) => Action::Heard(program, envelope),
            Some(Err(error)) => {
                Action::EngineBroke(program, format!("A message is wrong: {error}."))
            }
            None => Action::EngineBroke(program, why()),
        });
    });
    worker.set_onmessage(Some(message.as_ref().unchecked_ref()));

    let broke = act.clone();
    let error = Closure::new(move |event: web_sys::Event| {
        let detail = event.dyn_ref::<web_sys::ErrorEvent>().map(|e| e.message());
        let detail = detail.filter(|m| !m.is_empty());
        broke.emit(Action::EngineBroke(
            program,
            detail.unwrap_or_else(|| "The engine's files could not be loaded.".to_owned()),
        ));
    });
    worker.set_onerror(Some(error.as_ref().unchecked_ref()));
    Ok(Engine { worker, _message: message, _error: error })
}

/// This very program, for the engine that talks: loaded and compiled once.
fn own_program() -> Result<JsValue, JsValue> {
    let document = web_sys::window().and_then(|w| w.document()).ok_or("no document")?;
    let link = document.query_selector("link[data-app=script]")?.ok_or("no script")?;
    let script = beside(&link.get_attribute("href").ok_or("no script")?)?.href();
    let sent = js_sys::Object::new();
    js_sys::Reflect::set(&sent, &"script".into(), &script.into())?;
    js_sys::Reflect::set(&sent, &"program".into(), &wasm_bindgen::module())?;
    Ok(sent.into())
}
