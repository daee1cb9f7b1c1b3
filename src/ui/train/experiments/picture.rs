//! What the runs of an experiment found as a picture that stands by itself: a line a run, its F1 with the ends of its
//! interval, and the paper's figure where it has one. Pure.

use crate::ui::train::svg::{Svg, escaped};
use crate::worker::protocol::Joined;

/// The breadth of the names.
const NAMES: f64 = 190.0;
/// That of the figures' scale.
const SCALE: f64 = 320.0;
/// That of all.
const WIDTH: f64 = 680.0;
/// The height of a line.
const LINE: f64 = 24.0;

/// The picture, with a name for its scale.
pub fn picture(joined: &Joined, scale: &str) -> String {
    let all = joined.all.as_ref().map(|all| ("Σ", all, None));
    let runs = joined.runs.iter().map(|run| (&*run.name, &run.judgement, run.paper_f1));
    let rows: Vec<_> = runs.chain(all).collect();
    let bottom = 12.0 + LINE * rows.len() as f64;
    let x = |share: f64| NAMES + SCALE * share.clamp(0.0, 1.0);
    let mut svg = Svg::new(WIDTH, bottom + 36.0);
    for tick in [0.0, 0.25, 0.5, 0.75, 1.0] {
        svg.line("grid", &format!("M{:.1} 8V{bottom:.1}", x(tick)));
        svg.text("middle dim", x(tick), bottom + 15.0, &format!("{tick}"));
    }
    svg.text("middle dim", x(0.5), bottom + 31.0, &escaped(scale));
    for (at, (name, judgement, paper)) in rows.into_iter().enumerate() {
        let y = 24.0 + LINE * at as f64;
        let [value, low, high] = judgement.skipping.f1;
        svg.text("end", NAMES - 10.0, y + 4.0, &escaped(name));
        svg.line("first", &format!("M{:.1} {y:.1}H{:.1}", x(low), x(high)));
        svg.dot("first", x(value), y);
        if let Some(paper) = paper {
            svg.line("second", &format!("M{:.1} {:.1}v12", x(paper), y - 6.0));
        }
        let said = format!("{value:.3} ({low:.3}–{high:.3})");
        svg.text("start", NAMES + SCALE + 14.0, y + 4.0, &said);
    }
    svg.end()
}
