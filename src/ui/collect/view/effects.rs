//! Carries the page's effects out: fetching, the journal, posting, files, leaving.

use crate::study::Study;
use crate::study::ends::Source;
use crate::study::file::MAX_BYTES;
use crate::study::link::{INLINE, LONGEST};
use crate::ui::collect::action::{Action, Kept, Trouble};
use crate::ui::collect::effect::Effect;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::view::claim::claim;
use crate::ui::page::view::drawn::{Deed, Drawn};
use crate::ui::page::view::host;
use crate::ui::page::view::journal::Journal;
use crate::ui::page::view::packed::unpack;
use crate::ui::page::view::patience::patience;
use crate::ui::page::view::save::save;
use gloo_timers::callback::Timeout;
use js_sys::{Object, Reflect};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{HtmlFormElement, HtmlInputElement, RequestInit, Response};
use yew::Callback;

/// Milliseconds without a key after which what was typed is kept.
const REST: u32 = 700;
/// Milliseconds that an endpoint may take to answer.
const PATIENCE: u32 = 30_000;

/// Carries effects out, and tells the page what comes of them.
#[derive(Clone)]
pub(super) struct Effects {
    act: Callback<Action>,
    journal: Rc<RefCell<Option<Rc<Journal>>>>,
    rest: Rc<RefCell<Option<Timeout>>>,
    tick: Rc<RefCell<Option<Timeout>>>,
    drawn: Rc<RefCell<Drawn>>,
}

impl Effects {
    /// Results go to `act`.
    pub(super) fn new(act: Callback<Action>) -> Effects {
        let (journal, rest, tick) = (Rc::default(), Rc::default(), Rc::default());
        Effects { act, journal, rest, tick, drawn: Rc::default() }
    }

    /// What the effects asked for is drawn.
    pub(super) fn drawn(&self) {
        self.drawn.borrow_mut().is();
    }

    /// Carries effects out; those of the journal in their order.
    pub(super) fn run(&self, effects: Vec<Effect>) {
        for effect in effects {
            let this = self.clone();
            match effect {
                // The timer before it is dropped, and does not ring.
                Effect::Rest => drop(self.rest.replace(Some(self.ring(REST, Action::Rested)))),
                Effect::Tick(ms) => drop(self.tick.replace(Some(self.ring(ms, Action::Ticked)))),
                Effect::Retry(ms) => {
                    self.ring(ms, Action::Again).forget();
                }
                Effect::Save { name, text } => {
                    // A browser that makes no file says so itself.
                    let _ = save(&name, &text);
                }
                Effect::Submit { url, fields } => submit(&url, &fields),
                Effect::Go(url) => leave(&url),
                Effect::Top => self.drawn.borrow_mut().then(Deed::Focus, "heading"),
                Effect::Speak(language) => host::set_language(language.code()),
                Effect::Copy(text) => spawn_local(async move {
                    host::copy(&text).await;
                }),
                other => spawn_local(async move {
                    if let Some(action) = this.awaited(other).await {
                        this.act.emit(action);
                    }
                }),
            }
        }
    }

    /// A timer that says something after so many milliseconds.
    fn ring(&self, ms: u32, action: Action) -> Timeout {
        let act = self.act.clone();
        Timeout::new(ms, move || act.emit(action))
    }

    /// What comes of an effect that takes a while.
    async fn awaited(&self, effect: Effect) -> Option<Action> {
        Some(match effect {
            Effect::Fetch(file) => Action::Came(fetched(&file).await),
            Effect::Unpack => Action::Came(linked().await),
            Effect::Open(study) => Action::Known(self.known(&study).await),
            Effect::Claim { sitting, steal } => {
                let act = self.act.clone();
                let lost = move || act.emit(Action::Broke(Fault::Elsewhere));
                let base = host::beside(".").map(|url| url.href()).unwrap_or_default();
                Action::Claimed(claim(&format!("{base} {sitting}"), steal, lost).await)
            }
            Effect::Read(sitting) => {
                let Some(journal) = self.open() else {
                    return Some(Action::Read(Ok(Kept::default())));
                };
                Action::Read(journal.read(&sitting).await)
            }
            Effect::Keep { sitting, place, note } => match self.open() {
                Some(journal) => Action::Noted(journal.keep(&sitting, place, &note).await),
                None => Action::Noted(Err(Fault::None)),
            },
            Effect::Erase { sitting, over } => match self.open() {
                Some(journal) => Action::Erased(journal.erase(&sitting, over.as_deref()).await),
                None => Action::Erased(Ok(())),
            },
            Effect::Post { url, body } => Action::Posted(posted(&url, &body).await),
            _ => return None,
        })
    }

    fn open(&self) -> Option<Rc<Journal>> {
        self.journal.borrow().clone()
    }

    /// Opens the store, and finds who the person is here.
    async fn known(&self, study: &str) -> Result<String, Fault> {
        let act = self.act.clone();
        let journal = Rc::new(Journal::open(move || act.emit(Action::Broke(Fault::Newer))).await?);
        let pseudonym = journal.pseudonym(study).await?;
        *self.journal.borrow_mut() = Some(journal);
        Ok(pseudonym)
    }
}

/// The study's file.
async fn fetched(file: &str) -> Result<(Box<Study>, Source), Trouble> {
    let absent = |error: JsValue| Trouble::Absent(host::words(&error));
    let url = host::beside(file).map_err(absent)?.href();
    let window = web_sys::window().ok_or(Trouble::Unnamed)?;
    let response = JsFuture::from(window.fetch_with_str(&url)).await.map_err(absent)?;
    let response: Response = response.unchecked_into();
    if !response.ok() {
        return Err(Trouble::Absent(response.status().to_string()));
    }
    let text = JsFuture::from(response.text().map_err(absent)?).await.map_err(absent)?;
    read(&text.as_string().unwrap_or_default(), Source::Hosted)
}

/// The study that the link holds.
async fn linked() -> Result<(Box<Study>, Source), Trouble> {
    let hash = web_sys::window().and_then(|w| w.location().hash().ok()).unwrap_or_default();
    let packed = hash.strip_prefix(INLINE).ok_or(Trouble::Unnamed)?;
    let text = unpack(packed, LONGEST).await.map_err(Trouble::Bad)?;
    read(&text, Source::Linked)
}

fn read(text: &str, source: Source) -> Result<(Box<Study>, Source), Trouble> {
    if text.len() > MAX_BYTES {
        return Err(Trouble::Bad("it is too large".to_owned()));
    }
    let study = Study::read(text).map_err(|error| Trouble::Bad(error.to_string()))?;
    Ok((Box::new(study), source))
}

/// Posts JSON; whether it arrived.
async fn posted(url: &str, body: &str) -> Result<(), String> {
    let words = |error: JsValue| host::words(&error);
    let window = web_sys::window().ok_or("no window")?;
    let init = RequestInit::new();
    init.set_method("POST");
    init.set_body(&body.into());
    let headers = Object::new();
    Reflect::set(&headers, &"Content-Type".into(), &"application/json".into()).map_err(words)?;
    init.set_headers(&headers);
    if let Some(signal) = patience(PATIENCE) {
        Reflect::set(&init, &"signal".into(), &signal).map_err(words)?;
    }
    // Nothing of it follows to another host than the one that is listed.
    Reflect::set(&init, &"redirect".into(), &"error".into()).map_err(words)?;
    let response =
        JsFuture::from(window.fetch_with_str_and_init(url, &init)).await.map_err(words)?;
    let response: Response = response.unchecked_into();
    if response.ok() { Ok(()) } else { Err(response.status().to_string()) }
}

/// Posts a form, which leaves the page.
fn submit(url: &str, fields: &[(String, String)]) {
    let made = || -> Result<(), JsValue> {
        let document = web_sys::window().and_then(|w| w.document()).ok_or("no document")?;
        let form: HtmlFormElement = document.create_element("form")?.unchecked_into();
        form.set_method("post");
        form.set_action(url);
        form.set_hidden(true);
        for (name, value) in fields {
            let field: HtmlInputElement = document.create_element("input")?.unchecked_into();
            field.set_type("hidden");
            field.set_name(name);
            field.set_value(value);
            form.append_child(&field)?;
        }
        document.body().ok_or("no body")?.append_child(&form)?;
        form.submit()
    };
    if let Err(error) = made() {
        host::report(&host::words(&error));
    }
}

/// Goes to another address.
fn leave(url: &str) {
    if let Some(window) = web_sys::window() {
        // An address that cannot be gone to leaves one where one is.
        let _ = window.location().assign(url);
    }
}
