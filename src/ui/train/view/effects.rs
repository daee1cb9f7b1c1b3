//! Carries the workbench's effects out: its engine, downloads, and what it tells the page.

use crate::ui::page::view::host;
use crate::ui::page::view::save::{save, save_bytes};
use crate::ui::page::view::worker::Engine;
use crate::ui::train::action::Action;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::Program;
use gloo_timers::callback::Timeout;
use js_sys::Function;
use wasm_bindgen::JsValue;
use yew::Callback;

/// Carries effects out, and tells the workbench what comes of them.
pub(super) struct Effects {
    act: Callback<Action>,
    tell: Function,
    learner: Option<Engine>,
}

impl Effects {
    /// Results go to `act`, news of the workbench to the page's `tell`.
    pub(super) fn new(act: Callback<Action>, tell: Function) -> Effects {
        Effects { act, tell, learner: None }
    }

    /// Carries effects out, in order.
    pub(super) fn run(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            if let Err(error) = self.carry_out(effect) {
                self.act.emit(Action::EngineBroke(Program::Learner, host::words(&error)));
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
                self.learner = Some(Engine::spawn(program, &told)?);
            }
            Effect::Post(_, envelope) => {
                if let Some(engine) = &self.learner {
                    engine.post(&envelope)?;
                }
            }
            Effect::Watch(program, watch, ms) => {
                let act = self.act.clone();
                Timeout::new(ms, move || act.emit(Action::Look(program, watch))).forget();
            }
            Effect::Tell(news) => {
                let [kind, text, corpus] = news.words();
                self.tell.call3(&JsValue::NULL, &kind.into(), &text.into(), &corpus.into())?;
            }
            Effect::Save { name, text } => save(&name, &text)?,
            Effect::GiveBack(file) => save_bytes(&file.name, &file.bytes)?,
        }
        Ok(())
    }
}
