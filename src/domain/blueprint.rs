//! Seeded worlds of three to twelve rooms in several styles, up to 32 × 32 cells, with up to eight objects.
//! Invariants: a pure function of blueprint and seed; the state is legal, packs into two words, and every room
//! can be walked to unless the blueprint asks for a divided world; no object in a corner. What cannot be built
//! is refused in words.

use super::dynamics::Dynamics;
use super::generate::{cut, door, furnish, index, pick, signed};
use super::name::named;
use super::object::{Agent, Bounds, Color, Direction, Door, Lock, Room};
use super::packing::PackError;
use super::rules::Rules;
use super::state::State;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// How rooms lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Style {
    /// The largest room is cut in two, again and again.
    #[default]
    Cuts,
    /// Rows of rooms, each with walls of its own.
    Rows,
    /// A corridor from end to end with rooms on both sides, each with a door to it.
    Hall,
}

named!(Style, "style", Cuts "cuts" 'c', Rows "rows" 'r', Hall "hall" 'h');

/// The world to build. The default is the smallest kind of the corpora's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Blueprint {
    /// How rooms lie.
    pub style: Style,
    /// How many there are: 3 to 12.
    pub rooms: u32,
    /// Cells from west to east, walls included: 7 to 32.
    pub columns: u32,
    /// Cells from south to north, walls included: 7 to 32.
    pub rows: u32,
    /// How many objects: up to 8.
    pub objects: u32,
    /// The lock of every door.
    pub lock: Lock,
    /// Whether every room can be walked to from every other; if not, the rooms are in two parts.
    pub connected: bool,
}

impl Default for Blueprint {
    fn default() -> Self {
        Self {
            style: Style::Cuts,
            rooms: 3,
            columns: 9,
            rows: 9,
            objects: 1,
            lock: Lock::Unlocked,
            connected: true,
        }
    }
}

/// How many rooms there may be.
pub const ROOMS: RangeInclusive<u32> = 3..=12;
/// How many cells a side may have.
pub const SIDE: RangeInclusive<u32> = 7..=32;
/// Most objects.
pub const OBJECTS: u32 = 8;

/// Why a world cannot be built.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[expect(missing_docs, reason = "each message says what its fields are")]
pub enum BlueprintError {
    #[error("{0} rooms: use {first} to {last}", first = ROOMS.start(), last = ROOMS.end())]
    Rooms(u32),
    #[error("{0} cells a side: use {first} to {last}", first = SIDE.start(), last = SIDE.end())]
    Side(u32),
    #[error("{0} objects: use {OBJECTS} or fewer")]
    Objects(u32),
    #[error(
        "{rooms} rooms do not fit in {columns} × {rows} cells in the style `{style}`: \
         use fewer rooms, a larger world or another style"
    )]
    NoSpace { style: Style, rooms: u32, columns: u32, rows: u32 },
    #[error(
        "{objects} objects do not fit on the floor away from corners: use fewer or a larger world"
    )]
    NoFloor { objects: u32 },
    #[error(transparent)]
    Pack(#[from] PackError),
}

/// The narrowest room from wall line to wall line: two cells of floor.
const NARROWEST: u32 = 3;
/// How often a layout is tried anew before it is said not to fit.
const TRIES: usize = 64;

impl Blueprint {
    /// Builds the world that `seed` stands for.
    ///
    /// # Errors
    /// What is asked beyond the limits, or does not fit.
    pub fn build(&self, seed: u64) -> Result<State, BlueprintError> {
        self.check()?;
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        let Self { style, rooms, columns, rows, objects, .. } = *self;
        let bounds = (0..TRIES)
            .find_map(|_| self.layout(&mut rng))
            .ok_or(BlueprintError::NoSpace { style, rooms, columns, rows })?;
        let doors = self.doors(&bounds, &mut rng);
        let rooms = colored(&bounds, &mut rng);
        let agent = Agent { x: 0, y: 0, direction: pick(Direction::ALL, &mut rng) };
        let mut state = State { agent, rooms, doors, objects: Vec::new() };
        furnish(&mut state, objects, &mut rng);
        if state.objects.len() < objects as usize {
            return Err(BlueprintError::NoFloor { objects });
        }
        Dynamics::new(&state, Rules::default())?;
        Ok(state)
    }

    fn check(&self) -> Result<(), BlueprintError> {
        if !ROOMS.contains(&self.rooms) {
            return Err(BlueprintError::Rooms(self.rooms));
        }
        if let Some(&side) = [self.columns, self.rows].iter().find(|s| !SIDE.contains(s)) {
            return Err(BlueprintError::Side(side));
        }
        if self.objects > OBJECTS {
            return Err(BlueprintError::Objects(self.objects));
        }
        Ok(())
    }

    /// The bounds of all rooms; `None` when this draw leaves no space for one.
    fn layout(&self, rng: &mut Pcg64Mcg) -> Option<Vec<Bounds>> {
        let (right, top) = (signed(self.columns - 1), signed(self.rows - 1));
        let whole = Bounds { left: 0, bottom: 0, right, top };
        match self.style {
            Style::Cuts => self.cuts(whole, rng),
            Style::Rows => self.in_rows(whole, rng),
            Style::Hall => self.hall(whole, rng),
        }
    }

    fn cuts(&self, whole: Bounds, rng: &mut Pcg64Mcg) -> Option<Vec<Bounds>> {
        let mut rooms = vec![whole];
        while rooms.len() < self.rooms as usize {
            let long = |b: &Bounds| (b.right - b.left).max(b.top - b.bottom);
            let can_cut = rooms.iter().enumerate().filter(|r| long(r.1) >= signed(2 * NARROWEST));
            // The first of the largest.
            let (at, _) = can_cut.min_by_key(|(i, b)| (-b.area(), *i))?;
            let room = rooms.swap_remove(at);
            let (width, height) = (room.right - room.left, room.top - room.bottom);
            let both = width.min(height) >= signed(2 * NARROWEST);
            let upright = if both { rng.random_bool(0.5) } else { width > height };
            rooms.extend(<[Bounds; 2]>::from(cut(room, upright, rng)));
        }
        Some(rooms)
    }

    fn in_rows(&self, whole: Bounds, rng: &mut Pcg64Mcg) -> Option<Vec<Bounds>> {
        let n = rng.random_range(1..=self.rooms);
        let lines = split(whole.bottom, whole.top, n, rng)?;
        let mut rooms = Vec::new();
        for (row, line) in (0..n).zip(lines.windows(2)) {
            let in_row = self.rooms / n + u32::from(row < self.rooms % n);
            let row = Bounds { bottom: line[0], top: line[1], ..whole };
            rooms.extend(side_by_side(row, in_row, rng)?);
        }
        Some(rooms)
    }

    fn hall(&self, whole: Bounds, rng: &mut Pcg64Mcg) -> Option<Vec<Bounds>> {
        let lines = split(whole.bottom, whole.top, 3, rng)?;
        let &[bottom, low, .., top] = &lines[..] else { return None };
        // The corridor is as narrow as can be; what is over goes to the rooms north of it.
        let high = low + signed(NARROWEST);
        let south = (self.rooms - 1) / 2;
        let mut rooms = vec![Bounds { bottom: low, top: high, ..whole }];
        rooms.extend(side_by_side(Bounds { bottom, top: low, ..whole }, south, rng)?);
        let north = Bounds { bottom: high, top, ..whole };
        rooms.extend(side_by_side(north, self.rooms - 1 - south, rng)?);
        Some(rooms)
    }

    /// A door for each edge of a random tree over the rooms that share a wall (in a hall, from the corridor),
    /// and for one in four of the other walls; in a divided world, none between two parts of the tree.
    fn doors(&self, rooms: &[Bounds], rng: &mut Pcg64Mcg) -> Vec<Door> {
        let mut walls: Vec<(usize, usize)> = Vec::new();
        for (b, second) in rooms.iter().enumerate() {
            let shares = |a: &usize| door(&rooms[*a], second, 0, &mut rng.clone()).is_some();
            walls.extend((0..b).filter(shares).map(|a| (a, b)));
        }
        for i in (1..walls.len()).rev() {
            walls.swap(i, index(i + 1, rng));
        }
        if self.style == Style::Hall {
            let (corridor, others) = walls.into_iter().partition::<Vec<_>, _>(|wall| wall.0 == 0);
            walls = corridor;
            walls.extend(others);
        }
        // The part that each room belongs to. One edge less leaves two.
        let mut part: Vec<usize> = (0..rooms.len()).collect();
        let mut edges = rooms.len() - 1 - usize::from(!self.connected);
        let mut open = Vec::new();
        let mut spare = Vec::new();
        for (a, b) in walls {
            let (from, to) = (part[a], part[b]);
            if from != to && edges > 0 {
                part.iter_mut().filter(|p| **p == from).for_each(|p| *p = to);
                edges -= 1;
                open.push((a, b));
            } else {
                spare.push((a, b));
            }
        }
        spare.retain(|&(a, b)| part[a] == part[b] && rng.random_bool(0.25));
        open.extend(spare);
        let numbered = open.into_iter().enumerate();
        let made = numbered.filter_map(|(i, (a, b))| door(&rooms[a], &rooms[b], i, rng));
        made.map(|door| Door { lock: self.lock, ..door }).collect()
    }
}

/// Rooms side by side that fill a row.
fn side_by_side(row: Bounds, n: u32, rng: &mut Pcg64Mcg) -> Option<Vec<Bounds>> {
    let lines = split(row.left, row.right, n, rng)?;
    Some(lines.windows(2).map(|l| Bounds { left: l[0], right: l[1], ..row }).collect())
}

/// The wall lines of `n` rooms one after the other, the outer ones included; `None` when they do not fit.
fn split(from: i32, to: i32, n: u32, rng: &mut Pcg64Mcg) -> Option<Vec<i32>> {
    let narrowest = signed(NARROWEST);
    let over = to - from - signed(n) * narrowest;
    if n == 0 || over < 0 {
        return None;
    }
    let mut extra: Vec<i32> = Vec::new();
    for _ in 1..n {
        let one = rng.random_range(0..=over);
        extra.insert(extra.partition_point(|&other| other <= one), one);
    }
    let inner = (1..).zip(extra).map(|(i, extra)| from + i * narrowest + extra);
    Some(std::iter::once(from).chain(inner).chain(std::iter::once(to)).collect())
}

/// Rooms with colours that repeat only when there are more rooms than colours.
fn colored(bounds: &[Bounds], rng: &mut Pcg64Mcg) -> Vec<Room> {
    let mut colors = Vec::new();
    let mut rooms = Vec::new();
    for (i, &bounds) in bounds.iter().enumerate() {
        if colors.is_empty() {
            colors = Color::ALL.to_vec();
        }
        let color = colors.swap_remove(index(colors.len(), rng));
        rooms.push(Room { name: format!("room{i}"), color, bounds });
    }
    rooms
}
