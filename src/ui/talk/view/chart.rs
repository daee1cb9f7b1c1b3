//! Charts as SVG: a planner's residual and bounds over its steps, what the colours of values stand for, and a share
//! with its interval. All take their breadth from the page.
use crate::render::{Rgba, Theme};
use crate::ui::talk::watch::chart::Chart;
use crate::ui::talk::words::Text;
use crate::worker::protocol::PlanProgress;
use yew::{Html, html};

/// Steps of a legend's colours.
const STEPS: u32 = 30;
/// A tenth: where the values that are worth anything begin ([`crate::render::spread`]).
const LEAST: f32 = 0.1;

/// A chart with its axes.
fn plot(chart: &Chart, label: &str, x_name: &str, y_name: &str) -> Html {
    let [left, top, right, bottom] = Chart::FRAME;
    let x_ticks = chart.x.ticks();
    let ends = [x_ticks.first(), x_ticks.last()].map(|tick| tick.map_or("", |tick| &tick.label));
    let summary = format!("{y_name}: {}; {x_name}: {}–{}", chart.last.join("–"), ends[0], ends[1]);
    html! {
        <figure class="chart">
            <figcaption aria-hidden="true">{ y_name }</figcaption>
            <svg viewBox={format!("0 0 {} {}", Chart::WIDTH, Chart::HEIGHT)} role="img"
                aria-label={format!("{label}. {summary}")}>
                <desc>{ summary }</desc>
                { for chart.y.ticks().into_iter().map(|tick| html! {
                    <>
                        <path class="chart-grid" d={format!("M{left} {:.1}H{right}", tick.at)} />
                        <text class="chart-y" x={(left - 6.0).to_string()} y={format!("{:.1}", tick.at + 3.5)}>{ tick.label }</text>
                    </>
                }) }
                { for x_ticks.iter().map(|tick| html! {
                    <text class="chart-x" x={format!("{:.1}", tick.at)} y={(bottom + 15.0).to_string()}>{ &tick.label }</text>
                }) }
                <path class="chart-area" d={chart.area.clone()} />
                { for chart.lines.iter().map(|line| html! { <path class="chart-line" d={line.clone()} /> }) }
                <path class="chart-axis" d={format!("M{left} {top}V{bottom}H{right}")} />
            </svg>
            <p class="chart-name" aria-hidden="true">{ x_name }</p>
        </figure>
    }
}

/// How a planner came to its answer: what it proved of the start, and how much its values still changed. A chart
/// without anything to show is left out.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn bounds(text: &Text, reports: &[PlanProgress]) -> Html {
    let at = |report: &PlanProgress| report.steps as f64;
    let proved: Vec<_> = reports.iter().map(|report| (at(report), report.bounds)).collect();
    let changed: Vec<_> = reports.iter().map(|report| (at(report), report.residual)).collect();
    let plot = |chart: Chart, name: &str| plot(&chart, text.chart, text.steps, name);
    html! {
        <div class="charts" data-testid="bounds">
            if !proved.is_empty() { { plot(Chart::band(&proved), text.bounds) } }
            if changed.iter().any(|point| point.1 > 0.0) { { plot(Chart::line(&changed, true), text.residual) } }
        </div>
    }
}

/// The colours and sizes of values from low to high.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn legend(theme: Theme, low: &str, high: &str, label: &str) -> Html {
    let step = |i: u32| {
        let share = i as f32 / (STEPS - 1) as f32;
        // As the tiles grow in the picture.
        let height = 6.0 + 4.0 * share;
        html! {
            <rect x={i.to_string()} y={(5.0 - height / 2.0).to_string()} width="1" height={height.to_string()}
                fill={css(theme.value(LEAST + (1.0 - LEAST) * share))} />
        }
    };
    html! {
        <div class="legend" role="img" aria-label={format!("{label}: {low}–{high}")} data-testid="legend">
            <span>{ low }</span>
            <svg viewBox={format!("0 0 {STEPS} 10")} preserveAspectRatio="none" shape-rendering="crispEdges">{ for (0..STEPS).map(step) }</svg>
            <span>{ high }</span>
        </div>
    }
}

/// A share of all, with its interval.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn interval(share: f64, interval: [f64; 2], label: &str) -> Html {
    let percent = |share: f64| (100.0 * share).clamp(0.0, 100.0);
    let [low, high] = interval.map(percent);
    let share = percent(share);
    html! {
        <svg class="interval" viewBox="-2 0 104 10" role="img" aria-label={label.to_owned()} data-testid="interval">
            <path class="interval-scale" d="M0 5H100M0 3V7M25 4V6M50 3V7M75 4V6M100 3V7" />
            <rect class="interval-open" x={low.to_string()} y="2.5" width={(high - low).max(0.0).to_string()} height="5" rx="1" />
            <path class="interval-share" d={format!("M{share} 1V9")} />
        </svg>
    }
}

fn css(Rgba(colour): Rgba) -> String {
    let [r, g, b, _] = colour.map(|c| (c * 255.0).round());
    format!("rgb({r} {g} {b})")
}
