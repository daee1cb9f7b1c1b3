//! Walls and doors as quads. Walls are bars along the middle of their cells, as on an architect's plan, each
//! as long as a straight run of wall cells; a doorway is a gap with a sill and two posts. A door is closed by
//! a leaf, broken for `unknown` and whole for `locked`, and bears a badge (a question mark, a padlock), so that
//! the three states differ in form as well as in colour. Units are cells.

use super::floor::{Floor, Ground};
use super::palette::{Rgba, Theme};
use super::quad::{Figure, Quad};
use crate::domain::{Bounds, Door, Lock};

/// Half a wall's thickness.
pub(super) const THICK: f32 = 0.2;
/// Half a door post's length across the wall, and half its width.
const POST: [f32; 2] = [0.28, 0.08];

/// A bar along a row or a column of cells.
struct Run {
    upright: bool,
    /// The row, or the column, it lies in.
    line: i32,
    from: f32,
    to: f32,
}

impl Run {
    fn centre(&self) -> [f32; 2] {
        oriented(self.upright, [f32::midpoint(self.from, self.to), self.line as f32])
    }

    fn half(&self) -> [f32; 2] {
        oriented(self.upright, [(self.to - self.from) / 2.0, THICK])
    }
}

/// The walls of all rooms.
pub(super) fn walls(floor: &Floor, theme: Theme, out: &mut Vec<Quad>) {
    let bar = |run: &Run| Quad::rect(run.centre(), run.half(), 0.06, theme.wall());
    out.extend(runs(floor).iter().map(bar));
}

/// The sill of a doorway, which lies on the floor.
pub(super) fn sill(door: &Door, floor: &Floor, theme: Theme) -> Quad {
    let (along, half, upright) = span(door, floor);
    let half = oriented(upright, [half, across(door.bounds, upright) + THICK]);
    Quad::rect(along, half, 0.0, theme.sill())
}

/// Posts, leaf and badge of a door.
pub(super) fn door(door: &Door, floor: &Floor, theme: Theme, out: &mut Vec<Quad>) {
    let (centre, half, upright) = span(door, floor);
    let place = |along: f32| {
        let [x, y] = oriented(upright, [along, 0.0]);
        [centre[0] + x, centre[1] + y]
    };
    let leaf = |out: &mut Vec<Quad>, along: f32, half: f32, thick: f32, fill: Rgba| {
        out.push(Quad::rect(place(along), oriented(upright, [half, thick]), 0.05, fill));
    };
    let depth = across(door.bounds, upright);
    match door.lock {
        Lock::Unlocked => {}
        Lock::Unknown => {
            for step in [-1.0, 0.0, 1.0] {
                leaf(out, step * half * 0.66, half * 0.22, 0.08, theme.unknown_leaf());
            }
        }
        Lock::Locked => leaf(out, 0.0, half, 0.13, theme.locked_leaf()),
    }
    for side in [-1.0, 1.0] {
        let post = oriented(upright, [POST[1], depth + POST[0]]);
        out.push(Quad::rect(place(side * half), post, POST[1], theme.wall()));
    }
    let badge = |figure, fill| Quad::icon(figure, centre, 0.3, fill, theme.on_badge());
    match door.lock {
        Lock::Unlocked => {}
        Lock::Unknown => out.push(badge(Figure::Question, theme.unknown_leaf())),
        Lock::Locked => out.push(badge(Figure::Padlock, theme.locked_leaf())),
    }
}

/// Straight runs of wall cells, rows first; a cell that belongs to none is a run of its own.
fn runs(floor: &Floor) -> Vec<Run> {
    let mut runs = Vec::new();
    for y in floor.extent.ys() {
        line(floor, false, y, floor.extent.xs(), &mut runs);
    }
    for x in floor.extent.xs() {
        line(floor, true, x, floor.extent.ys(), &mut runs);
    }
    runs
}

/// The runs of one row or column.
fn line(
    floor: &Floor,
    upright: bool,
    line: i32,
    cells: impl Iterator<Item = i32>,
    runs: &mut Vec<Run>,
) {
    let ground = |along: i32, line: i32| {
        let [x, y] = if upright { [line, along] } else { [along, line] };
        floor.at(x, y)
    };
    let mut start = None;
    for i in cells {
        if ground(i, line) != Ground::Wall {
            start = None;
            continue;
        }
        let first = *start.get_or_insert(i);
        if ground(i.saturating_add(1), line) == Ground::Wall {
            continue;
        }
        let is_door = |along: i32| matches!(ground(along, line), Ground::Door(_));
        let doors = [is_door(first.saturating_sub(1)), is_door(i.saturating_add(1))];
        let aside = |step: i32| ground(i, line.saturating_add(step)) == Ground::Wall;
        let lonely = !upright && !aside(1) && !aside(-1);
        if first < i || doors.contains(&true) || lonely {
            // Up to the doorway's edge, else to the outer face of the wall that is met at the corner.
            let reach = |door: bool| if door { 0.5 } else { THICK };
            let (from, to) = (first as f32 - reach(doors[0]), i as f32 + reach(doors[1]));
            runs.push(Run { upright, line, from, to });
        }
    }
}

/// A door's centre, half its length along the wall, and whether that wall runs north.
fn span(door: &Door, floor: &Floor) -> ([f32; 2], f32, bool) {
    let Bounds { left, bottom, right, top } = door.bounds;
    let (columns, rows) = (right as f32 - left as f32 + 1.0, top as f32 - bottom as f32 + 1.0);
    let walled = |x: i32, y: i32| floor.at(x, y) == Ground::Wall;
    let beside = walled(left.saturating_sub(1), bottom) || walled(right.saturating_add(1), bottom);
    let upright = if columns == rows { !beside } else { rows > columns };
    let centre = [(left as f32 + right as f32) / 2.0, (bottom as f32 + top as f32) / 2.0];
    (centre, if upright { rows } else { columns } / 2.0, upright)
}

/// How far a door reaches across the wall beyond one cell: 0 but for doors thicker than a wall.
fn across(bounds: Bounds, upright: bool) -> f32 {
    let Bounds { left, bottom, right, top } = bounds;
    (if upright { right as f32 - left as f32 } else { top as f32 - bottom as f32 }) / 2.0
}

/// (along, across) as (x, y).
fn oriented(upright: bool, [along, across]: [f32; 2]) -> [f32; 2] {
    if upright { [across, along] } else { [along, across] }
}
