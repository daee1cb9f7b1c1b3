//! Messages: a notice beside what it is about, problems by line, and the engine that has stopped.

use crate::ui::Action;
use crate::ui::engine::{Engine, Health};
use crate::ui::text::Text;
use crate::worker::protocol::Problem;
use yew::{Callback, Html, classes, html};

/// So many problems are listed one by one.
const LISTED: usize = 100;

/// A message where the person is looking; nothing when there is none.
pub(super) fn notice(text: Option<&str>, id: &'static str) -> Html {
    let Some(text) = text else { return Html::default() };
    html! { <p class="notice" role="alert" data-testid={id}>{ text }</p> }
}

/// Problems of a file, by line and column.
pub(super) fn problems(text: &Text, problems: &[Problem]) -> Html {
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

/// The engine that has stopped: what happened, and a new one.
pub(super) fn engine_notice(text: &Text, engine: &Engine, act: &Callback<Action>) -> Html {
    let program = engine.program();
    let Health::Stopped(why) = &engine.health else { return Html::default() };
    html! {
        <section class="notice bad engine" role="alert" data-testid="engine-stopped">
            <h2>{ text.engine_stopped }</h2>
            <p>{ text.engine_kept }</p>
            <pre tabindex="0" data-testid="engine-report">{ why }</pre>
            <button type="button" class="primary" data-testid="restart-engine"
                onclick={act.reform(move |_| Action::RestartEngine(program))}>
                { text.engine_restart }</button>
        </section>
    }
}
