//! Carries effects out: the workers, timers, downloads, links, and the workbench.
use super::address;
use super::bench::Link;
use crate::ui::app::action::Action;
use crate::ui::app::state::State;
use crate::ui::page::effect::Effect;
use crate::ui::page::view::drawn::{Deed, Drawn};
use crate::ui::page::view::forms::{self, Forms};
use crate::ui::page::view::host::{self, beside};
use crate::ui::page::view::keeper::Keeper;
use crate::ui::page::view::save::save;
use crate::ui::page::view::worker::Engine;
use crate::ui::talk;
use crate::worker::protocol::{Program, decode_said};
use gloo_timers::callback::Timeout;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::spawn_local;
use web_sys::File;
use yew::Callback;

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
    bench: Link,
    drawn: Drawn,
}

impl Effects {
    /// Results go to `act`.
    pub(super) fn new(act: Callback<Action>) -> Effects {
        let keeper = Keeper::new(act.reform(Action::Stored));
        let bench = Link::new(act.clone());
        Effects { act, keeper, talker: None, learner: None, bench, drawn: Drawn::default() }
    }

    /// Brings files to the workbench.
    pub(super) fn bring(&mut self, files: Vec<File>) {
        self.bench.bring(files);
    }

    /// Tells the workbench what has changed on the page.
    pub(super) fn keep_up(&mut self, state: &State) {
        self.bench.keep_up(state);
    }

    /// What the effects asked for is drawn.
    pub(super) fn drawn(&mut self) {
        self.drawn.is();
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
                let told = self.act.reform(move |said| match said {
                    Ok(envelope) => Action::Heard(program, envelope),
                    Err(why) => Action::EngineBroke(program, why),
                });
                let engine = Engine::spawn(program, decode_said, &told)?;
                if program == Program::Talker {
                    engine.give(&own_program()?)?;
                }
                *self.engine(program) = Some(engine);
            }
            Effect::Post(program, envelope) => {
                if let Some(engine) = self.engine(program) {
                    engine.post(&envelope)?;
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
            Effect::Share(packed) => address::share(packed, self.act.clone()),
            Effect::SaveSession(packed) => {
                self.save_as("groundling.json", packed, Forms::write_session);
            }
            Effect::SaveLessons(packed) => {
                self.save_as("taught.jsonl", packed, Forms::write_lessons);
            }
            Effect::ReadSession(text) => {
                let act = self.act.reform(Action::Talk);
                spawn_local(
                    async move { act.emit(talk::Action::Open(forms::session(text).await)) },
                );
            }
            Effect::ReadWorld(text) => {
                let act = self.act.reform(Action::Talk);
                spawn_local(async move {
                    act.emit(talk::Action::WorldRead(forms::world(text).await));
                });
            }
            Effect::Copy(text) => {
                let act = self.act.clone();
                spawn_local(async move { act.emit(Action::Copied(host::copy(&text).await)) });
            }
            Effect::Focus(id) => self.drawn.then(Deed::Focus, id),
            Effect::FocusOnDesk(id) => self.drawn.then(Deed::FocusOnDesk, id),
            Effect::Reveal(id) => self.drawn.then(Deed::Reveal, id),
            Effect::Save { name, text } => save(&name, &text)?,
            Effect::LoadWorkbench => self.bench.load(),
        }
        Ok(())
    }

    /// Gets a file beside the page, and tells the page of its text.
    fn fetch(&self, name: String, told: fn(Result<String, String>) -> Action) {
        let act = self.act.clone();
        spawn_local(async move {
            act.emit(told(host::text(&name).await.map_err(|error| host::words(&error))));
        });
    }

    /// Offers what is packed to the person as a file, once what writes its text has come; says so if it does not.
    fn save_as(&self, name: &'static str, packed: Vec<u8>, write: fn(&Forms, &[u8]) -> String) {
        let act = self.act.clone();
        spawn_local(async move {
            let saved = forms::forms().await.and_then(|forms| {
                save(name, &write(&forms, &packed)).map_err(|error| host::words(&error))
            });
            if let Err(why) = saved {
                act.emit(Action::Talk(talk::Action::Unsaved(why)));
            }
        });
    }

    const fn engine(&mut self, program: Program) -> &mut Option<Engine> {
        match program {
            Program::Talker => &mut self.talker,
            Program::Learner => &mut self.learner,
        }
    }
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
