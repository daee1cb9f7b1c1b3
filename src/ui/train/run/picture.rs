//! The curves of a run as a picture that stands by itself. Pure.

use super::chart::charts;
use super::curve::{FRAME, HEIGHT, Point, WIDTH, x, y};
use super::words::Text;
use crate::ui::train::svg::Svg;

/// The height of a chart's name.
const NAME: f64 = 26.0;

/// All charts, one below the other.
pub fn picture(points: &[Point], text: &Text) -> String {
    let all = charts(points, text);
    let [left, _, right, bottom] = FRAME;
    let mut svg = Svg::new(WIDTH + 16.0, (HEIGHT + NAME) * all.len() as f64 + 8.0);
    for (at, chart) in all.iter().enumerate() {
        svg.open(8.0, (HEIGHT + NAME) * at as f64);
        svg.text("start", left, 17.0, chart.name);
        let names = chart.lines.iter().filter(|_| chart.lines.len() > 1);
        for (place, (name, class, _)) in names.enumerate() {
            let x = right - 70.0 * (chart.lines.len() - place) as f64;
            svg.line(class, &format!("M{x:.0} 13h14"));
            svg.text("start dim", x + 17.0, 17.0, name);
        }
        svg.close();
        svg.open(8.0, (HEIGHT + NAME) * at as f64 + NAME);
        for value in chart.grid() {
            let place = y(value, chart.most);
            svg.line("grid", &format!("M{left} {place:.1}H{right}"));
            svg.text("end dim", left - 5.0, place + 3.5, &chart.label(value));
        }
        for epoch in [1, chart.epochs.max(1)] {
            svg.text("middle dim", x(epoch, chart.epochs), bottom + 15.0, &epoch.to_string());
        }
        for (_, class, series) in &chart.lines {
            svg.line(&format!("area {class}"), &series.area);
            svg.line(class, &series.line);
            series.dots.iter().for_each(|[x, y]| svg.dot(class, *x, *y));
        }
        svg.close();
    }
    svg.end()
}
