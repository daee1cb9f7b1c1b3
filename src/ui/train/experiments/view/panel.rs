//! Experiments: chosen, run, and what they found.

use super::results::results;
use super::six::six;
use crate::ui::page::view::fields::{choice, number};
use crate::ui::page::view::files::open_file;
use crate::ui::page::view::notice::notice;
use crate::ui::train::desk::Desk;
use crate::ui::train::experiments::action::Action;
use crate::ui::train::experiments::matrix::Kind;
use crate::ui::train::experiments::pool::Pool;
use crate::ui::train::experiments::state::State;
use crate::ui::train::experiments::words::Text;
use crate::worker::protocol::{By, ExperimentProgress, RunPart};
use yew::{Callback, Html, html};

/// Experiments on a corpus of which so many rows are held out; `kept` says what there is to say of how results are kept,
/// `can_run` whether the engine is free.
pub(crate) fn panel(
    state: &State,
    desk: &Desk,
    kept: Html,
    held_out: u32,
    can_run: bool,
    act: &Callback<Action>,
) -> Html {
    let text = Text::of(desk.language);
    html! {
        <div class="data">
            { paper(state, held_out, can_run, text, act) }
            { chosen(state, held_out, can_run, text, act) }
            { results(state, kept, text, act) }
        </div>
    }
}

/// The paper's experiments, one press each.
fn paper(state: &State, held_out: u32, can_run: bool, text: &Text, act: &Callback<Action>) -> Html {
    let off = !can_run || state.pool.is_some();
    let one = |id: &str, words: &'static str, about: &'static str, action: Action| {
        html! {
            <li>
                <button type="button" class="quiet" data-testid={id.to_owned()} disabled={off}
                    onclick={act.reform(move |_| action.clone())}>{ words }</button>
                <span class="dim">{ about }</span>
            </li>
        }
    };
    html! {
        <section class="card" aria-labelledby="paper-title">
            <h2 id="paper-title">{ text.of_paper }</h2>
            <p class="dim">{ text.paper_help }</p>
            if held_out == 0 { <p class="dim" data-testid="paper-share">{ text.paper_share }</p> }
            <ul class="one-click">
                { for Kind::PAPER.into_iter().zip(["table-2", "table-2-raw", "table-3"]).map(|(kind, id)| {
                    one(id, (text.kind)(kind), (text.about)(kind), Action::Paper(kind))
                }) }
                { one("six-sentences", text.six, text.about_six, Action::Six) }
            </ul>
            if let Some(found) = &state.six { { six(found, text) } }
        </section>
    }
}

fn chosen(
    state: &State,
    held_out: u32,
    can_run: bool,
    text: &Text,
    act: &Callback<Action>,
) -> Html {
    let kinds: Vec<String> = Kind::OWN.iter().map(|kind| (text.kind)(*kind).to_owned()).collect();
    let place = Kind::OWN.iter().position(|kind| *kind == state.kind).unwrap_or(0);
    let choose =
        act.reform(|at: usize| Action::Choose(Kind::OWN.get(at).copied().unwrap_or_default()));
    let by: Vec<String> = By::ALL.iter().map(|(_, by)| (text.by)(*by).to_owned()).collect();
    let lacks = state.kind.needs_held_out() && held_out == 0;
    let is_asking = state.asking().is_some();
    let (id, words, action, off) = match state.pool.is_some() && !is_asking {
        true => ("stop-runs", text.stop, Action::Stop, false),
        false => ("run", text.go, Action::Go, lacks || is_asking || !can_run),
    };
    html! {
        <section class="card" aria-labelledby="experiments-title">
            <h2 id="experiments-title">{ text.experiments }</h2>
            <p class="dim">{ text.help }</p>
            <div class="fields">
                { choice("experiment".into(), text.experiment.into(), &kinds, place, choose) }
                if state.kind == Kind::Cross {
                    { number("folds".into(), text.folds.into(), [state.folds.into(), 2.0, 100.0, 1.0], false,
                        act.reform(|n: f64| Action::Folds(n as u32))) }
                }
                if matches!(state.kind, Kind::Cross | Kind::Curve) {
                    { choice("experiment-by".into(), text.together.into(), &by, state.by, act.reform(Action::By)) }
                }
                if state.kind == Kind::Seeds {
                    { number("seeds".into(), text.seeds.into(), [state.seeds.into(), 2.0, 100.0, 1.0], false,
                        act.reform(|n: f64| Action::Seeds(n as u32))) }
                }
            </div>
            if lacks { <p class="notice" data-testid="needs-held-out">{ text.needs_held_out }</p> }
            <p class="buttons">
                <button type="button" class="primary" data-testid={id} disabled={off}
                    onclick={act.reform(move |_| action.clone())}>{ words }</button>
            </p>
            if let Some(pool) = state.pool.as_ref().filter(|_| !is_asking) { { bar(text, pool) } }
            { notice(state.notice.as_deref(), "experiment-notice") }
            { open_file("runs-file", text.repeat, ".json", None, &act.reform(Action::Repeat)) }
        </section>
    }
}

fn bar(text: &Text, pool: &Pool) -> Html {
    let runs = pool.n_runs();
    let at = |(run, progress): (u32, &ExperimentProgress)| {
        let part = match &progress.part {
            RunPart::Learning(progress) => (text.learning)(progress),
            RunPart::Judging { judged, commands } => (text.judging)(*judged, *commands),
        };
        html! { <p class="dim figures">{ (text.at)(run as usize + 1, runs, &progress.name, &part) }</p> }
    };
    html! {
        <div class="bar" data-testid="runs-progress">
            <progress aria-label={text.experiments} max={runs.to_string()} value={pool.done().to_string()} />
            <p class="dim" data-testid="pool">{ (text.pool)(pool.done(), runs, pool.n_seats()) }</p>
            { for pool.progress().map(at) }
        </div>
    }
}
