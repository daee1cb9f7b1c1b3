//! How far training is, and what an epoch did.

/// How far training is, after an example.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The epoch at work, from 1; one past the last while idioms are looked for.
    pub epoch: u32,
    /// Examples of this epoch that were seen.
    pub example: usize,
    /// What this epoch did so far.
    pub so_far: Epoch,
}

/// What an epoch did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Epoch {
    /// Examples with a valid parse.
    pub valid: usize,
    /// Updates of the weights.
    pub updates: usize,
    /// Entries of the lexicon at its end.
    pub entries: usize,
    /// Sentences whose chart ran out of its budget.
    pub over_budget: usize,
}
