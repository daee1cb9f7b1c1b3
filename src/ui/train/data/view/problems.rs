//! Problems of a file, line by line.

use crate::ui::train::words::Text;
use crate::worker::protocol::Problem;
use yew::{Html, classes, html};

/// So many problems are listed one by one.
const LISTED: usize = 100;

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
