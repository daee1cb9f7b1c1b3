//! What came of the paper's six sentences: how they are answered, and what was done about one that was never heard.

use crate::ui::train::experiments::words::Text;
use crate::worker::protocol::Demonstrated;
use yew::{Html, html};

/// What came of them.
pub(super) fn six(found: &Demonstrated, text: &Text) -> Html {
    let Demonstrated { run, answer } = found;
    let reading = answer.readings.first();
    let formula = reading
        .map(|reading| reading.formula.iter().map(|piece| piece.text.as_str()).collect::<String>());
    let plan = answer.plan.as_ref().filter(|plan| plan.reason.is_none());
    html! {
        <div class="result" data-testid="six-found">
            <p>{ (text.six_learned)(run.examples, run.judgement.plain.correct) }</p>
            <p>{ text.never_heard }{" "}<strong>{ &answer.command }</strong></p>
            if let Some(formula) = formula { <p><code>{ formula }</code></p> }
            if let Some(plan) = plan { <p>{ (text.carried_out)(plan.actions.len()) }</p> }
            if let Some(reason) = answer.reason.as_ref().or(answer.plan.as_ref().and_then(|plan| plan.reason.as_ref())) {
                <p>{ (text.not_done)(reason) }</p>
            }
            <p class="dim">{ text.paper_six }</p>
        </div>
    }
}
