//! The planner: what is shown of its policy in the room, which solver it was and why, what it proved, and how often
//! the policy gets there.
use super::chart::{bounds, interval, legend};
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::room::overlay;
use crate::ui::talk::state::State;
use crate::ui::talk::watch::state::Layer;
use crate::ui::talk::watch::values::RUNS;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Request, Runs};
use yew::{Callback, Html, html};

/// The planner's card.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn planner(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let watch = &state.watch;
    let rolling = shared.talker.is_at(|request| matches!(request, Request::RollOut { .. }));
    let work = watch.reports.last();
    html! {
        <section class="card" aria-labelledby="planner-title" data-testid="planner">
            <h2 id="planner-title">{ text.planner }</h2>
            <div class="rules" role="group" aria-label={text.layers}>
                { for Layer::ALL.into_iter().map(|layer| html! {
                    <label class="check">
                        <input type="checkbox" checked={watch.shows(layer)} data-testid={format!("layer-{layer:?}").to_ascii_lowercase()}
                            onchange={sends(act, Action::ToggleLayer(layer))} />
                        { text.layer_name(layer) }
                    </label>
                }) }
            </div>
            if let Some([low, high]) = overlay::values_range(state, shared) {
                { legend(shared.preferences.theme, &format!("{low:.3}"), &format!("{high:.3}"), text.value_legend) }
            }
            if let Some(work) = work {
                <dl class="facts" data-testid="solver">
                    <div><dt>{ text.solver }</dt><dd data-testid="solver-name">{ text.solver_name(&work.solver) }</dd></div>
                    <div><dt>{ text.why_chosen }</dt><dd>{ (text.chosen)(work.why) }</dd></div>
                    <div><dt>{ text.states }</dt><dd>{ work.states }</dd></div>
                    if let Some(seconds) = watch.seconds {
                        <div><dt>{ text.took }</dt><dd data-testid="took">{ (text.milliseconds)(seconds) }</dd></div>
                    }
                    <div><dt>{ text.worth }</dt><dd>{ proved(work.bounds) }</dd></div>
                    if let Some(percent) = shared.document.plan().and_then(|plan| plan.over()) {
                        <div><dt>{ text.length }</dt><dd data-testid="near">{ (text.near_shortest)(percent) }</dd></div>
                    }
                    if let Some(plan) = shared.document.plan() { if plan.replans > 0 {
                        <div><dt>{ text.replans }</dt><dd data-testid="replans">{ plan.replans }</dd></div>
                    } }
                </dl>
                if shared.depth == Depth::Study && watch.reports.len() > 1 {
                    { bounds(text, &watch.reports) }
                }
            } else {
                <p class="dim">{ text.no_plan_yet }</p>
            }
            <p class="buttons">
                <button type="button" class="plain" data-testid="try-many" disabled={!watch.has_policy || rolling}
                    onclick={sends(act, Action::TryMany)}>{ (text.try_many)(RUNS) }</button>
            </p>
            if let Some(runs) = watch.runs { { outcome(text, &runs) } }
        </section>
    }
}

fn proved([low, high]: [f64; 2]) -> String {
    if high - low < 5e-5 { format!("{low:.4}") } else { format!("{low:.4} … {high:.4}") }
}

fn outcome(text: &Text, runs: &Runs) -> Html {
    let share = f64::from(runs.successes) / f64::from(runs.runs.max(1));
    html! {
        <div data-testid="runs" data-runs={runs.runs.to_string()}>
            { interval(share, runs.interval, &(text.runs)(runs)) }
            <p>{ (text.runs)(runs) }</p>
        </div>
    }
}
