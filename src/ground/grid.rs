//! Sets of places, a bit each, a row of cells after the other: what lies next to a set is a few shifts. A column of wall
//! at the end of each row keeps steps from leading around the edge.

use crate::domain::layout::{Layout, Place};

/// Where the bits of places are.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// Bits from one row to the next, in words and bits.
    row: (usize, usize),
    /// Words of a set. As many as a step north may cross are left free at both ends.
    size: usize,
    bits: Vec<u32>,
    places: Vec<Place>,
}

impl Grid {
    pub(super) fn new(layout: &Layout) -> Self {
        let extent = layout.extent();
        let side = |low: i32, high: i32| usize::try_from(high - low + 1).unwrap_or(0);
        let columns = side(extent.left, extent.right) + 1;
        let row = (columns / 64, columns % 64);
        let pad = row.0 + 1;
        let size = (columns * side(extent.bottom, extent.top)).div_ceil(64) + 2 * pad;
        let bit = |place: Place| {
            let (x, y) = layout.cell(place);
            let at = |low: i32, at: i32| usize::try_from(at - low).unwrap_or(0);
            64 * pad + at(extent.bottom, y) * columns + at(extent.left, x)
        };
        let bits: Vec<u32> = layout.places().map(|place| bit(place) as u32).collect();
        let mut places = vec![Place::MAX; 64 * size];
        for (place, &bit) in (0..).zip(&bits) {
            places[bit as usize] = place;
        }
        Self { row, size, bits, places }
    }

    /// Words of a set.
    pub(super) const fn size(&self) -> usize {
        self.size
    }

    /// The words of a set in which places are.
    pub(super) fn words(&self) -> std::ops::Range<usize> {
        let pad = self.row.0 + 1;
        pad..self.size - pad
    }

    /// The word and the bit of a place.
    #[inline]
    pub(super) fn bit(&self, place: usize) -> (usize, u64) {
        let bit = self.bits[place] as usize;
        (bit / 64, 1 << (bit % 64))
    }

    /// The places of some bits of a word.
    #[inline]
    pub(super) fn each(&self, word: usize, mut bits: u64, mut see: impl FnMut(usize)) {
        while bits != 0 {
            see(usize::from(self.places[64 * word + bits.trailing_zeros() as usize]));
            bits &= bits - 1;
        }
    }

    /// One word of what lies next to a set, walls and all.
    #[inline]
    pub(super) fn around(&self, set: &[u64], w: usize) -> u64 {
        let (over, by) = self.row;
        let along = set[w] << 1 | set[w - 1] >> 63 | set[w] >> 1 | set[w + 1] << 63;
        let north = set[w - over] << by | set[w - over - 1] >> 1 >> (63 - by);
        let south = set[w + over] >> by | set[w + over + 1] << 1 << (63 - by);
        along | north | south
    }
}
