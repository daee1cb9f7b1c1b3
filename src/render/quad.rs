//! The one primitive of a picture: a rotated rectangle in which the fragment shader (`scene.wgsl`) draws a
//! figure from signed distances. Units are cells, angles are radians counter-clockwise, y grows north.
//! Invariant: [`Figure`]'s numbers are those of `scene.wgsl`.

use super::palette::Rgba;
use crate::domain::{Color, Shape};

/// What is drawn inside a quad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Figure {
    /// A rectangle; `detail` = [corner radius, blur].
    Rect = 0,
    /// A rectangle's outline in `ink` around a tint in `fill`; `detail` = [corner radius, line width].
    Frame = 1,
    /// The lines between a room's inner cells, in `ink`; the quad reaches to the middle of the walls.
    Grid = 2,
    /// A room's floor in `fill`, shaded along its walls with `ink`; `detail` = [half a wall, reach of the shade].
    Floor = 3,
    /// A round badge with a padlock.
    Padlock = 4,
    /// A round badge with a question mark.
    Question = 5,
    /// The robot from above, looking north when not turned.
    Robot = 6,
    /// A chair.
    Chair = 7,
    /// A basket.
    Basket = 8,
    /// A block.
    Block = 9,
    /// A bag.
    Bag = 10,
    /// A backpack.
    Backpack = 11,
    /// A box.
    Box = 12,
    /// A colour's letter in `ink`, on a disc where `fill` is not clear; `detail[0]` = its place in [`Color::ALL`].
    Letter = 13,
    /// A cell's part of a region: the region's outline in `ink` around a tint in `fill`; `detail` = [which of its
    /// neighbours belong to the region too, as bits from 1: north, east, south,
    /// west, north-east, south-east, south-west, north-west, how far apart stripes in `ink` lie, 0 for none].
    Region = 14,
    /// What to do in a cell, in `fill`, north when not turned; `detail[0]` = its [`ArrowForm`].
    Arrow = 15,
    /// As [`Figure::Frame`], its line broken into dashes.
    Dashes = 16,
}

/// The neighbours of a cell as (east, north) steps; the i-th of them is bit i of a [`Figure::Region`]'s detail.
pub(super) const NEIGHBOURS: [(i32, i32); 8] =
    [(0, 1), (1, 0), (0, -1), (-1, 0), (1, 1), (1, -1), (-1, -1), (-1, 1)];

/// The forms of a [`Figure::Arrow`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum ArrowForm {
    /// Straight on.
    Straight = 0,
    /// Round to the left.
    Left = 1,
    /// Round to the right.
    Right = 2,
    /// There and back: an exchange of places.
    Exchange = 3,
}

impl From<Shape> for Figure {
    fn from(shape: Shape) -> Self {
        match shape {
            Shape::Chair => Self::Chair,
            Shape::Basket => Self::Basket,
            Shape::Block => Self::Block,
            Shape::Bag => Self::Bag,
            Shape::Backpack => Self::Backpack,
            Shape::Box => Self::Box,
        }
    }
}

/// One instance of the draw call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// Its centre.
    pub centre: [f32; 2],
    /// Half its width and height, before it is turned.
    pub half: [f32; 2],
    /// How far it is turned.
    pub turn: f32,
    /// What is drawn in it.
    pub figure: Figure,
    /// Two lengths whose meaning the figure gives.
    pub detail: [f32; 2],
    /// The main colour.
    pub fill: Rgba,
    /// The second colour: lines, outlines.
    pub ink: Rgba,
}

impl Quad {
    /// Numbers an instance takes.
    pub const FLOATS: usize = 16;

    /// A sharp rectangle with rounded corners.
    pub fn rect(centre: [f32; 2], half: [f32; 2], corner: f32, fill: Rgba) -> Self {
        let figure = Figure::Rect;
        Self { centre, half, turn: 0.0, figure, detail: [corner, 0.0], fill, ink: fill }
    }

    /// A rectangle whose edge fades over `blur` to either side.
    pub fn soft(centre: [f32; 2], half: [f32; 2], corner: f32, blur: f32, fill: Rgba) -> Self {
        Self { detail: [corner, blur], ..Self::rect(centre, half, corner, fill) }
    }

    /// A figure that fills a square.
    pub fn icon(figure: Figure, centre: [f32; 2], half: f32, fill: Rgba, ink: Rgba) -> Self {
        let detail = [0.0, 0.0];
        Self { centre, half: [half, half], turn: 0.0, figure, detail, fill, ink }
    }

    /// A colour's letter, in a square; on a disc where `disc` is not clear.
    pub fn letter(color: Color, centre: [f32; 2], half: f32, disc: Rgba, ink: Rgba) -> Self {
        let which = Color::ALL.iter().position(|c| *c == color).unwrap_or(0);
        let icon = Self::icon(Figure::Letter, centre, half, disc, ink);
        Self { detail: [which as f32, 0.0], ..icon }
    }

    /// The instance as the shader reads it: centre, half, turn, figure, detail, fill, ink.
    pub fn floats(&self) -> [f32; Self::FLOATS] {
        let ([x, y], [w, h], [p, q]) = (self.centre, self.half, self.detail);
        let (Rgba([r, g, b, a]), Rgba([s, t, u, v])) = (self.fill, self.ink);
        [x, y, w, h, self.turn, f32::from(self.figure as u8), p, q, r, g, b, a, s, t, u, v]
    }
}
