//! The graph of the cells that a thing can stand on.

use super::cell::{Cell, cell_at};
use super::object::{Bounds, Direction};
use super::state::State;

/// The index of a cell that is no wall: row by row, from the south-west.
pub type Place = u16;

/// No place: what lies behind a wall.
pub const NOWHERE: Place = Place::MAX;

/// The places of a world and their neighbours. Built once, then only read.
#[derive(Clone, Debug)]
pub struct Layout {
    extent: Bounds,
    /// Place of each cell of the extent, row by row from the south-west, or [`NOWHERE`].
    grid: Vec<Place>,
    /// Column and row of each place.
    cells: Vec<(i32, i32)>,
    /// The places north, south, east and west of each place, or [`NOWHERE`].
    neighbours: Vec<[Place; 4]>,
    /// The door that each place belongs to.
    doors: Vec<Option<u8>>,
}

impl Layout {
    /// Compiles rooms and doors of a state that was checked.
    #[must_use]
    pub fn new(state: &State) -> Self {
        let empty = Bounds { left: 0, bottom: 0, right: -1, top: -1 };
        let extent = state.extent().unwrap_or(empty);
        let mut layout = Self {
            extent,
            grid: Vec::new(),
            cells: Vec::new(),
            neighbours: Vec::new(),
            doors: Vec::new(),
        };
        for (x, y) in extent.cells() {
            let door = match cell_at(&state.rooms, &state.doors, x, y) {
                Cell::Wall => {
                    layout.grid.push(NOWHERE);
                    continue;
                }
                Cell::Floor => None,
                Cell::Door(d) => u8::try_from(d).ok(),
            };
            // A checked state has at most 255 × 255 cells, so NOWHERE is no cell.
            layout.grid.push(Place::try_from(layout.cells.len()).unwrap_or(NOWHERE));
            layout.cells.push((x, y));
            layout.doors.push(door);
        }
        layout.neighbours = layout
            .cells
            .iter()
            .map(|&(x, y)| {
                let mut around = [NOWHERE; 4];
                for (slot, direction) in around.iter_mut().zip(Direction::ALL) {
                    let (dx, dy) = direction.step();
                    *slot = layout.place(x + dx, y + dy).unwrap_or(NOWHERE);
                }
                around
            })
            .collect();
        layout
    }

    /// The rectangle that holds all rooms and doors; empty (right < left) when there are none.
    #[must_use]
    pub const fn extent(&self) -> Bounds {
        self.extent
    }

    /// How many places there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether there is nowhere to stand.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// The place at column `x`, row `y`, if it is no wall.
    #[must_use]
    pub fn place(&self, x: i32, y: i32) -> Option<Place> {
        let e = self.extent;
        if !e.contains(x, y) {
            return None;
        }
        let index = (y - e.bottom) * (e.right - e.left + 1) + (x - e.left);
        let place = *self.grid.get(usize::try_from(index).ok()?)?;
        (place != NOWHERE).then_some(place)
    }

    /// All places, in order.
    pub fn places(&self) -> impl Iterator<Item = Place> + use<> {
        0..Place::try_from(self.cells.len()).unwrap_or(NOWHERE)
    }

    /// Column and row of a place of this layout.
    #[must_use]
    pub fn cell(&self, place: Place) -> (i32, i32) {
        self.cells[usize::from(place)]
    }

    /// The place next to a place of this layout, or [`NOWHERE`] when there is wall.
    #[inline]
    #[must_use]
    pub fn neighbour(&self, place: Place, direction: Direction) -> Place {
        self.neighbours[usize::from(place)][direction as usize]
    }

    /// The places next to a place of this layout, by [`Direction`], or [`NOWHERE`].
    #[inline]
    #[must_use]
    pub fn neighbours(&self, place: Place) -> [Place; 4] {
        self.neighbours[usize::from(place)]
    }

    /// The door that a place of this layout belongs to.
    #[inline]
    #[must_use]
    pub fn door(&self, place: Place) -> Option<usize> {
        self.doors[usize::from(place)].map(usize::from)
    }
}
