//! The root component: holds the state, hands every action to the reducer and every effect to [`Effects`].

use super::address;
use super::effects::Effects;
use super::kept::kept as session;
use super::keys;
use super::masthead::masthead;
use super::stopped::stopped;
use crate::ui::app::action::{Action, View};
use crate::ui::app::state::State;
use crate::ui::app::update::reduce;
use crate::ui::app::words::Text;
use crate::ui::help::view::help;
use crate::ui::kept::view::kept;
use crate::ui::page::language::Language;
use crate::ui::page::view::{files, host};
use crate::ui::page::words::Text as Common;
use crate::ui::talk::view::talk as conversation;
use crate::ui::train::view::workbench;
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
        keys::watch(&act);
        host::watch_hidden(&act.reform(|()| Action::Hidden));
        App { state: State::default(), effects: Effects::new(act), dragging: false }
    }

    fn update(&mut self, _ctx: &Context<Self>, message: Message) -> bool {
        match message {
            Message::Page(action) => {
                self.state.shared.clock = host::now();
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
            let (act, link) = (act.reform(Action::Offered), ctx.link().clone());
            Callback::from(move |event: DragEvent| {
                event.prevent_default();
                link.send_message(Message::Drag(false));
                files::read_all(event.data_transfer().and_then(|d| d.files()), &act);
            })
        };
        let State { shared, view, talk: talking, train, help: guide } = &self.state;
        let text = Text::of(shared.language);
        html! {
                <div class={classes!("page", self.dragging.then_some("dragging"))} data-drop={text.drop_here}
                    ondragover={drag(true)} ondragleave={drag(false)} ondrop={drop}>
                    if *view == View::Talk { <a class="skip" href="#command">{ text.skip }</a> }
                    { masthead(&self.state, &act) }
                    { stopped(shared.language, &shared.talker, &act) }
                    { stopped(shared.language, &shared.learner, &act) }
                    { session(shared, &act) }
                    { match view {
                        View::Talk => conversation(talking, shared, &act.reform(Action::Talk)),
                        View::Kept => kept(shared, &act.reform(Action::Offered)),
                        View::Help => help(guide, talking.shown(shared)),
                        View::Train => workbench(train, shared, &act.reform(Action::Train)),
                    } }
                    <footer class="foot">
                        <p>{ text.stays_here }{" "}<a href="#kept" data-testid="view-kept">{ Common::of(shared.language).what_is_kept }</a></p>
                    </footer>
                    <p class="unseen" role="status" aria-live="polite" data-testid="announcement">
                        { &shared.announcement }
                    </p>
                </div>
        }
    }
}
