//! What is laid over the floors of a picture as quads: values, arrows, regions (goal cells, cells pointed out),
//! the keyboard's frame and a dragged thing's target. Cells outside the picture are left out.

use super::floor::Extent;
use super::options::{Arrow, Options};
use super::palette::{Rgba, unit};
use super::pose::heading;
use super::quad::{ArrowForm, Figure, NEIGHBOURS, Quad};
use rustc_hash::{FxHashMap, FxHashSet};

/// Half a tile's side for a value of 0, and what a value of 1 adds: the floor shows round every tile, so that
/// a room keeps its colour, and a tile's size says what its colour says.
const TILE: [f32; 2] = [0.3, 0.17];
/// Half an arrow's side.
const ARROW: f32 = 0.21;
/// How far apart the stripes of goal cells lie; the stripes of neighbours meet, as a cell holds a whole number.
const STRIPES: f32 = 0.25;

/// A tile for every value.
pub(super) fn values(options: &Options, extent: Extent, out: &mut Vec<Quad>) {
    let shown = options.values.iter().filter(|(x, y, _)| extent.contains(*x, *y));
    out.extend(shown.map(|(x, y, value)| {
        let half = TILE[0] + TILE[1] * unit(*value);
        Quad::rect(middle((*x, *y)), [half; 2], 0.09, options.theme.value(*value))
    }));
}

/// Goal cells, then the cells that are pointed out.
pub(super) fn regions(options: &Options, extent: Extent, out: &mut Vec<Quad>) {
    let theme = options.theme;
    region(&options.goal, extent, [theme.goal(), theme.goal_stripes()], STRIPES, out);
    let colour = theme.highlight();
    region(&options.highlight, extent, [colour.alpha(0.2), colour], 0.0, out);
}

/// The arrows, each in a colour that is seen on its cell's value.
pub(super) fn arrows(options: &Options, extent: Extent, out: &mut Vec<Quad>) {
    let values = options.values.iter().map(|(x, y, value)| ((*x, *y), *value));
    let values: FxHashMap<(i32, i32), f32> = values.collect();
    let shown = options.arrows.iter().filter(|(x, y, _)| extent.contains(*x, *y));
    out.extend(shown.map(|(x, y, arrow)| {
        let tile = values.get(&(*x, *y)).map(|value| options.theme.value(*value));
        let sign = tile.map_or(options.theme.signs(), Rgba::opposite);
        arrow_quad(*arrow, middle((*x, *y)), sign.alpha(0.8))
    }));
}

/// The frames about single cells: the keyboard's, and where a dragged thing would be let go.
pub(super) fn frames(options: &Options, extent: Extent, out: &mut Vec<Quad>) {
    let theme = options.theme;
    let seen = |(x, y): &(i32, i32)| extent.contains(*x, *y);
    if let Some(ghost) = options.ghost.filter(|ghost| seen(&ghost.target)) {
        let (figure, colour) = match ghost.allowed {
            true => (Figure::Frame, theme.highlight()),
            false => (Figure::Dashes, theme.refused()),
        };
        out.push(frame(figure, ghost.target, 0.46, 0.08, colour));
    }
    if let Some(cell) = options.cursor.filter(seen) {
        // A pale line inside a dark one, or the other way round: one of them is seen on any ground.
        out.push(frame(Figure::Frame, cell, 0.52, 0.1, theme.signs()));
        out.push(frame(Figure::Frame, cell, 0.44, 0.05, theme.backdrop()));
    }
}

/// Cells that share an outline where they touch; `fill` and `ink` as [`Figure::Region`] has them.
fn region(
    cells: &[(i32, i32)],
    extent: Extent,
    [fill, ink]: [Rgba; 2],
    stripes: f32,
    out: &mut Vec<Quad>,
) {
    let cells = cells.iter().filter(|(x, y)| extent.contains(*x, *y));
    let all: FxHashSet<&(i32, i32)> = cells.clone().collect();
    let mut drawn = FxHashSet::default();
    out.extend(cells.filter(|cell| drawn.insert(**cell)).map(|(x, y)| {
        let beside = |(east, north): &(i32, i32)| {
            all.contains(&(x.saturating_add(*east), y.saturating_add(*north)))
        };
        let bits = NEIGHBOURS.iter().enumerate().filter(|(_, step)| beside(step));
        let neighbours: u8 = bits.map(|(i, _)| 1 << i).sum();
        let icon = Quad::icon(Figure::Region, middle((*x, *y)), 0.5, fill, ink);
        Quad { detail: [f32::from(neighbours), stripes], ..icon }
    }));
}

fn arrow_quad(arrow: Arrow, centre: [f32; 2], colour: Rgba) -> Quad {
    let (form, turn) = match arrow {
        Arrow::Step(side) => (ArrowForm::Straight, heading(side)),
        Arrow::TurnLeft => (ArrowForm::Left, 0.0),
        Arrow::TurnRight => (ArrowForm::Right, 0.0),
        Arrow::Pull(side) => (ArrowForm::Exchange, heading(side)),
    };
    let icon = Quad::icon(Figure::Arrow, centre, ARROW, colour, colour);
    Quad { turn, detail: [f32::from(form as u8), 0.0], ..icon }
}

fn frame(figure: Figure, cell: (i32, i32), half: f32, line: f32, colour: Rgba) -> Quad {
    let tint = Rgba([0.0; 4]);
    let rect = Quad::rect(middle(cell), [half; 2], 0.16, tint);
    Quad { figure, detail: [0.16, line], ink: colour, ..rect }
}

fn middle((x, y): (i32, i32)) -> [f32; 2] {
    [x as f32, y as f32]
}
