//! What experiments found: the runs beside one another, with intervals and the paper's figures, each to be saved.

use crate::ui::train::experiments::action::{Action, Saved};
use crate::ui::train::experiments::state::{Found, State};
use crate::ui::train::experiments::words::Text;
use crate::worker::protocol::{Judgement, RunReport};
use yew::{Callback, Html, html};

/// The breadth of the picture of a figure with its interval.
const WIDTH: f64 = 120.0;

/// What was found, and what there is to say of how it is kept.
pub(super) fn results(state: &State, kept: Html, text: &Text, act: &Callback<Action>) -> Html {
    html! {
        <section class="card" aria-labelledby="results-title" data-testid="results">
            <h2 id="results-title">{ text.results }</h2>
            if state.results.is_empty() { <p class="dim">{ text.none }</p> } else { { kept } }
            { for state.results.iter().enumerate().map(|(at, found)| one(at, found, text, act)) }
        </section>
    }
}

fn one(at: usize, found: &Found, text: &Text, act: &Callback<Action>) -> Html {
    let name = if found.name.is_empty() { &found.about.name } else { &found.name };
    let about = found.about.runs.first().map(|run| (text.settings)(&run.settings));
    let label = format!("{}, {name}", at + 1);
    let has_paper = found.joined.runs.iter().any(|run| run.paper_f1.is_some());
    let save = |what: Saved| {
        html! {
            <button type="button" class="link" data-testid={format!("save-{what:?}").to_ascii_lowercase()}
                onclick={act.reform(move |_| Action::Save(at, what))}>{ (text.saved)(what) }</button>
        }
    };
    html! {
        <div class="result">
            <h3>{ name }</h3>
            if let Some(about) = about { <p class="dim figures" data-testid="result-settings">{ about }</p> }
            <div class="scroll" tabindex="0" role="region" aria-label={label}>
                <table class="figures" data-testid="runs">
                    <thead><tr>
                        { for [text.run, text.examples, text.valid, text.entries, text.precision, text.recall, text.f1]
                            .into_iter().map(|head| html! { <th scope="col">{ head }</th> }) }
                        if has_paper { <th scope="col">{ text.paper }</th> }
                    </tr></thead>
                    <tbody>
                        { for found.joined.runs.iter().map(|run| row(run, has_paper)) }
                        if let Some(all) = &found.joined.all {
                            <tr><th scope="row">{ text.all }</th><td /><td /><td />{ figures(all) }</tr>
                        }
                    </tbody>
                </table>
            </div>
            <p class="buttons">
                { for [Saved::Csv, Saved::Svg, Saved::Json, Saved::Report, Saved::Plan].into_iter().map(save) }
                <button type="button" class="link" data-testid="forget-result"
                    onclick={act.reform(move |_| Action::Forget(at))}>{ text.forget }</button>
            </p>
        </div>
    }
}

fn row(run: &RunReport, has_paper: bool) -> Html {
    html! {
        <tr>
            <th scope="row">{ &run.name }</th>
            <td>{ run.examples }</td><td>{ run.valid }</td><td>{ run.entries }</td>
            { figures(&run.judgement) }
            if has_paper { <td>{ run.paper_f1.map_or(String::new(), |f1| format!("{f1:.3}")) }</td> }
        </tr>
    }
}

fn figures(judgement: &Judgement) -> Html {
    let figure = |[value, low, high]: [f64; 3]| format!("{value:.3} ({low:.3}–{high:.3})");
    let [value, low, high] = judgement.skipping.f1.map(|share| share * WIDTH);
    html! {
        <>
            <td>{ figure(judgement.skipping.precision) }</td>
            <td>{ figure(judgement.skipping.recall) }</td>
            <td>
                { figure(judgement.skipping.f1) }
                <svg class="span" viewBox={format!("0 0 {WIDTH} 8")} aria-hidden="true">
                    <path class="grid-line" d={format!("M0 4H{WIDTH}")} />
                    <path class="reach" d={format!("M{low:.1} 4H{high:.1}")} />
                    <circle class="dot first" cx={format!("{value:.1}")} cy="4" r="3" />
                </svg>
            </td>
        </>
    }
}
