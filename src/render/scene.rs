//! A picture of a state as plain data: quads from back to front, in cells. Pure: the same state and options give
//! the same scene, and `gpu` draws it in one call.

use super::floor::{Extent, Floor};
use super::options::Options;
use super::palette::{Rgba, Theme};
use super::pose::Pose;
use super::quad::{Figure, Quad};
use super::{overlay, things, walls};
use crate::domain::{Bounds, Room, State};

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
        quads.extend(state.doors.iter().map(|door| walls::sill(door, &floor, theme)));
        overlay::values(options, floor.extent, &mut quads);
        overlay::regions(options, floor.extent, &mut quads);
        overlay::arrows(options, floor.extent, &mut quads);
        let letters = state.rooms.iter().filter(|room| !options.named && room.bounds.area() > 3);
        quads.extend(letters.map(|room| room_letter(room, theme)));
        walls::walls(&floor, theme, &mut quads);
        for door in &state.doors {
            walls::door(door, &floor, theme, &mut quads);
        }
        overlay::frames(options, floor.extent, &mut quads);
        things::things(state, pose, options, &mut quads);
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

    /// The point under a pixel, in cells: a cell's middle is its coordinates.
    pub fn point(&self, x: f32, y: f32) -> [f32; 2] {
        let [left, top] = self.corner.map(|side| side as f32);
        let [east, south] = [(x - self.origin[0]) / self.scale, (y - self.origin[1]) / self.scale];
        [left - 0.5 + east, top + 0.5 - south]
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
