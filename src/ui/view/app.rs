//! The root component: holds the state, hands every action to the reducer and every effect to [`Effects`].

use super::answer::answer;
use super::effects::Effects;
use super::masthead::masthead;
use super::notice::engine_notice;
use super::planner::planner;
use super::readings::readings;
use super::room::room;
use super::rules::rules;
use super::share::shared;
use super::study::study;
use super::talk::command;
use super::teach::lessons;
use super::{address, files, host, workbench};
use crate::ui::action::{Depth, View};
use crate::ui::room::Mode;
use crate::ui::text::Language;
use crate::ui::{Action, State, reduce};
use web_sys::DragEvent;
use yew::{Callback, Component, Context, Html, classes, html};

/// Whether there is a page to mount on: a worker has none.
pub fn has_page() -> bool {
    web_sys::window().is_some()
}

/// Mounts the page in `#app`, in place of the skeleton.
pub fn mount() {
    host::report_panics();
    let Some(root) = host::element("app") else {
        host::report("The page has no element #app.");
        return;
    };
    root.set_inner_html("");
    yew::Renderer::<App>::with_root(root).render();
}

struct App {
    state: State,
    effects: Effects,
    dragging: bool,
}

enum Message {
    Page(Action),
    Drag(bool),
}

impl Component for App {
    type Message = Message;
    type Properties = ();

    fn create(ctx: &Context<Self>) -> App {
        let act = ctx.link().callback(Message::Page);
        act.emit(Action::Prefers(host::preferences()));
        host::watch_preferences(&act.reform(Action::Prefers));
        act.emit(Action::Opened(Language::of(&host::language()).unwrap_or_default()));
        address::watch(&act);
        App { state: State::new(), effects: Effects::new(act), dragging: false }
    }

    fn update(&mut self, _ctx: &Context<Self>, message: Message) -> bool {
        match message {
            Message::Page(action) => {
                self.state.clock = host::now();
                let effects = reduce(&mut self.state, action);
                self.effects.run(effects);
                true
            }
            Message::Drag(dragging) => std::mem::replace(&mut self.dragging, dragging) != dragging,
        }
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        let act: Callback<Action> = ctx.link().callback(Message::Page);
        let drag = |over: bool| {
            ctx.link().callback(move |event: DragEvent| {
                event.prevent_default();
                Message::Drag(over)
            })
        };
        let drop = {
            let (act, link) = (act.clone(), ctx.link().clone());
            Callback::from(move |event: DragEvent| {
                event.prevent_default();
                link.send_message(Message::Drag(false));
                files::read_all(event.data_transfer().and_then(|d| d.files()), &act);
            })
        };
        let state = &self.state;
        let text = state.text();
        html! {
                <div class={classes!("page", self.dragging.then_some("dragging"))} data-drop={text.drop_here}
                    ondragover={drag(true)} ondragleave={drag(false)} ondrop={drop}>
                    if state.view == View::Talk { <a class="skip" href="#command">{ text.skip }</a> }
                    { masthead(state, &act) }
                    { engine_notice(text, &state.talker, &act) }
                    { engine_notice(text, &state.learner, &act) }
                    { match state.view {
                        View::Talk => talk(state, &act),
                        View::Train => workbench::workbench(state, &act),
                    } }
                    <footer class="foot">
                        <p>{ text.stays_here }</p>
                    </footer>
                    <p class="unseen" role="status" aria-live="polite" data-testid="announcement">
                        { &state.announcement }
                    </p>
                </div>
        }
    }
}

/// The view in which one talks to the robot, as deep as the person wants to look.
fn talk(state: &State, act: &Callback<Action>) -> Html {
    let watched = state.depth >= Depth::See && state.room.mode == Mode::Watch;
    html! {
        <main class="columns talk" data-depth={format!("{:?}", state.depth).to_ascii_lowercase()}>
            { shared(state, act) }
            <section class="card command" aria-label={state.text().tell}>
                { command(state, act) }
                { answer(state, act) }
            </section>
            { room(state, act) }
            <div class="column side">
                { lessons(state, act) }
                if watched {
                    { readings(state, act) }
                    { planner(state, act) }
                    { rules(state, act) }
                }
            </div>
            if state.depth == Depth::Study { { study(state, act) } }
        </main>
    }
}
