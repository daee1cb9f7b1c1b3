//! The root component: holds the state, hands every action to the reducer and every effect to [`Effects`].

use super::effects::Effects;
use super::page::page;
use super::{rehearse, sight};
use crate::study::Link;
use crate::ui::collect::action::Action;
use crate::ui::collect::state::State;
use crate::ui::collect::update::reduce;
use crate::ui::page::language::Language;
use crate::ui::page::view::host;
use gloo_timers::callback::Timeout;
use js_sys::Date;
use yew::{Callback, Component, Context, Html};

/// Milliseconds between two things that a simulated participant does.
const PACE: u32 = 40;

/// Mounts the page.
pub fn mount() {
    host::mount::<Collect>();
}

struct Collect {
    state: State,
    effects: Effects,
}

enum Message {
    Act(Action),
    /// A simulated participant does the next thing.
    Rehearse,
}

impl Component for Collect {
    type Message = Message;
    type Properties = ();

    fn create(ctx: &Context<Self>) -> Collect {
        let act = ctx.link().callback(Message::Act);
        act.emit(Action::Prefers(host::preferences()));
        host::watch_preferences(&act.reform(Action::Prefers));
        let query = web_sys::window().and_then(|w| w.location().search().ok()).unwrap_or_default();
        let link = Link::of(&query);
        if link.simulate.is_some() {
            rehearse_later(ctx);
        }
        let language = Language::of(&host::language()).unwrap_or_default();
        act.emit(Action::Opened(Box::new(link), language));
        sight::watch(&act);
        Collect { state: State::default(), effects: Effects::new(act) }
    }

    fn update(&mut self, ctx: &Context<Self>, message: Message) -> bool {
        match message {
            Message::Act(action) => {
                let is_seen = !matches!(action, Action::Spent(..) | Action::Rested);
                let effects = reduce(&mut self.state, action, Date::now());
                self.effects.run(effects);
                is_seen
            }
            Message::Rehearse => {
                let act: Callback<Action> = ctx.link().callback(Message::Act);
                rehearse::step(&self.state, &act);
                if self.state.over.is_none() {
                    rehearse_later(ctx);
                }
                false
            }
        }
    }

    fn rendered(&mut self, _ctx: &Context<Self>, _first: bool) {
        self.effects.drawn();
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        page(&self.state, &ctx.link().callback(Message::Act))
    }
}

fn rehearse_later(ctx: &Context<Collect>) {
    let link = ctx.link().clone();
    Timeout::new(PACE, move || link.send_message(Message::Rehearse)).forget();
}
