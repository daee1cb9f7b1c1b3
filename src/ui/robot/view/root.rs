//! The root component: draws what the [`Runtime`] holds. Time goes by in ticks while there is a link; of what comes over it,
//! the page is drawn anew at a beat of its own.

use super::keys;
use super::page::page;
use super::runtime::Runtime;
use crate::ui::page::language::Language;
use crate::ui::page::view::host;
use crate::ui::robot::action::Action;
use crate::ui::robot::state::Link;
use gloo_timers::callback::Interval;
use std::rc::Rc;
use yew::{Component, Context, Html};

/// Milliseconds between two ticks, and between two drawings of what goes by.
const TICK: u32 = 40;
const DRAW: u32 = 80;

/// Mounts the page.
pub fn mount() {
    host::mount::<Robot>();
}

struct Robot {
    runtime: Rc<Runtime>,
    _beats: [Interval; 2],
}

/// What the component is asked to draw for.
enum Draw {
    /// Something was done.
    Done,
    /// Time has gone by.
    Passing,
}

impl Component for Robot {
    type Message = Draw;
    type Properties = ();

    fn create(ctx: &Context<Self>) -> Robot {
        let runtime = Runtime::new(ctx.link().callback(|()| Draw::Done));
        let act = runtime.act.clone();
        let secure = web_sys::window().and_then(|window| window.location().protocol().ok());
        let language = Language::of(&host::language()).unwrap_or_default();
        act.emit(Action::Prefers(host::preferences()));
        act.emit(Action::Opened(language, secure.as_deref() == Some("https:")));
        host::watch_preferences(&act.reform(Action::Prefers));
        host::watch_hidden(&act.reform(|()| Action::Hidden));
        keys::watch(&act);
        let tick = act.clone();
        let tick = Interval::new(TICK, move || tick.emit(Action::Tick(0)));
        let link = ctx.link().clone();
        let draw = Interval::new(DRAW, move || link.send_message(Draw::Passing));
        Robot { runtime, _beats: [tick, draw] }
    }

    fn update(&mut self, _ctx: &Context<Self>, draw: Draw) -> bool {
        match draw {
            Draw::Done => true,
            Draw::Passing => self.runtime.state().link == Link::Open,
        }
    }

    fn view(&self, _ctx: &Context<Self>) -> Html {
        page(&self.runtime.state(), &self.runtime.act)
    }
}
