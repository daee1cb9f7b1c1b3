//! Messages: a notice beside what it is about, problems by line, and the engine that has stopped.

use super::words::use_text;
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
    let text = use_text();
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
                        { if problem.line > 0 { (text.line)(problem.line) } else { text.file.to_owned() } }
                        if let Some(column) = &problem.column { {", "}<code>{ column }</code> }
                        { if problem.kept { text.row_kept } else { "" } }
                    </span>
                    { &problem.message }
                </li>
            }) }
            if rest > 0 { <li>{ (text.and_more)(rest) }</li> }
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
    let text = use_text();
    let program = props.program;
    let Health::Stopped(why) = &props.health else { return Html::default() };
    html! {
        <section class="notice bad engine" role="alert" data-testid="engine-stopped">
            <h2>{ text.engine_stopped }</h2>
            <p>{ text.engine_kept }</p>
            <pre tabindex="0" data-testid="engine-report">{ why }</pre>
            <button type="button" class="primary" data-testid="restart-engine"
                onclick={props.act.reform(move |_| Action::RestartEngine(program))}>
                { text.engine_restart }</button>
        </section>
    }
}
