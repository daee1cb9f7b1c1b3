//! What a run did, epoch by epoch, as lines to be drawn: places in a box of [`WIDTH`] by [`HEIGHT`], y downwards. Pure.

use crate::worker::protocol::{Judgement, Progress};
use serde::{Deserialize, Serialize};

/// The breadth of a chart.
pub const WIDTH: f64 = 320.0;
/// Its height.
pub const HEIGHT: f64 = 150.0;
/// The left, upper, right and lower edge of what is inside the axes.
pub const FRAME: [f64; 4] = [40.0, 8.0, 312.0, 126.0];

/// What there is to say of an epoch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// How far the run was at its end, or is in it.
    pub progress: Progress,
    /// How its model did on what is held out.
    pub judgement: Option<Judgement>,
}

/// A series of values with the ends of their intervals.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// The line.
    pub line: String,
    /// The area between the intervals' ends; empty without any.
    pub area: String,
    /// Where its points are.
    pub dots: Vec<[f64; 2]>,
}

/// Takes in how far a run is.
pub fn progressed(points: &mut Vec<Point>, progress: Progress) {
    match points.last_mut() {
        Some(last) if last.progress.epoch == progress.epoch => last.progress = progress,
        _ => points.push(Point { progress, judgement: None }),
    }
}

/// Takes in how the model of an epoch did.
pub fn judged(points: &mut [Point], epoch: u32, judgement: Judgement) {
    let of = points.iter_mut().rev().find(|point| point.progress.epoch <= epoch);
    of.into_iter().for_each(|point| point.judgement = Some(judgement.clone()));
}

/// The place of an epoch, of so many.
pub fn x(epoch: u32, epochs: u32) -> f64 {
    let [left, _, right, _] = FRAME;
    let span = f64::from(epochs.saturating_sub(1).max(1));
    left + (right - left) * f64::from(epoch.saturating_sub(1)) / span
}

/// The place of a value, of at most so much.
pub fn y(value: f64, most: f64) -> f64 {
    let [_, top, _, bottom] = FRAME;
    bottom - (bottom - top) * (value / most.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0)
}

/// A series through values by epoch: each with the ends of its interval, if it has one.
pub fn series(values: &[(u32, [f64; 3])], epochs: u32, most: f64) -> Series {
    let at = |epoch, value| format!("{:.1} {:.1}", x(epoch, epochs), y(value, most));
    let join = |places: Vec<String>| match places.is_empty() {
        true => String::new(),
        false => format!("M{}", places.join("L")),
    };
    let has_band = values.iter().any(|(_, [_, low, high])| low < high);
    let upper = values.iter().map(|(epoch, [_, _, high])| at(*epoch, *high));
    let lower = values.iter().rev().map(|(epoch, [_, low, _])| at(*epoch, *low));
    Series {
        line: join(values.iter().map(|(epoch, [value, ..])| at(*epoch, *value)).collect()),
        area: if has_band { join(upper.chain(lower).collect()) + "z" } else { String::new() },
        dots: values.iter().map(|(e, [value, ..])| [x(*e, epochs), y(*value, most)]).collect(),
    }
}

/// A round number that is at least so much, for the end of an axis.
pub fn round_up(value: f64) -> f64 {
    let mut unit = 1.0;
    loop {
        let fits = [1.0, 2.0, 2.5, 5.0].into_iter().map(|n| n * unit).find(|n| *n >= value);
        match fits {
            Some(round) => return round,
            None if unit > value => return value,
            None => unit *= 10.0,
        }
    }
}
