//! Tables and a picture of how cost grows: panels side by side, milliseconds on a logarithmic axis, a line a series.

use std::fmt::Write;

/// One way in which problems grow.
pub(crate) struct Panel {
    pub(crate) title: &'static str,
    /// What stands below the axis.
    pub(crate) labels: Vec<String>,
    pub(crate) series: Vec<Series>,
}

/// Milliseconds by label; `None` above the budget.
pub(crate) struct Series {
    pub(crate) title: &'static str,
    pub(crate) values: Vec<Option<f64>>,
}

impl Panel {
    /// The table, as Markdown.
    pub(crate) fn table(&self) -> String {
        let mut out = format!("| {} |", self.title);
        self.series.iter().for_each(|s| out += &format!(" {} |", s.title));
        out += "\n|---|";
        out += &"---|".repeat(self.series.len());
        for (i, label) in self.labels.iter().enumerate() {
            out += &format!("\n| {label} |");
            for series in &self.series {
                out += &match series.values[i] {
                    Some(ms) if ms < 10.0 => format!(" {ms:.2} ms |"),
                    Some(ms) => format!(" {ms:.0} ms |"),
                    None => " – |".to_owned(),
                };
            }
        }
        out
    }
}

/// Columns and rows of a panel's lines within it, in pixels.
const WIDTH: f64 = 250.0;
const HEIGHT: f64 = 200.0;
/// Decades of milliseconds from the bottom to the top.
const DECADES: (f64, f64) = (-2.0, 4.0);
const COLORS: [&str; 3] = ["#0072b2", "#d55e00", "#009e73"];
/// Shapes of points, so that colour is not the only sign.
const MARKS: [&str; 3] = ["●", "■", "▲"];

/// The picture.
pub(crate) fn svg(panels: &[Panel]) -> String {
    let (left, top, gap) = (70.0, 40.0, 60.0);
    let width = left + panels.len() as f64 * (WIDTH + gap);
    let height = top + HEIGHT + 90.0;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <title>What planning costs by the cells, rooms and objects of a world</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    for (i, panel) in panels.iter().enumerate() {
        draw(&mut out, panel, left + i as f64 * (WIDTH + gap), top);
    }
    let first = panels.iter().take(1).flat_map(|panel| panel.series.iter().enumerate());
    for (i, series) in first {
        let x = left + 220.0 * i as f64;
        let y = top + HEIGHT + 65.0;
        let (color, mark) = (COLORS[i % 3], MARKS[i % 3]);
        let _ = writeln!(
            out,
            "<text x=\"{x}\" y=\"{y}\" fill=\"{color}\">{mark} {}</text>",
            series.title
        );
    }
    out + "</svg>\n"
}

fn draw(out: &mut String, panel: &Panel, left: f64, top: f64) {
    let _ = writeln!(
        out,
        "<text x=\"{left}\" y=\"{}\" fill=\"#000\">{}</text>",
        top - 15.0,
        panel.title
    );
    let height = |ms: f64| {
        let share = (ms.log10() - DECADES.0) / (DECADES.1 - DECADES.0);
        top + HEIGHT * (1.0 - share.clamp(0.0, 1.0))
    };
    for decade in DECADES.0 as i32..=DECADES.1 as i32 {
        let y = height(10_f64.powi(decade));
        let name = match decade {
            -2 => "10 µs",
            -1 => "100 µs",
            0 => "1 ms",
            1 => "10 ms",
            2 => "100 ms",
            3 => "1 s",
            _ => "10 s",
        };
        let right = left + WIDTH;
        let _ = writeln!(out, "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#ddd\"/>");
        let _ = writeln!(
            out,
            "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"#444\">{name}</text>",
            left - 5.0,
            y + 4.0
        );
    }
    let step = WIDTH / panel.labels.len() as f64;
    let column = |i: usize| left + step * (i as f64 + 0.5);
    for (i, label) in panel.labels.iter().enumerate() {
        let short = label.split(' ').next().unwrap_or(label);
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{}\" text-anchor=\"middle\" fill=\"#444\">{short}</text>",
            column(i),
            top + HEIGHT + 20.0
        );
    }
    for (i, series) in panel.series.iter().enumerate() {
        let (color, mark) = (COLORS[i % 3], MARKS[i % 3]);
        let known = series
            .values
            .iter()
            .enumerate()
            .filter_map(|(i, ms)| Some((column(i), height((*ms)?))));
        let points: Vec<(f64, f64)> = known.collect();
        let line: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(
            out,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\"/>",
            line.join(" ")
        );
        for (x, y) in points {
            let _ = writeln!(
                out,
                "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" fill=\"{color}\">{mark}</text>",
                y + 4.0
            );
        }
    }
}
