//! A picture of a state as plain data: quads from back to front, in cells. Pure: the same state and options give
//! the same scene, and `gpu.rs` draws it in one call.

use super::floor::{Extent, Floor};
use super::motion::Pose;
use super::palette::{Rgba, Theme};
use super::quad::{Figure, Quad};
use super::walls;
use crate::domain::{Bounds, Object, Room, Size, State};

/// How a state is to be shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The set of colours.
    pub theme: Theme,
    /// Cells (x, y) to point out: where a goal holds, what a phrase refers to.
    pub highlight: Vec<(i32, i32)>,
    /// Whether each object bears its colour's letter; a room always does.
    pub letters: bool,
}

/// A picture: quads on a ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The cells that are shown. A cell is a unit square about its coordinates.
    pub extent: Extent,
    /// What lies behind all quads.
    pub backdrop: Rgba,
    /// From back to front.
    pub quads: Vec<Quad>,
}

/// A canvas that shows an extent as large as it can, centred. Pixels count from the top left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Pixels a cell.
    pub scale: f32,
    /// The pixel of the extent's north-western corner.
    pub origin: [f32; 2],
    corner: [i32; 2],
}

impl Scene {
    /// Numbers before the first quad in [`Scene::floats`].
    pub const HEADER: usize = 8;

    /// The picture of a state.
    pub fn of(state: &State, options: &Options) -> Self {
        Self::posed(state, &Pose::of(state), options)
    }

    /// The picture of a state whose robot and objects are on their way.
    pub fn posed(state: &State, pose: &Pose, options: &Options) -> Self {
        let theme = options.theme;
        let floor = Floor::of(state);
        let mut quads = Vec::new();
        quads.extend(state.rooms.iter().flat_map(|room| floor_quads(room, theme)));
        let letters = state.rooms.iter().filter(|room| room.bounds.area() > 3);
        quads.extend(letters.map(|room| room_letter(room, theme)));
        quads.extend(state.doors.iter().map(|door| walls::sill(door, &floor, theme)));
        let shown = options.highlight.iter().filter(|(x, y)| floor.extent.contains(*x, *y));
        quads.extend(shown.map(|cell| highlight(*cell, theme)));
        walls::walls(&floor, theme, &mut quads);
        for door in &state.doors {
            walls::door(door, &floor, theme, &mut quads);
        }
        for (object, place) in state.objects.iter().zip(&pose.objects) {
            quads.extend(object_quads(object, *place, theme));
            quads.extend(options.letters.then(|| object_letter(object, *place, theme)));
        }
        quads.extend(robot_quads(pose, theme));
        Self { extent: floor.extent, backdrop: theme.backdrop(), quads }
    }

    /// The scene as it crosses to the renderer: left edge, lower edge, columns, rows, the backdrop's four
    /// components, then [`Quad::FLOATS`] numbers a quad.
    pub fn floats(&self) -> Vec<f32> {
        let Extent { left, bottom, columns, rows } = self.extent;
        let Rgba([r, g, b, a]) = self.backdrop;
        let (left, bottom) = (left as f32 - 0.5, bottom as f32 - 0.5);
        let mut floats = vec![left, bottom, columns as f32, rows as f32, r, g, b, a];
        floats.extend(self.quads.iter().flat_map(Quad::floats));
        floats
    }
}

impl Fit {
    /// The fit into a canvas of `width` by `height` pixels.
    pub fn new(extent: Extent, width: f32, height: f32) -> Self {
        let (columns, rows) = (extent.columns as f32, extent.rows as f32);
        let scale = (width / columns).min(height / rows);
        let origin = [(width - scale * columns) / 2.0, (height - scale * rows) / 2.0];
        let top = extent.bottom.saturating_add_unsigned(extent.rows - 1);
        Self { scale, origin, corner: [extent.left, top] }
    }

    /// The cell under a pixel, which may lie outside the extent.
    pub fn cell(&self, x: f32, y: f32) -> (i32, i32) {
        let steps = |pixel: f32, origin: f32| libm::floorf((pixel - origin) / self.scale) as i32;
        let (east, south) = (steps(x, self.origin[0]), steps(y, self.origin[1]));
        (self.corner[0].saturating_add(east), self.corner[1].saturating_sub(south))
    }
}

/// A room's floor, up to the middle of its walls, and the lines between the cells inside.
fn floor_quads(room: &Room, theme: Theme) -> impl Iterator<Item = Quad> {
    let Bounds { left, bottom, right, top } = room.bounds;
    let centre = [(left as f32 + right as f32) / 2.0, (bottom as f32 + top as f32) / 2.0];
    let half = [(right as f32 - left as f32) / 2.0, (top as f32 - bottom as f32) / 2.0];
    let floor = Quad {
        figure: Figure::Floor,
        detail: [walls::THICK, 0.26],
        ink: theme.shadow(),
        ..Quad::rect(centre, half, 0.0, theme.floor(room.color))
    };
    let grid = Quad { figure: Figure::Grid, ink: theme.grid(), ..floor };
    [floor, grid].into_iter().filter(|quad| quad.half[0] > 0.0 && quad.half[1] > 0.0)
}

/// The letter of a room's colour, in the room's north-western corner.
fn room_letter(room: &Room, theme: Theme) -> Quad {
    let centre = [room.bounds.left as f32 + 0.56, room.bounds.top as f32 - 0.56];
    let ink = theme.floor(room.color).mix(theme.signs(), 0.62);
    Quad::letter(room.color, centre, 0.17, Rgba([0.0; 4]), ink)
}

/// The letter of an object's colour, on a disc at its lower right.
fn object_letter(object: &Object, [x, y]: [f32; 2], theme: Theme) -> Quad {
    Quad::letter(object.color, [x + 0.32, y - 0.32], 0.16, theme.backdrop(), theme.signs())
}

fn highlight((x, y): (i32, i32), theme: Theme) -> Quad {
    let colour = theme.highlight();
    let frame = Quad::rect([x as f32, y as f32], [0.44, 0.44], 0.16, colour.alpha(0.16));
    Quad { figure: Figure::Frame, detail: [0.16, 0.06], ink: colour.alpha(0.85), ..frame }
}

/// An object and its shadow at a place.
fn object_quads(object: &Object, [x, y]: [f32; 2], theme: Theme) -> [Quad; 2] {
    let half = match object.size {
        Some(Size::Small) => 0.29,
        Some(Size::Medium) | None => 0.39,
        Some(Size::Large) => 0.47,
    };
    let shadow = [x + 0.02, y - half * 0.86];
    let icon = Figure::from(object.shape);
    [
        Quad::soft(shadow, [half * 0.8, half * 0.2], half * 0.2, half * 0.24, theme.shadow()),
        Quad::icon(icon, [x, y], half, theme.object(object.color), theme.ink()),
    ]
}

/// The robot and its shadow.
fn robot_quads(pose: &Pose, theme: Theme) -> [Quad; 2] {
    let [x, y] = pose.robot;
    let robot = Quad::icon(Figure::Robot, pose.robot, 0.46, theme.robot(), theme.robot_face());
    [
        Quad::soft([x + 0.03, y - 0.08], [0.36, 0.36], 0.36, 0.12, theme.shadow()),
        Quad { turn: pose.turn, ..robot },
    ]
}
