//! How far it is from one cell to others, a whole row of cells at once: breadth-first search on bit sets. Only what is
//! asked for is looked up, and the search ends when all of it was found. A set is one bit a cell of the extent, with a
//! column of wall at the end of each row, so that no step leads around the edge.

use super::layout::{Layout, Place};
use super::object::Direction;

/// Not reached, or not asked for.
const NONE: u16 = u16::MAX;

/// See the head of this file; kept for the next search.
#[derive(Clone, Debug)]
pub(super) struct Flood {
    /// Bits from one row to the next, in words and bits.
    row: (usize, usize),
    /// Words of a set. As many as a step north may cross are left free at both ends.
    size: usize,
    /// The bit of each place, and the place of each bit.
    bits: Vec<u32>,
    places: Vec<Place>,
    floor: Vec<u64>,
    /// What may be walked on, what of it was not reached yet, and what is asked for.
    free: Vec<u64>,
    left: Vec<u64>,
    wanted: Vec<u64>,
    /// How much of that was not reached yet.
    missing: usize,
    /// What is reached in 0, 1, … steps, one set after the other.
    levels: Vec<u64>,
    /// Steps to what was asked for, and the places of which they are known.
    steps: Vec<u16>,
    told: Vec<Place>,
}

impl Flood {
    /// A search on a layout, with nothing blocked or asked for.
    pub(super) fn new(layout: &Layout) -> Self {
        let extent = layout.extent();
        let side = |low: i32, high: i32| usize::try_from(high - low + 1).unwrap_or(0);
        let (columns, rows) =
            (side(extent.left, extent.right) + 1, side(extent.bottom, extent.top));
        let row = (columns / 64, columns % 64);
        let pad = row.0 + 1;
        let size = (columns * rows).div_ceil(64) + 2 * pad;
        let mut floor = vec![0; size];
        let mut places = vec![Place::MAX; 64 * size];
        let bit = |place: Place| {
            let (x, y) = layout.cell(place);
            let at = |low: i32, at: i32| usize::try_from(at - low).unwrap_or(0);
            64 * pad + at(extent.bottom, y) * columns + at(extent.left, x)
        };
        let bits: Vec<u32> = layout.places().map(|place| bit(place) as u32).collect();
        for place in layout.places() {
            floor[bit(place) / 64] |= 1 << (bit(place) % 64);
            places[bit(place)] = place;
        }
        Self {
            row,
            size,
            free: floor.clone(),
            left: floor.clone(),
            wanted: vec![0; size],
            missing: 0,
            levels: Vec::new(),
            steps: vec![NONE; bits.len()],
            told: Vec::new(),
            bits,
            places,
            floor,
        }
    }

    /// Blocks nothing and asks for nothing.
    pub(super) fn clear(&mut self) {
        self.free.copy_from_slice(&self.floor);
        self.wanted.fill(0);
        self.missing = 0;
        for place in self.told.drain(..) {
            self.steps[usize::from(place)] = NONE;
        }
    }

    /// Lets nothing walk on a place.
    pub(super) fn block(&mut self, place: Place) {
        let (word, bit) = self.bit(place);
        self.free[word] &= !bit;
    }

    /// Asks for a place.
    pub(super) fn want(&mut self, place: Place) {
        let (word, bit) = self.bit(place);
        if self.free[word] & bit != 0 && self.wanted[word] & bit == 0 {
            self.wanted[word] |= bit;
            self.missing += 1;
        }
    }

    /// Finds all that is asked for, or all that there is.
    pub(super) fn run(&mut self, start: Place, all: bool) {
        let (word, bit) = self.bit(start);
        let (over, by) = self.row;
        self.levels.clear();
        self.levels.resize(self.size, 0);
        self.levels[word] = bit;
        self.left.copy_from_slice(&self.free);
        self.left[word] &= !bit;
        self.missing -= usize::from(self.wanted[word] & bit != 0);
        self.tell(start, 0);
        // The words that the last set lies in.
        let (mut low, mut high) = (word, word + 1);
        let mut n = 0;
        while all || self.missing > 0 {
            n += 1;
            let end = self.levels.len();
            self.levels.resize(end + self.size, 0);
            let (before, next) = self.levels.split_at_mut(end);
            let last = &before[end - self.size..];
            (low, high) =
                ((low - over - 1).max(over + 1), (high + over + 1).min(self.size - over - 1));
            let shifted = |by: usize, back: usize| &last[low + by - back..high + by - back];
            let (here, less, more) = (shifted(0, 0), shifted(0, 1), shifted(1, 0));
            let (north, north_less) = (shifted(0, over), shifted(0, over + 1));
            let (south, south_more) = (shifted(over, 0), shifted(over + 1, 0));
            let next = &mut next[low..high];
            let left = &mut self.left[low..high];
            let wanted = &self.wanted[low..high];
            let (mut any, mut found) = (0, 0);
            // No branches, so that several words are worked out at once.
            for w in 0..next.len() {
                let along = here[w] << 1 | less[w] >> 63 | here[w] >> 1 | more[w] << 63;
                let up = north[w] << by | north_less[w] >> 1 >> (63 - by);
                let down = south[w] >> by | south_more[w] << 1 << (63 - by);
                let reached = (along | up | down) & left[w];
                next[w] = reached;
                left[w] &= !reached;
                any |= reached;
                found |= reached & wanted[w];
            }
            if any == 0 {
                self.levels.truncate(end);
                return;
            }
            if found != 0 {
                self.find(end, (low, high), n);
            }
            let set = &self.levels[end..];
            while set[low] == 0 {
                low += 1;
            }
            while set[high - 1] == 0 {
                high -= 1;
            }
        }
    }

    /// Notes what was asked for and is in the set from `begin` on, in these of its words.
    fn find(&mut self, begin: usize, (low, high): (usize, usize), steps: u16) {
        for w in low..high {
            let mut found = self.levels[begin + w] & self.wanted[w];
            while found != 0 {
                let place = self.places[64 * w + found.trailing_zeros() as usize];
                self.tell(place, steps);
                self.missing -= 1;
                found &= found - 1;
            }
        }
    }

    /// Steps to a place that was asked for, or to the start.
    pub(super) fn steps(&self, place: Place) -> Option<u32> {
        let steps = self.steps[usize::from(place)];
        (steps != NONE).then_some(u32::from(steps))
    }

    /// The places that were reached, nearest first, each with the steps.
    pub(super) fn reached(&self) -> impl Iterator<Item = (Place, u32)> + '_ {
        self.levels.chunks_exact(self.size).zip(0..).flat_map(move |(level, n)| {
            level.iter().enumerate().flat_map(move |(w, &word)| {
                let is_in = move |bit: &usize| word >> bit & 1 == 1;
                (0..64).filter(is_in).map(move |bit| (self.places[64 * w + bit], n))
            })
        })
    }

    /// The steps of a shortest walk to a place that was reached, the last one first.
    pub(super) fn back(&self, to: Place) -> Vec<Direction> {
        let (word, bit) = self.bit(to);
        let is_in = |level: &[u64], (word, bit): (usize, u64)| level[word] & bit != 0;
        let mut levels = self.levels.chunks_exact(self.size);
        let n = levels.position(|level| is_in(level, (word, bit))).unwrap_or(0);
        let columns = 64 * self.row.0 + self.row.1;
        let mut at = self.bits[usize::from(to)] as usize;
        let mut steps = Vec::with_capacity(n);
        for n in (0..n).rev() {
            let level = &self.levels[n * self.size..(n + 1) * self.size];
            let before = |direction: Direction| match direction {
                Direction::North => at - columns,
                Direction::South => at + columns,
                Direction::East => at - 1,
                Direction::West => at + 1,
            };
            let came = |direction: &&Direction| {
                let before = before(**direction);
                is_in(level, (before / 64, 1 << (before % 64)))
            };
            let Some(&direction) = Direction::ALL.iter().find(came) else { break };
            at = before(direction);
            steps.push(direction);
        }
        steps
    }

    fn tell(&mut self, place: Place, steps: u16) {
        self.steps[usize::from(place)] = steps;
        self.told.push(place);
    }

    fn bit(&self, place: Place) -> (usize, u64) {
        let bit = self.bits[usize::from(place)] as usize;
        (bit / 64, 1 << (bit % 64))
    }
}
