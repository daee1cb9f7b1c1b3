//! Clauses: where a word that joins or orders stands before an imperative, one command ends and another begins. Nothing
//! within a clause is put together with what stands outside; clauses are, whole, from the first to the last. So each is
//! read as if it stood alone, and a sentence costs what its clauses cost.

/// The places at which clauses begin, but for the first word of the sentence.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Clauses(u64);

impl Clauses {
    /// The whole sentence is one.
    pub const ONE: Clauses = Clauses(0);

    /// With one more, which begins at this place.
    #[must_use]
    pub fn with(self, at: usize) -> Self {
        Clauses(if at < u64::BITS as usize { self.0 | 1 << at } else { self.0 })
    }

    /// Whether words may make a constituent: no clause begins within them, or they are whole clauses from the first on.
    pub(super) fn admit(self, start: usize, end: usize) -> bool {
        !self.part(start, end) || start == 0 && (self.0 >> end) & 1 == 1
    }

    /// Whether the words before a place and those behind it are of different clauses, both among these words.
    pub(super) fn part(self, start: usize, end: usize) -> bool {
        (start + 1..end).any(|at| (self.0 >> at) & 1 == 1)
    }
}
