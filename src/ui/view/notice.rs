//! Messages: a notice beside what it is about, problems by line, and the engine that has stopped.

use crate::ui::Action;
use crate::ui::engine::Health;
use crate::worker::protocol::{Problem, Program};
use yew::{AttrValue, Callback, Html, Properties, classes, component, html};

/// So many problems are listed one by one.
const LISTED: usize = 100;

#[derive(PartialEq, Properties)]
pub(super) struct NoticeProps {
    pub(super) text: Option<String>,
    pub(super) id: AttrValue,
}

/// A message where the person is looking; nothing when there is none.
#[component]
pub(super) fn Notice(props: &NoticeProps) -> Html {
    let Some(text) = &props.text else { return Html::default() };
    html! { <p class="notice" role="alert" data-testid={props.id.clone()}>{ text }</p> }
}

#[derive(PartialEq, Properties)]
pub(super) struct ProblemsProps {
    pub(super) problems: Vec<Problem>,
}

/// Problems of a file, by line and column.
#[component]
pub(super) fn Problems(props: &ProblemsProps) -> Html {
    let problems = &props.problems;
    if problems.is_empty() {
        return Html::default();
    }
    let rest = problems.len().saturating_sub(LISTED);
    html! {
        <ul class="problems" data-testid="problems">
            { for problems.iter().take(LISTED).map(|problem| html! {
                <li class={classes!(if problem.kept { "kept" } else { "lost" })} data-testid="problem">
                    <span class="where">
                        { if problem.line > 0 { format!("line {}", problem.line) } else { "file".to_owned() } }
                        if let Some(column) = &problem.column { {", "}<code>{ column }</code> }
                        { if problem.kept { " · row kept" } else { "" } }
                    </span>
                    { &problem.message }
                </li>
            }) }
            if rest > 0 { <li>{ format!("and {rest} more") }</li> }
        </ul>
    }
}

#[derive(PartialEq, Properties)]
pub(super) struct EngineProps {
    pub(super) program: Program,
    pub(super) health: Health,
    pub(super) act: Callback<Action>,
}

/// The engine that has stopped: what happened, and a new one.
#[component]
pub(super) fn EngineNotice(props: &EngineProps) -> Html {
    let Health::Stopped(why) = &props.health else { return Html::default() };
    let program = props.program;
    html! {
        <section class="notice bad engine" role="alert" data-testid="engine-stopped">
            <h2>{"The engine has stopped"}</h2>
            <p>{"What you loaded and taught is kept. Start it again and go on."}</p>
            <pre tabindex="0" data-testid="engine-report">{ why }</pre>
            <button type="button" class="primary" data-testid="restart-engine"
                onclick={props.act.reform(move |_| Action::RestartEngine(program))}>{"Start it again"}</button>
        </section>
    }
}
