//! Small charts of series over time, as SVG paths and places of ticks: a line, or a band between two bounds. Pure.
//! Places are in the units of the view box, [`Chart::WIDTH`] by [`Chart::HEIGHT`], y downwards. Values that cannot be
//! shown (none at all, or none above 0 on a logarithmic axis) leave a gap.

/// A chart, ready to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// The line, or the band's upper and lower edge.
    pub lines: Vec<String>,
    /// The area between the bounds; empty for a line.
    pub area: String,
    /// Along the lower edge.
    pub x: Axis,
    /// Along the left edge.
    pub y: Axis,
    /// What the last values are, for those who do not see the chart.
    pub last: Vec<String>,
}

/// An axis between two values, over some length.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    low: f64,
    high: f64,
    log: bool,
    from: f64,
    to: f64,
}

/// A mark on an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where it is.
    pub at: f64,
    /// What it stands for.
    pub label: String,
}

impl Chart {
    /// The breadth of the view box.
    pub const WIDTH: f64 = 360.0;
    /// The height of the view box.
    pub const HEIGHT: f64 = 140.0;
    /// The left, upper, right and lower edge of what is inside the axes.
    pub const FRAME: [f64; 4] = [44.0, 8.0, 350.0, 118.0];

    /// A line through points (x, y), x growing; y on a logarithmic axis if `log`.
    pub fn line(points: &[(f64, f64)], log: bool) -> Self {
        let [left, top, right, bottom] = Self::FRAME;
        let x = Axis::over(points.iter().map(|point| point.0), false, left, right);
        let y = Axis::over(points.iter().map(|point| point.1), log, bottom, top);
        let lines = vec![path(points.iter().map(|point| (x.at(point.0), y.at(point.1))))];
        let last = points.last().map(|point| short(point.1)).into_iter().collect();
        Self { lines, area: String::new(), x, y, last }
    }

    /// The band between the lower and the upper bound at every x, x growing.
    pub fn band(points: &[(f64, [f64; 2])]) -> Self {
        let [left, top, right, bottom] = Self::FRAME;
        let x = Axis::over(points.iter().map(|point| point.0), false, left, right);
        let y = Axis::over(points.iter().flat_map(|point| point.1), false, bottom, top);
        let edge = |which: usize| points.iter().map(move |point| (point.0, point.1[which]));
        let places = |which: usize| edge(which).map(|(a, b)| (x.at(a), y.at(b)));
        let whole = points.iter().all(|point| point.1.iter().all(|bound| bound.is_finite()));
        let mut area = String::new();
        if whole && !points.is_empty() {
            let back: Vec<_> = places(0).collect();
            area = path(places(1).chain(back.into_iter().rev())) + "z";
        }
        let lines = [1, 0].map(|which| path(places(which))).to_vec();
        let last = points.last().map_or_else(Vec::new, |point| point.1.map(short).to_vec());
        Self { lines, area, x, y, last }
    }
}

impl Axis {
    /// An axis that holds these values from one place to another; some axis when there is no value.
    fn over(values: impl Iterator<Item = f64>, log: bool, from: f64, to: f64) -> Self {
        let values = values.filter(|value| value.is_finite() && (!log || *value > 0.0));
        let range = values.fold(None, |range: Option<[f64; 2]>, value| {
            Some(range.map_or([value; 2], |[low, high]| [low.min(value), high.max(value)]))
        });
        let [low, high] = range.unwrap_or([if log { 1.0 } else { 0.0 }, 1.0]);
        let (low, high) = match log {
            // Whole decades, one at least.
            true => {
                let [below, above] = [libm::floor(libm::log10(low)), libm::ceil(libm::log10(high))];
                (below, if above > below { above } else { below + 1.0 })
            }
            false if high > low => (low, high),
            false => (low - 0.5, high + 0.5),
        };
        Self { low, high, log, from, to }
    }

    /// Where a value lies; `None` where the axis has no place for it.
    pub fn at(&self, value: f64) -> Option<f64> {
        let value = if self.log { libm::log10(value) } else { value };
        let share = (value - self.low) / (self.high - self.low);
        let place = self.from + share * (self.to - self.from);
        place.is_finite().then_some(place)
    }

    /// The marks: round numbers or whole decades, two to six.
    pub fn ticks(&self) -> Vec<Tick> {
        let span = self.high - self.low;
        let step = if self.log { libm::ceil(span / 5.0) } else { round_step(span / 5.0) };
        let first = libm::ceil(self.low / step - 1e-9);
        let steps = (0..6).map(|i| (first + f64::from(i)) * step);
        let within = steps.take_while(|value| *value <= self.high + step * 1e-9);
        let place = |value: f64| self.from + (value - self.low) / span * (self.to - self.from);
        let most = self.low.abs().max(self.high.abs());
        let label = |value: f64| if self.log { decade(value) } else { number(value, step, most) };
        within.map(|value| Tick { at: place(value), label: label(value) }).collect()
    }
}

/// A path through places, broken where there is none.
fn path(places: impl Iterator<Item = (Option<f64>, Option<f64>)>) -> String {
    let mut out = String::new();
    let mut begun = false;
    for place in places {
        let (Some(x), Some(y)) = place else {
            begun = false;
            continue;
        };
        out.push_str(&format!("{}{x:.1} {y:.1}", if begun { "L" } else { "M" }));
        begun = true;
    }
    out
}

/// The nearest of 1, 2 or 5 times a power of ten that is not below.
fn round_step(least: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(least)));
    let step = [1.0, 2.0, 5.0].into_iter().find(|step| step * power >= least * (1.0 - 1e-9));
    step.unwrap_or(10.0) * power
}

/// A number with as many places as its step has; thousands and millions by their letter, where the axis has such.
fn number(value: f64, step: f64, most: f64) -> String {
    let (scale, letter) = match most {
        most if most >= 1e6 => (1e6, "M"),
        most if most >= 1e4 => (1e3, "k"),
        _ => (1.0, ""),
    };
    let places = libm::ceil(-libm::log10(step / scale) - 1e-9).clamp(0.0, 9.0);
    let places = places as usize;
    // No minus before a zero.
    let value = if value.abs() < step / 2.0 { 0.0 } else { value / scale };
    if value == 0.0 { "0".to_owned() } else { format!("{value:.places$}{letter}") }
}

/// A power of ten.
fn decade(exponent: f64) -> String {
    let exponent = exponent as i32;
    let raised = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => digit.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(digit),
    };
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10{}", exponent.to_string().chars().map(raised).collect::<String>()),
    }
}

/// A value in three digits or so.
fn short(value: f64) -> String {
    match value.abs() {
        size if size == 0.0 || (1e-3..1e6).contains(&size) => format!("{:.4}", value),
        _ => format!("{value:.1e}"),
    }
}
