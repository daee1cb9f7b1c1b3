//! The root component: holds the state, hands every action to the reducer and every effect to [`Effects`].

use super::answer::AnswerPanel;
use super::effects::Effects;
use super::masthead::Masthead;
use super::notice::EngineNotice;
use super::planner::Planner;
use super::readings::Readings;
use super::room::room;
use super::rules::Rules;
use super::share::SharePanel;
use super::study::StudyPanel;
use super::talk::Talk;
use super::teach::Lessons;
use super::{address, files, host, workbench};
use crate::ui::action::{Depth, View};
use crate::ui::room::Mode;
use crate::ui::text::Language;
use crate::ui::{Action, State, overlay, reduce, why};
use crate::worker::protocol::{Program, Request};
use web_sys::DragEvent;
use yew::{Callback, Component, Context, ContextProvider, Html, classes, html};

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
            <ContextProvider<Language> context={state.language}>
                <div class={classes!("page", self.dragging.then_some("dragging"))} data-drop={text.drop_here}
                    ondragover={drag(true)} ondragleave={drag(false)} ondrop={drop}>
                    if state.view == View::Talk { <a class="skip" href="#command">{ text.skip }</a> }
                    <Masthead view={state.view} depth={state.depth} language={state.language}
                        can_undo={state.history.can_undo()} can_redo={state.history.can_redo()} act={act.clone()} />
                    <EngineNotice program={Program::Talker} health={state.talker.health.clone()} act={act.clone()} />
                    <EngineNotice program={Program::Learner} health={state.learner.health.clone()} act={act.clone()} />
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
            </ContextProvider<Language>>
        }
    }
}

/// The view in which one talks to the robot, as deep as the person wants to look.
fn talk(state: &State, act: &Callback<Action>) -> Html {
    let answer = state.heard();
    let said = state.document.said.as_ref().filter(|_| state.talk.live.is_none());
    let see = state.depth >= Depth::See;
    html! {
        <main class="columns talk" data-depth={format!("{:?}", state.depth).to_lowercase()}>
            <SharePanel sharing={state.sharing.clone()} act={act.clone()} />
            <section class="card command" aria-label={state.text().tell}>
                <Talk command={state.talk.input.clone()} can_ask={state.can_ask()} asking={state.is_asking()}
                    notice={state.talk.notice.clone()} model_notice={state.model_notice.clone()} act={act.clone()} />
                if let Some(answer) = answer {
                    <AnswerPanel words={answer.words.clone()} reading={state.heard_reading().cloned()}
                        live={state.talk.live.is_some()} messages={why::messages(state)}
                        link={state.talk.link} act={act.clone()} />
                }
            </section>
            { room(state, act) }
            <div class="column side">
                <Lessons lessons={state.document.lessons.clone()} teach={state.teach.clone()} act={act.clone()} />
                if see && state.room.mode == Mode::Watch {
                    if let Some(said) = said { if !said.answer.readings.is_empty() {
                        <Readings answer={said.answer.clone()} world={said.world.clone()} chosen={said.chosen}
                            link={state.talk.link} theme={state.preferences.theme} act={act.clone()} />
                    } }
                    <Planner watch={state.watch.clone()} plan={state.document.plan().cloned()}
                        range={overlay::values_range(state)} depth={state.depth} theme={state.preferences.theme}
                        rolling={state.talker.is_at(|r| matches!(r, Request::RollOut { .. }))} act={act.clone()} />
                    <Rules rules={state.document.rules} act={act.clone()} />
                }
            </div>
            if state.depth == Depth::Study {
                if let Some((said, reading)) = said.zip(state.document.reading()) {
                    <StudyPanel words={said.answer.words.clone()} reading={reading.clone()}
                        study={state.talk.studies.as_ref().and_then(|all| all.get(said.chosen)).cloned()}
                        link={state.talk.link} node={state.talk.node} steps={state.talk.steps} act={act.clone()} />
                }
            }
        </main>
    }
}
