//! How a run goes, epoch by epoch: small charts in SVG, and the same figures as a table.

use crate::ui::train::run::curve::{FRAME, HEIGHT, Point, Series, WIDTH, round_up, series, x, y};
use crate::ui::train::run::state::Run;
use crate::ui::train::run::words::Text;
use crate::worker::protocol::{Figures, Judgement};
use yew::{Html, html};

/// A chart with its series, each with what it is called and how it is drawn.
struct Chart<'a> {
    name: &'a str,
    epochs: u32,
    most: f64,
    is_share: bool,
    lines: Vec<(&'a str, &'static str, Series)>,
}

/// The charts of a run.
pub(super) fn curves(run: &Run, text: &Text) -> Html {
    let points = &run.points;
    let Some(last) = points.last() else { return Html::default() };
    let epochs = last.progress.epochs;
    let held_out = points.iter().any(|point| point.judgement.is_some());
    html! {
        <section class="card" aria-labelledby="curves-title" data-testid="curves">
            <h2 id="curves-title">{ text.curves }</h2>
            if held_out {
                { chart(&judged(points, epochs, text)) }
            } else {
                <p class="dim">{ text.nothing_held_out }</p>
            }
            <div class="curves">
                { chart(&counted(points, epochs, text.valid, last.progress.examples as f64, |p| p.progress.valid)) }
                { chart(&counted(points, epochs, text.updates, 0.0, |p| p.progress.updates)) }
                { chart(&counted(points, epochs, text.entries, 0.0, |p| p.progress.entries)) }
            </div>
            <details>
                <summary>{ text.as_table }</summary>
                { table(points, text, held_out) }
            </details>
        </section>
    }
}

fn judged<'a>(points: &[Point], epochs: u32, text: &'a Text) -> Chart<'a> {
    let of = |pick: fn(&Figures) -> [f64; 3]| {
        let values = points.iter().filter_map(|point| {
            Some((point.progress.epoch, pick(&point.judgement.as_ref()?.skipping)))
        });
        let values: Vec<(u32, [f64; 3])> = values.collect();
        series(&values, epochs, 1.0)
    };
    Chart {
        name: text.held_out,
        epochs,
        most: 1.0,
        is_share: true,
        lines: vec![
            (text.precision, "first", of(|figures| figures.precision)),
            (text.recall, "second", of(|figures| figures.recall)),
            (text.f1, "third", of(|figures| figures.f1)),
        ],
    }
}

fn counted<'a>(
    points: &[Point],
    epochs: u32,
    name: &'a str,
    least: f64,
    count: fn(&Point) -> usize,
) -> Chart<'a> {
    let values = points.iter().map(|point| (point.progress.epoch, count(point) as f64));
    let values: Vec<(u32, [f64; 3])> = values.map(|(epoch, n)| (epoch, [n, n, n])).collect();
    let most = values.iter().map(|(_, [n, ..])| *n).fold(least, f64::max);
    let most = if least > 0.0 { most } else { round_up(most.max(2.0)) };
    let lines = vec![(name, "first", series(&values, epochs, most))];
    Chart { name, epochs, most, is_share: false, lines }
}

fn chart(chart: &Chart<'_>) -> Html {
    let [left, _, right, bottom] = FRAME;
    let label = |value: f64| match chart.is_share {
        true => format!("{value:.2}"),
        false if value.fract() == 0.0 => format!("{value:.0}"),
        false => format!("{value:.1}"),
    };
    let grid = [0.0, 0.5, 1.0].map(|part| part * chart.most);
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
                { for grid.into_iter().map(|value| html! {
                    <>
                        <path class="grid-line" d={format!("M{left} {0}H{right}", y(value, chart.most))} />
                        <text class="chart-y" x={(left - 5.0).to_string()} y={(y(value, chart.most) + 3.5).to_string()}>{ label(value) }</text>
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
