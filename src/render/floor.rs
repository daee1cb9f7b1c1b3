//! Which cell is wall, floor or doorway: what the picture and the grid of cells both start from.
//! Cell coordinates, y grows north. A room's border cell is wall unless a door covers it (Williams et al.,
//! Section III); a picture shows at most [`Extent::MAX_SIDE`] cells a side, whatever the state claims.

use crate::domain::{Bounds, State};

/// A rectangle of whole cells, bounds inclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// The westernmost column.
    pub left: i32,
    /// The southernmost row.
    pub bottom: i32,
    /// Columns, at least 1.
    pub columns: u32,
    /// Rows, at least 1.
    pub rows: u32,
}

impl Extent {
    /// The most cells a side that are shown.
    pub const MAX_SIDE: u32 = 256;

    /// The smallest extent that holds everything in the state, cut to [`Extent::MAX_SIDE`].
    pub fn of(state: &State) -> Self {
        let mut all = cell(state.agent.x, state.agent.y);
        let regions =
            state.rooms.iter().map(|r| r.bounds).chain(state.doors.iter().map(|d| d.bounds));
        for b in regions.chain(state.objects.iter().map(|o| cell(o.x, o.y))) {
            all.left = all.left.min(b.left);
            all.bottom = all.bottom.min(b.bottom);
            all.right = all.right.max(b.right);
            all.top = all.top.max(b.top);
        }
        let side = |low: i32, high: i32| high.abs_diff(low).saturating_add(1).min(Self::MAX_SIDE);
        Self {
            left: all.left,
            bottom: all.bottom,
            columns: side(all.left, all.right),
            rows: side(all.bottom, all.top),
        }
    }

    /// The columns, from the west.
    pub fn xs(&self) -> impl DoubleEndedIterator<Item = i32> + use<> {
        let left = self.left;
        (0..self.columns).map(move |i| left.saturating_add_unsigned(i))
    }

    /// The rows, from the south.
    pub fn ys(&self) -> impl DoubleEndedIterator<Item = i32> + use<> {
        let bottom = self.bottom;
        (0..self.rows).map(move |i| bottom.saturating_add_unsigned(i))
    }

    /// Whether the cell is shown.
    pub fn contains(&self, x: i32, y: i32) -> bool {
        x >= self.left
            && y >= self.bottom
            && x.abs_diff(self.left) < self.columns
            && y.abs_diff(self.bottom) < self.rows
    }

    fn index(&self, x: i32, y: i32) -> Option<usize> {
        let row = y.abs_diff(self.bottom) as usize;
        self.contains(x, y).then(|| row * self.columns as usize + x.abs_diff(self.left) as usize)
    }
}

/// What a cell is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// In no room.
    Outside,
    /// A border cell of a room, no door in it.
    Wall,
    /// The inside of a room, by index into the state's rooms; of the last room where rooms overlap.
    Room(usize),
    /// A doorway, by index into the state's doors.
    Door(usize),
}

/// Every cell of an extent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Floor {
    /// What is covered.
    pub extent: Extent,
    cells: Vec<Ground>,
}

impl Floor {
    /// The ground of a state.
    pub fn of(state: &State) -> Self {
        let extent = Extent::of(state);
        let cells = vec![Ground::Outside; (extent.columns * extent.rows) as usize];
        let mut floor = Self { extent, cells };
        for (i, room) in state.rooms.iter().enumerate() {
            floor.fill(room.bounds, |_, _| Ground::Room(i));
        }
        for Bounds { left, bottom, right, top } in state.rooms.iter().map(|r| r.bounds) {
            let border = |x, y| x == left || x == right || y == bottom || y == top;
            floor.fill(Bounds { left, bottom, right, top }, |(x, y), now| {
                if border(x, y) { Ground::Wall } else { now }
            });
        }
        for (i, door) in state.doors.iter().enumerate() {
            floor.fill(door.bounds, |_, _| Ground::Door(i));
        }
        floor
    }

    /// The ground of a cell; outside where the extent ends.
    pub fn at(&self, x: i32, y: i32) -> Ground {
        let cell = self.extent.index(x, y).and_then(|i| self.cells.get(i));
        cell.copied().unwrap_or(Ground::Outside)
    }

    fn fill(&mut self, bounds: Bounds, ground: impl Fn((i32, i32), Ground) -> Ground) {
        let extent = self.extent;
        for y in extent.ys().filter(|y| (bounds.bottom..=bounds.top).contains(y)) {
            for x in extent.xs().filter(|x| (bounds.left..=bounds.right).contains(x)) {
                if let Some(slot) = extent.index(x, y).and_then(|i| self.cells.get_mut(i)) {
                    *slot = ground((x, y), *slot);
                }
            }
        }
    }
}

fn cell(x: i32, y: i32) -> Bounds {
    Bounds { left: x, bottom: y, right: x, top: y }
}
