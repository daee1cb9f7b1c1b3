//! The root component: holds the state, hands every action to the reducer and every effect to [`Effects`]. Time goes by in
//! ticks while there is a link; of what comes over it, the page is drawn anew at the ticks alone.

use super::effects::Effects;
use super::keys;
use super::page::page;
use crate::ui::page::language::Language;
use crate::ui::page::view::host;
use crate::ui::robot::action::Action;
use crate::ui::robot::state::{Link, State};
use crate::ui::robot::update::reduce;
use gloo_timers::callback::Interval;
use yew::{Component, Context, Html};

/// Milliseconds between two ticks.
const TICK: u32 = 40;

/// Mounts the page.
pub fn mount() {
    host::mount::<Robot>();
}

struct Robot {
    state: State,
    effects: Effects,
    _ticks: Interval,
    /// Whether the next tick is one to draw at.
    is_due: bool,
}

impl Component for Robot {
    type Message = Action;
    type Properties = ();

    fn create(ctx: &Context<Self>) -> Robot {
        let act = ctx.link().callback(|action| action);
        let secure = web_sys::window().and_then(|window| window.location().protocol().ok());
        let language = Language::of(&host::language()).unwrap_or_default();
        act.emit(Action::Prefers(host::preferences()));
        act.emit(Action::Opened(language, secure.as_deref() == Some("https:")));
        host::watch_preferences(&act.reform(Action::Prefers));
        host::watch_hidden(&act.reform(|()| Action::Hidden));
        keys::watch(&act);
        let link = ctx.link().clone();
        // How much waits to leave is known when the tick is taken.
        let ticks = Interval::new(TICK, move || link.send_message(Action::Tick(0)));
        Robot { state: State::new(), effects: Effects::new(act), _ticks: ticks, is_due: false }
    }

    fn update(&mut self, _ctx: &Context<Self>, action: Action) -> bool {
        let is_seen = match &action {
            Action::Tick(_) if self.state.link != Link::Open => return false,
            Action::Tick(_) => {
                self.is_due = !self.is_due;
                self.is_due
            }
            Action::LinkHeard(_) => false,
            _ => true,
        };
        let action = match action {
            Action::Tick(_) => Action::Tick(self.effects.backlog()),
            other => other,
        };
        let effects = reduce(&mut self.state, action, host::now());
        self.effects.run(effects);
        is_seen
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        page(&self.state, &ctx.link().callback(|action| action))
    }
}
