//! Charts: where lines and ticks lie, what ticks say, what is left out.

use groundling::ui::talk::watch::chart::Chart;
use proptest::{prop_assert, proptest};

const LEFT: f64 = Chart::FRAME[0];
const TOP: f64 = Chart::FRAME[1];
const RIGHT: f64 = Chart::FRAME[2];
const BOTTOM: f64 = Chart::FRAME[3];

fn labels(ticks: &[groundling::ui::talk::watch::chart::Tick]) -> Vec<&str> {
    ticks.iter().map(|tick| &*tick.label).collect()
}

#[test]
fn a_line_runs_from_edge_to_edge() {
    let chart = Chart::line(&[(0.0, 0.0), (50.0, 1.0), (100.0, 4.0)], false);
    let middle = (LEFT + RIGHT) / 2.0;
    let quarter = BOTTOM + (TOP - BOTTOM) / 4.0;
    assert_eq!(
        chart.lines,
        [format!("M{LEFT:.1} {BOTTOM:.1}L{middle:.1} {quarter:.1}L{RIGHT:.1} {TOP:.1}")]
    );
    assert_eq!(labels(&chart.x.ticks()), ["0", "20", "40", "60", "80", "100"]);
    assert_eq!(labels(&chart.y.ticks()), ["0", "1", "2", "3", "4"]);
    assert_eq!((chart.area.as_str(), chart.last.as_slice()), ("", &["4.0000".to_owned()][..]));
}

#[test]
fn a_residual_falls_by_decades_and_what_is_zero_is_left_out() {
    let chart = Chart::line(&[(0.0, 1.0), (1e4, 1e-2), (2e4, 0.0), (3e4, 2e-6)], true);
    assert_eq!(labels(&chart.y.ticks()), ["10⁻⁶", "10⁻⁴", "10⁻²", "1"]);
    assert_eq!(chart.lines[0].matches('M').count(), 2, "a gap: {:?}", chart.lines);
    assert_eq!(labels(&chart.x.ticks()), ["0", "10k", "20k", "30k"]);
    let thousands = Chart::line(&[(0.0, 1.0), (13_650.0, 1.0)], false);
    assert_eq!(labels(&thousands.x.ticks()), ["0", "5k", "10k"], "all in one unit");
    let tick = &chart.y.ticks()[3];
    assert!((tick.at - TOP).abs() < 1e-9, "1 is at the top");
    assert_eq!(chart.y.at(0.0), None);
    assert_eq!(labels(&Chart::line(&[(0.0, 30.0)], true).y.ticks()), ["10", "10²"]);
}

#[test]
fn bounds_make_a_band_that_closes() {
    let chart = Chart::band(&[(1.0, [0.0, 1.0]), (2.0, [0.4, 0.8]), (3.0, [0.55, 0.6])]);
    assert_eq!(chart.lines.len(), 2);
    assert!(chart.area.starts_with(&chart.lines[0]) && chart.area.ends_with('z'), "{chart:?}");
    assert_eq!(chart.area.matches('L').count(), 5);
    assert_eq!(chart.last, ["0.5500", "0.6000"]);
    assert_eq!(labels(&chart.y.ticks()), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
}

#[test]
fn nothing_and_one_value_are_charts_too() {
    for chart in [Chart::line(&[], true), Chart::band(&[]), Chart::line(&[(7.0, 0.25)], false)] {
        assert!(chart.y.ticks().len() >= 2 && chart.x.ticks().len() >= 2, "{chart:?}");
    }
    assert!(Chart::line(&[(0.0, f64::NAN), (f64::INFINITY, 1.0)], false).lines[0].is_empty());
}

proptest! {
    #[test]
    fn ticks_are_few_and_distinct_and_lie_within(
        low in -1e7f64..1e7, share in 1e-3f64..1e3, log: bool,
    ) {
        let low = if log { low.abs() + 1e-9 } else { low };
        let span = (low.abs() + 1e-3) * share;
        let chart = Chart::line(&[(0.0, low), (1.0, low + span)], log);
        let ticks = chart.y.ticks();
        prop_assert!((2..=6).contains(&ticks.len()), "{ticks:?}");
        prop_assert!(ticks.iter().all(|t| (TOP - 0.01..=BOTTOM + 0.01).contains(&t.at)), "{ticks:?}");
        prop_assert!(ticks.windows(2).all(|pair| pair[0].label != pair[1].label), "{ticks:?}");
        prop_assert!(ticks.iter().all(|t| t.label.chars().count() <= 12), "{ticks:?}");
    }
}
