//! How a run goes, epoch by epoch: small charts in SVG, and the same figures as a table.

use super::press::press;
use crate::ui::train::run::action::Action;
use crate::ui::train::run::chart::{Chart, charts};
use crate::ui::train::run::curve::{FRAME, HEIGHT, Point, WIDTH, x, y};
use crate::ui::train::run::state::Run;
use crate::ui::train::run::words::Text;
use crate::worker::protocol::Judgement;
use yew::{Callback, Html, html};

/// The charts of a run.
pub(super) fn curves(run: &Run, text: &Text, act: &Callback<Action>) -> Html {
    let points = &run.points;
    if points.is_empty() {
        return Html::default();
    }
    let all = charts(points, text);
    let (judged, counted): (Vec<Chart<'_>>, Vec<Chart<'_>>) =
        all.into_iter().partition(|chart| chart.is_share);
    let held_out = points.iter().any(|point| point.judgement.is_some());
    html! {
        <section class="card" aria-labelledby="curves-title" data-testid="curves">
            <h2 id="curves-title">{ text.curves }</h2>
            if !held_out { <p class="dim">{ text.nothing_held_out }</p> }
            { for judged.iter().map(chart) }
            <div class="curves">{ for counted.iter().map(chart) }</div>
            <p class="buttons">{ press("quiet", "save-curves", text.save_curves, false, act, Action::SaveCurves) }</p>
            <details>
                <summary>{ text.as_table }</summary>
                { table(points, text, held_out) }
            </details>
        </section>
    }
}

fn chart(chart: &Chart<'_>) -> Html {
    let [left, _, right, bottom] = FRAME;
    let several = chart.lines.len() > 1;
    html! {
        <figure class="curve">
            <figcaption>
                { chart.name }
                if several {
                    { for chart.lines.iter().map(|(name, class, _)| html! {
                        <span class="key"><svg viewBox="0 0 24 8" aria-hidden="true"><path class={format!("line {class}")} d="M0 4H24" /></svg>{ *name }</span>
                    }) }
                }
            </figcaption>
            <svg viewBox={format!("0 0 {WIDTH} {HEIGHT}")} aria-hidden="true">
                { for chart.grid().into_iter().map(|value| html! {
                    <>
                        <path class="grid-line" d={format!("M{left} {0}H{right}", y(value, chart.most))} />
                        <text class="chart-y" x={(left - 5.0).to_string()} y={(y(value, chart.most) + 3.5).to_string()}>{ chart.label(value) }</text>
                    </>
                }) }
                { for [1, chart.epochs.max(1)].into_iter().map(|epoch| html! {
                    <text class="chart-x" x={x(epoch, chart.epochs).to_string()} y={(bottom + 15.0).to_string()}>{ epoch }</text>
                }) }
                { for chart.lines.iter().map(|(_, class, series)| html! {
                    <>
                        <path class={format!("area {class}")} d={series.area.clone()} />
                        <path class={format!("line {class}")} d={series.line.clone()} />
                        { for series.dots.iter().map(|[x, y]| html! { <circle class={format!("dot {class}")} cx={x.to_string()} cy={y.to_string()} r="2" /> }) }
                    </>
                }) }
            </svg>
        </figure>
    }
}

fn table(points: &[Point], text: &Text, held_out: bool) -> Html {
    let figure = |[value, low, high]: [f64; 3]| {
        html! { <td>{ format!("{value:.3} ({low:.3}–{high:.3})") }</td> }
    };
    let judged = |judgement: &Option<Judgement>| match judgement {
        Some(Judgement { skipping, .. }) => html! {
            <>{ figure(skipping.precision) }{ figure(skipping.recall) }{ figure(skipping.f1) }</>
        },
        None => html! { <><td /><td /><td /></> },
    };
    html! {
        <div class="scroll" tabindex="0" role="region" aria-label={text.as_table}>
            <table class="figures" data-testid="curves-table">
                <thead><tr>
                    <th scope="col">{ text.pass }</th>
                    if held_out {
                        <th scope="col">{ text.precision }</th><th scope="col">{ text.recall }</th><th scope="col">{ text.f1 }</th>
                    }
                    <th scope="col">{ text.valid }</th><th scope="col">{ text.updates }</th><th scope="col">{ text.entries }</th>
                </tr></thead>
                <tbody>
                    { for points.iter().map(|Point { progress, judgement }| html! {
                        <tr>
                            <th scope="row">{ progress.epoch }</th>
                            if held_out { { judged(judgement) } }
                            <td>{ format!("{} / {}", progress.valid, progress.example) }</td>
                            <td>{ progress.updates }</td>
                            <td>{ progress.entries }</td>
                        </tr>
                    }) }
                </tbody>
            </table>
        </div>
    }
}
