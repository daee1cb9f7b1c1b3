//! The charts of a run: what is held out, judged epoch by epoch, if anything is; valid parses, updates and entries. Pure.

use super::curve::{Point, Series, round_up, series};
use super::words::Text;
use crate::worker::protocol::Figures;

/// A chart with its series.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart<'a> {
    /// What it is called.
    pub name: &'a str,
    /// Epochs in all.
    pub epochs: u32,
    /// The upper end of its axis.
    pub most: f64,
    /// Whether its values are shares of one.
    pub is_share: bool,
    /// The series, each with what it is called and how it is drawn.
    pub lines: Vec<(&'a str, &'static str, Series)>,
}

impl Chart<'_> {
    /// The values that have a line of their own.
    pub fn grid(&self) -> [f64; 3] {
        [0.0, 0.5, 1.0].map(|part| part * self.most)
    }

    /// A value as its axis has it.
    pub fn label(&self, value: f64) -> String {
        match self.is_share {
            true => format!("{value:.2}"),
            false if value.fract() == 0.0 => format!("{value:.0}"),
            false => format!("{value:.1}"),
        }
    }
}

/// All charts of a run.
pub fn charts<'a>(points: &[Point], text: &'a Text) -> Vec<Chart<'a>> {
    let Some(last) = points.last() else { return Vec::new() };
    let (epochs, examples) = (last.progress.epochs, last.progress.examples as f64);
    let held_out = points.iter().any(|point| point.judgement.is_some());
    let judged = held_out.then(|| judged(points, epochs, text));
    let counted = [
        counted(points, epochs, text.valid, examples, |point| point.progress.valid),
        counted(points, epochs, text.updates, 0.0, |point| point.progress.updates),
        counted(points, epochs, text.entries, 0.0, |point| point.progress.entries),
    ];
    judged.into_iter().chain(counted).collect()
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
