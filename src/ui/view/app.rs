//! The root component: holds the state, hands every action to the reducer and every effect to [`Effects`].

use super::answer::AnswerPanel;
use super::controls::Controls;
use super::corpus::CorpusPanel;
use super::effects::Effects;
use super::files;
use super::host;
use super::notice::EngineNotice;
use super::stage::Stage;
use super::talk::Talk;
use super::train::TrainPanel;
use crate::ui::{Action, State, reduce};
use crate::worker::protocol::Program;
use web_sys::DragEvent;
use yew::{Callback, Component, Context, Html, classes, html};

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
        act.emit(Action::Opened);
        App { state: State::new(), effects: Effects::new(act), dragging: false }
    }

    fn update(&mut self, _ctx: &Context<Self>, message: Message) -> bool {
        match message {
            Message::Page(action) => {
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
        html! {
            <div class={classes!("page", self.dragging.then_some("dragging"))}
                ondragover={drag(true)} ondragleave={drag(false)} ondrop={drop}>
                <header class="masthead">
                    <h1>{"Groundling"}</h1>
                    <p>{"Show it what sentences mean. Then tell it what to do."}</p>
                </header>
                <EngineNotice program={Program::Talker} health={state.talker.health.clone()} act={act.clone()} />
                <EngineNotice program={Program::Learner} health={state.learner.health.clone()} act={act.clone()} />
                <main class="columns">
                    <section id="room" class="card room" aria-labelledby="room-title">
                        <Stage shown={state.shown().clone()} choice={state.world.choice}
                            can_undo={state.world.can_undo()} preferences={state.preferences}
                            act={act.clone()} />
                        <Controls playback={state.playback.clone()} act={act.clone()} />
                    </section>
                    <div class="column">
                        <TrainPanel progress={state.progress.clone()} model={state.model.clone()}
                            notice={state.model_notice.clone()} training={state.is_training()}
                            can_train={state.can_train()}
                            commands={state.corpus.as_ref().map_or(0, |c| c.report.rows.len())}
                            act={act.clone()} />
                        <section class="card" aria-labelledby="talk-title">
                            <Talk command={state.command.clone()} can_ask={state.can_ask()}
                                asking={state.is_asking()} taught={state.model.is_some()}
                                notice={state.ask_notice.clone()} act={act.clone()} />
                            <AnswerPanel answer={state.answer.clone()} />
                        </section>
                        <CorpusPanel corpus={state.corpus.clone()} notice={state.file_notice.clone()}
                            theme={state.preferences.theme} act={act.clone()} />
                    </div>
                </main>
                <footer class="foot">
                    <p>{"Everything runs in this page. Nothing that you type or open leaves your machine."}</p>
                </footer>
                <p class="unseen" role="status" aria-live="polite" data-testid="announcement">
                    { &state.announcement }
                </p>
            </div>
        }
    }
}
