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

    /// The value of the `width` bits from `shift`.
    #[inline]
    pub(super) const fn field(self, shift: u32, width: u32) -> Place {
        ((self.0 >> shift) & ((1 << width) - 1)) as Place
    }

    /// The same with `value` in the `width` bits from `shift`.
    #[inline]
    pub(super) const fn with(self, shift: u32, width: u32, value: u128) -> Self {
        let mask = ((1 << width) - 1) << shift;
        Self((self.0 & !mask) | (value << shift))
    }
}
