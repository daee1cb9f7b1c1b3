//! Carries the workbench's effects out: its engine, downloads, and what it tells the page.

use crate::study::link::{INLINE, LONGEST};
use crate::ui::page::engine::Errand;
use crate::ui::page::view::drawn::{Deed, Drawn};
use crate::ui::page::view::host;
use crate::ui::page::view::packed::pack;
use crate::ui::page::view::save::{save, save_bytes};
use crate::ui::page::view::worker::Engine;
use crate::ui::train::action::Action;
use crate::ui::train::effect::Effect;
use crate::ui::train::experiments::pool::Said;
use crate::ui::train::kept::view::Shelf;
use crate::ui::train::{experiments, kept, run, study};
use crate::worker::protocol::{Program, decode};
use gloo_timers::callback::Timeout;
use js_sys::Function;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::spawn_local;
use yew::Callback;

/// Carries effects out, and tells the workbench what comes of them.
pub(super) struct Effects {
    act: Callback<Action>,
    tell: Function,
    learner: Option<Engine>,
    shelf: Shelf,
    /// The engines of the pool, by their seats.
    pool: Vec<Option<Engine>>,
    drawn: Drawn,
}

impl Effects {
    /// Results go to `act`, news of the workbench to the page's `tell`.
    pub(super) fn new(act: Callback<Action>, tell: Function) -> Effects {
        let shelf = Shelf::new(act.reform(|news| Action::Kept(kept::Action::Heard(news))));
        let drawn = Drawn::default();
        Effects { act, tell, learner: None, shelf, pool: Vec::new(), drawn }
    }

    /// What the effects asked for is drawn.
    pub(super) fn drawn(&mut self) {
        self.drawn.is();
    }

    /// Carries effects out, in order.
    pub(super) fn run(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            let seat = match &effect {
                Effect::Pool(seat, _) => Some(*seat),
                _ => None,
            };
            if let Err(error) = self.carry_out(effect) {
                let why = host::words(&error);
                self.act.emit(match seat {
                    Some(seat) => of_pool(seat, Said::Broke(why)),
                    None => Action::EngineBroke(Program::Learner, why),
                });
            }
        }
    }

    fn carry_out(&mut self, effect: Effect) -> Result<(), JsValue> {
        match effect {
            Effect::SpawnEngine(program) => {
                self.learner = None;
                let told = self.act.reform(move |said| match said {
                    Ok(envelope) => Action::Heard(program, envelope),
                    Err(why) => Action::EngineBroke(program, why),
                });
                self.learner = Some(Engine::spawn(program, decode, &told)?);
            }
            Effect::Pool(seat, errand) => self.do_for(seat, errand)?,
            Effect::EndPool => self.pool.clear(),
            Effect::Post(_, envelope) => {
                if let Some(engine) = &self.learner {
                    engine.post(&envelope)?;
                }
            }
            Effect::Watch(program, watch, ms) => {
                let act = self.act.clone();
                Timeout::new(ms, move || act.emit(Action::Look(program, watch))).forget();
            }
            Effect::Ring(number, ms) => {
                let act = self.act.clone();
                Timeout::new(ms, move || act.emit(Action::Run(run::Action::Rang(number)))).forget();
            }
            Effect::Store(ask) => self.shelf.ask(ask),
            Effect::Tell(news) => {
                let [kind, text, corpus] = news.words();
                self.tell.call3(&JsValue::NULL, &kind.into(), &text.into(), &corpus.into())?;
            }
            Effect::Reveal(id) => self.drawn.then(Deed::Reveal, id),
            Effect::Pack(text) => {
                let act = self.act.clone();
                spawn_local(async move {
                    let link = packed(&text).await;
                    act.emit(Action::Study(study::Action::Linked(link)));
                });
            }
            Effect::Save { name, text } => save(&name, &text)?,
            Effect::GiveBack(file) => save_bytes(&file.name, &file.bytes)?,
        }
        Ok(())
    }

    /// Does something for an engine of the pool.
    fn do_for(&mut self, seat: u32, errand: Errand) -> Result<(), JsValue> {
        let place = seat as usize;
        match errand {
            Errand::Spawn(program) => {
                let told = self.act.reform(move |said: Result<_, String>| {
                    of_pool(seat, said.map_or_else(Said::Broke, Said::Heard))
                });
                if self.pool.len() <= place {
                    self.pool.resize_with(place + 1, || None);
                }
                self.pool[place] = None;
                self.pool[place] = Some(Engine::spawn(program, decode, &told)?);
            }
            Errand::Post(_, envelope) => {
                if let Some(Some(engine)) = self.pool.get(place) {
                    engine.post(&envelope)?;
                }
            }
            Errand::Watch(_, watch, ms) => {
                let act = self.act.clone();
                Timeout::new(ms, move || act.emit(of_pool(seat, Said::Look(watch)))).forget();
            }
        }
        Ok(())
    }
}

/// What stands behind an address that holds a study; nothing when it would be too long.
async fn packed(study: &str) -> Option<String> {
    let packed = pack(&web_sys::window()?, study).await.ok()?;
    (packed.len() <= LONGEST).then(|| format!("{INLINE}{packed}"))
}

/// What an engine of the pool said.
const fn of_pool(seat: u32, said: Said) -> Action {
    Action::Experiments(experiments::Action::Told(seat, said))
}
