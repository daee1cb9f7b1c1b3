//! Bit fields in two machine words: what a packed state is made of, and why a state may not fit.

use super::layout::Place;

/// A state in two machine words; only the [`Dynamics`](super::Dynamics) that packed it can read it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Packed(pub(super) u128);

/// Why a state cannot be packed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PackError {
    /// The fields need more bits than there are.
    #[error(
        "{objects} objects in {cells} cells need {bits} bits, more than {}: use fewer objects or a smaller world",
        u128::BITS
    )]
    TooLarge {
        /// How many objects there are.
        objects: usize,
        /// How many cells are no wall.
        cells: usize,
        /// How many bits all fields need.
        bits: usize,
    },
    /// Something stands in a wall.
    #[error("`{0}` stands in a wall")]
    InWall(String),
}

/// Bits above those of a state that a mark takes.
const MARK: u32 = 8;

impl Packed {
    /// The bits that a state may take for a mark to find room beside it.
    pub const MARKABLE: usize = (u128::BITS - MARK) as usize;

    /// The same state with a mark beside it, in the place of another: what an observer has noted down of the way there.
    /// It is no state for the [`Dynamics`](super::Dynamics) until the mark is taken off.
    #[must_use]
    pub const fn marked(self, mark: u8) -> Self {
        Self(self.unmarked().0 | (mark as u128) << Self::MARKABLE)
    }

    /// The state without its mark.
    #[must_use]
    pub const fn unmarked(self) -> Self {
        Self(self.0 & (u128::MAX >> MARK))
    }

    /// The mark.
    #[must_use]
    pub const fn mark(self) -> u8 {
        (self.0 >> Self::MARKABLE) as u8
    }

    /// The value of the `width` bits from `shift`; at most 16.
    #[inline]
    pub(super) const fn field(self, shift: u32, width: u32) -> Place {
        let (low, high) = (self.0 as u64, (self.0 >> 64) as u64);
        let bits = match shift {
            0..64 => low >> shift | (high << 1) << (63 - shift),
            _ => high >> (shift - 64),
        };
        (bits & ((1 << width) - 1)) as Place
    }

    /// The same with `value` in the `width` bits from `shift`.
    #[inline]
    pub(super) const fn with(self, shift: u32, width: u32, value: u64) -> Self {
        let (mask, value) = (at((1 << width) - 1, shift), at(value, shift));
        Self((self.0 & !mask) | value)
    }
}

/// So few bits, from `shift` on. By halves: where a word has 64 bits or less, to shift by what is not known beforehand is
/// a call for 128.
#[inline]
const fn at(bits: u64, shift: u32) -> u128 {
    let (low, high) = match shift {
        0..64 => (bits << shift, (bits >> 1) >> (63 - shift)),
        _ => (0, bits << (shift - 64)),
    };
    (high as u128) << 64 | low as u128
}
