//! The root component of the workbench: holds the state, hands every action to the reducer and every effect to
//! [`Effects`]. While it is not to be seen it draws nothing, and goes on with its work.

use super::effects::Effects;
use super::tabs::tabs;
use crate::ui::page::view::foot::foot;
use crate::ui::page::view::stopped::stopped;
use crate::ui::page::view::{files, host};
use crate::ui::page::words::Text as Common;
use crate::ui::train::action::{Action, Tab};
use crate::ui::train::data;
use crate::ui::train::data::view::panel as data_panel;
use crate::ui::train::experiments::view::panel as experiments_panel;
use crate::ui::train::kept::view::{of_results, of_run, panel as kept_panel};
use crate::ui::train::lexicon::view::panel as lexicon_panel;
use crate::ui::train::run::view::panel as run_panel;
use crate::ui::train::state::State;
use crate::ui::train::study::view::panel as study_panel;
use crate::ui::train::update::reduce;
use js_sys::Function;
use web_sys::{DragEvent, Element, File};
use yew::{AppHandle, Callback, Component, Context, Html, Properties, classes, html};

/// The workbench, mounted.
pub struct Handle(AppHandle<Workbench>);

/// Mounts it in an element; what it tells the page goes to `tell`.
pub fn mount(place: Element, tell: Function) -> Handle {
    Handle(yew::Renderer::<Workbench>::with_root_and_props(place, Props { tell }).render())
}

impl Handle {
    /// Tells it something.
    pub fn act(&self, action: Action) {
        self.0.send_message(Message::Bench(action));
    }

    /// Brings it files, which it reads.
    pub fn bring(&self, files: Vec<File>) {
        let act = self.0.callback(Message::Bench);
        files::read_all(files, &act.reform(|files| Action::Data(data::Action::Offered(files))));
    }
}

#[derive(PartialEq, Properties)]
struct Props {
    tell: Function,
}

struct Workbench {
    state: State,
    effects: Effects,
    dragging: bool,
}

enum Message {
    Bench(Action),
    Drag(bool),
}

impl Component for Workbench {
    type Message = Message;
    type Properties = Props;

    fn create(ctx: &Context<Self>) -> Workbench {
        let act = ctx.link().callback(Message::Bench);
        act.emit(Action::Prefers(host::preferences()));
        let cores = web_sys::window().map_or(1.0, |w| w.navigator().hardware_concurrency());
        act.emit(Action::Cores(cores as u32));
        host::watch_preferences(&act.reform(Action::Prefers));
        let address = web_sys::window().and_then(|window| window.location().hash().ok());
        if address.as_deref() == Some("#study") {
            act.emit(Action::Turn(Tab::Study));
        }
        let effects = Effects::new(act, ctx.props().tell.clone());
        Workbench { state: State::default(), effects, dragging: false }
    }

    fn update(&mut self, _ctx: &Context<Self>, message: Message) -> bool {
        match message {
            Message::Bench(action) => {
                let shown = self.state.shown;
                self.state.desk.clock = host::now();
                let effects = reduce(&mut self.state, action);
                self.effects.run(effects);
                shown || self.state.shown
            }
            Message::Drag(dragging) => std::mem::replace(&mut self.dragging, dragging) != dragging,
        }
    }

    fn rendered(&mut self, _ctx: &Context<Self>, _first: bool) {
        self.effects.drawn();
    }

    fn view(&self, ctx: &Context<Self>) -> Html {
        let State { desk, shown, tab, data, run, experiments, lexicon, study, kept } = &self.state;
        if !shown {
            return Html::default();
        }
        let act: Callback<Action> = ctx.link().callback(Message::Bench);
        let drag = |over: bool| {
            ctx.link().callback(move |event: DragEvent| {
                event.prevent_default();
                Message::Drag(over)
            })
        };
        let offer = act.reform(|files| Action::Data(data::Action::Offered(files)));
        let drop = {
            let (offer, link) = (offer.clone(), ctx.link().clone());
            Callback::from(move |event: DragEvent| {
                event.prevent_default();
                link.send_message(Message::Drag(false));
                files::read_all(files::dropped(&event), &offer);
            })
        };
        let common = Common::of(desk.language);
        html! {
            <div class={classes!("page", self.dragging.then_some("dragging"))} data-drop={common.drop_here}
                ondragover={drag(true)} ondragleave={drag(false)} ondrop={drop}>
                { stopped(desk.language, &desk.learner, &act.reform(Action::RestartEngine)) }
                <main>
                    { tabs(desk.language, *tab, &act.reform(Action::Turn)) }
                    <div role="tabpanel" id="part" aria-labelledby={format!("tab-{}", tab.name())}>
                        { match tab {
                            Tab::Data => data_panel(data, desk, &act.reform(Action::Data)),
                            Tab::Run => run_panel(run, desk, data.commands(), of_run(kept, desk.language, run.run.is_some()), &act.reform(Action::Run), &offer),
                            Tab::Experiments => experiments_panel(experiments, desk, of_results(kept, desk.language), data.held_out(),
                                desk.is_ready() && data.commands() > 0, &act.reform(Action::Experiments)),
                            Tab::Study => study_panel(study, desk, &act.reform(Action::Study)),
                            Tab::Kept => kept_panel(kept, desk, [data.sheet.is_some(), desk.in_use.is_some()], &act.reform(Action::Kept)),
                            Tab::Lexicon => lexicon_panel(lexicon, desk, self.state.confused(), &act.reform(Action::Lexicon)),
                        } }
                    </div>
                </main>
                { foot(desk.language) }
            </div>
        }
    }
}
