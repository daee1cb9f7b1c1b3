//! The root component: holds the state, hands every action to the reducer and every effect to [`Effects`].
use super::address;
use super::coming::coming;
use super::effects::Effects;
use super::kept::kept as session;
use super::keys;
use super::masthead::masthead;
use crate::ui::app::action::{Action, View};
use crate::ui::app::state::{Bench, State};
use crate::ui::app::update::reduce;
use crate::ui::app::words::Text;
use crate::ui::help::view::help;
use crate::ui::kept::view::kept;
use crate::ui::page::language::Language;
use crate::ui::page::view::foot::foot;
use crate::ui::page::view::stopped::stopped;
use crate::ui::page::view::{files, host};
use crate::ui::page::words::Text as Common;
use crate::ui::talk::view::talk as conversation;
use web_sys::{DragEvent, File};
use yew::{Callback, Component, Context, Html, classes, html};

/// Whether there is a page to mount on: a worker has none.
pub fn has_page() -> bool {
    web_sys::window().is_some()
}

/// Mounts the page.
pub fn mount() {
    host::mount::<App>();
}

struct App {
    state: State,
    effects: Effects,
    dragging: bool,
}

enum Message {
    Page(Action),
    Drag(bool),
    /// Files that are not for the robot.
    Bring(Vec<File>),
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
                self.act(action);
                true
            }
            Message::Bring(files) => {
                self.effects.bring(files);
                self.act(Action::Go(View::Train));
                true
            }
            Message::Drag(dragging) => std::mem::replace(&mut self.dragging, dragging) != dragging,
        }
    }

    fn rendered(&mut self, _ctx: &Context<Self>, _first: bool) {
        self.effects.drawn();
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
            let (act, link) = (act.reform(Action::Given), ctx.link().clone());
            Callback::from(move |event: DragEvent| {
                event.prevent_default();
                link.send_message(Message::Drag(false));
                files::sort(files::dropped(&event), act.clone(), link.callback(Message::Bring));
            })
        };
        let State { shared, view, talk: talking, help: guide, bench } = &self.state;
        let (text, common) = (Text::of(shared.language), Common::of(shared.language));
        let again = act.reform(Action::RestartEngine);
        // The workbench has a foot of its own.
        let ends = *view != View::Train || *bench != Bench::Here;
        html! {
                <div class={classes!("page", self.dragging.then_some("dragging"), (!ends).then_some("headed"))} data-drop={common.drop_here}
                    ondragover={drag(true)} ondragleave={drag(false)} ondrop={drop}>
                    if *view == View::Talk { <a class="skip" href="#command">{ text.skip }</a> }
                    { masthead(&self.state, &act) }
                    { stopped(shared.language, &shared.talker, &again) }
                    { stopped(shared.language, &shared.learner, &again) }
                    { session(shared, &act) }
                    { match view {
                        View::Talk => conversation(talking, shared, &act.reform(Action::Talk)),
                        View::Train => coming(&self.state, &act),
                        View::Kept => kept(shared, &act.reform(Action::Given)),
                        View::Help => help(guide, talking.shown(shared)),
                    } }
                    if ends { { foot(shared.language) } }
                    <p class="unseen" role="status" aria-live="polite" data-testid="announcement">
                        { &shared.announcement }
                    </p>
                </div>
        }
    }
}

impl App {
    fn act(&mut self, action: Action) {
        self.state.shared.clock = host::now();
        let effects = reduce(&mut self.state, action);
        self.effects.run(effects);
        self.effects.keep_up(&self.state);
    }
}
