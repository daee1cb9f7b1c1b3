//! Carries the page's effects out: the link, the engine that talks, and files beside the page.

use crate::robot::link::{Link, News};
use crate::ui::page::keep::ask::Place;
use crate::ui::page::view::host::{self, beside};
use crate::ui::page::view::keeper::{Store, load, read, write};
use crate::ui::page::view::worker::{Engine, Said};
use crate::ui::robot::action::Action;
use crate::ui::robot::effect::Effect;
use crate::ui::robot::talker::named;
use crate::worker::protocol::{Envelope, Program, Request, decode_said};
use gloo_timers::callback::Timeout;
use js_sys::{Object, Reflect};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::spawn_local;
use yew::Callback;

/// The front page, which names the engine that talks.
const FRONT: &str = "index.html";
/// The model, and what other words may stand for.
const MODEL: &str = "cleanup.model";
const WORDS: &str = "words.txt";
/// Milliseconds without a change after which a set-up is kept.
const REST: u32 = 700;

/// Carries effects out, and tells the page what comes of them.
pub(super) struct Effects {
    act: Callback<Action>,
    link: Option<Link>,
    store: Rc<RefCell<Option<Store>>>,
    /// Rings when nothing has changed for a moment.
    rest: Option<Timeout>,
    talker: Rc<RefCell<Talker>>,
}

/// The engine that talks, and what is to be sent to it once it is there.
#[derive(Default)]
struct Talker {
    engine: Option<Engine>,
    waiting: Vec<Envelope<Request>>,
}

impl Effects {
    /// Results go to `act`.
    pub(super) fn new(act: Callback<Action>) -> Effects {
        Effects { act, link: None, store: Rc::default(), rest: None, talker: Rc::default() }
    }

    /// Bytes that were sent over the link and have not left.
    pub(super) fn backlog(&self) -> u32 {
        self.link.as_ref().map_or(0, Link::backlog)
    }

    /// Carries effects out, in order.
    pub(super) fn run(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            match effect {
                Effect::Open(address) => self.open(&address),
                Effect::Close => self.link = None,
                Effect::Send(text) => {
                    if let Some(link) = &self.link {
                        link.send(&text);
                    }
                }
                Effect::Again(tries, ms) => self.ring(ms, Action::LinkAgain(tries)),
                Effect::Watch(watch, ms) => self.ring(ms, Action::Look(watch)),
                Effect::SpawnTalker => self.spawn(),
                Effect::Post(envelope) => self.post(envelope),
                Effect::FetchModel => self.fetch(MODEL, Action::Model),
                Effect::FetchWords => self.fetch(WORDS, Action::Words),
                Effect::Recall => self.recall(),
                Effect::Keep(text) => {
                    let store = self.store.clone();
                    self.rest = Some(Timeout::new(REST, move || keep(&store, text)));
                }
                Effect::Speak(language) => host::set_language(language.code()),
            }
        }
    }

    fn open(&mut self, address: &str) {
        let act = self.act.clone();
        let told = move |news| {
            act.emit(match news {
                News::Opened => Action::LinkOpened,
                News::Heard(text) => Action::LinkHeard(text),
                News::Closed => Action::LinkClosed,
            });
        };
        self.link = Link::open(address, told).ok();
        if self.link.is_none() {
            self.act.emit(Action::LinkClosed);
        }
    }

    /// Opens the store, which comes after the page, and tells what it has.
    fn recall(&self) {
        let (act, store) = (self.act.clone(), self.store.clone());
        spawn_local(async move {
            // Where nothing can be kept the page begins as it is.
            let found = match load(&JsValue::NULL).await {
                Ok((_, opened)) => {
                    let found = read(&opened, &place()).await.ok().flatten();
                    *store.borrow_mut() = Some(opened);
                    found
                }
                Err(_) => None,
            };
            act.emit(Action::Recalled(found.map(|(text, _)| text)));
        });
    }

    fn ring(&self, ms: u32, action: Action) {
        let act = self.act.clone();
        Timeout::new(ms, move || act.emit(action)).forget();
    }

    fn spawn(&self) {
        let (act, talker) = (self.act.clone(), self.talker.clone());
        *talker.borrow_mut() = Talker::default();
        spawn_local(async move {
            let told = act.reform(|said: Said| match said {
                Ok(envelope) => Action::Heard(envelope),
                Err(why) => Action::EngineBroke(why),
            });
            match talking(&told).await {
                Ok(engine) => {
                    let waiting = std::mem::take(&mut talker.borrow_mut().waiting);
                    let posted = waiting.iter().try_for_each(|envelope| engine.post(envelope));
                    talker.borrow_mut().engine = Some(engine);
                    if let Err(error) = posted {
                        act.emit(Action::EngineBroke(host::words(&error)));
                    }
                }
                Err(error) => act.emit(Action::EngineBroke(host::words(&error))),
            }
        });
    }

    fn post(&self, envelope: Envelope<Request>) {
        let mut talker = self.talker.borrow_mut();
        let posted = match &talker.engine {
            Some(engine) => engine.post(&envelope),
            None => {
                talker.waiting.push(envelope);
                Ok(())
            }
        };
        if let Err(error) = posted {
            self.act.emit(Action::EngineBroke(host::words(&error)));
        }
    }

    /// Gets a file beside the page, and tells the page of its text.
    fn fetch(&self, name: &'static str, told: fn(Result<String, String>) -> Action) {
        let act = self.act.clone();
        spawn_local(async move {
            act.emit(told(host::text(name).await.map_err(|error| host::words(&error))));
        });
    }
}

/// Where it is kept.
fn place() -> Place {
    Place::new("robot", "own")
}

/// Keeps a text, where there is a store.
fn keep(store: &Rc<RefCell<Option<Store>>>, text: String) {
    if let Some(store) = store.borrow().clone() {
        spawn_local(async move {
            // What cannot be kept is asked for anew at the next visit.
            let _ = write(&store, &place(), &text).await;
        });
    }
}

/// The engine that talks: the front page's program, by the name that it has there.
async fn talking(told: &Callback<Said>) -> Result<Engine, JsValue> {
    let page = host::text(FRONT).await?;
    let (script, program) = named(&page).ok_or("the front page names no program")?;
    let sent = Object::new();
    Reflect::set(&sent, &"script".into(), &beside(script)?.href().into())?;
    Reflect::set(&sent, &"program".into(), &beside(program)?.href().into())?;
    let engine = Engine::spawn(Program::Talker, decode_said, told)?;
    engine.give(&sent)?;
    Ok(engine)
}
