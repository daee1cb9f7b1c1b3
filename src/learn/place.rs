//! Where a run stands, as a checkpoint says it, and why a run cannot go on from one.

/// The facts of a checkpoint that a finished model does not have.
pub(super) const PLACE: [&str; 5] =
    ["at_epoch", "at_example", "at_valid", "at_updates", "at_over_budget"];

/// The fact of a checkpoint that says which commands the learned entries came from.
pub(super) const BORN: &str = "at_born";

/// Why a run cannot go on from a checkpoint.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the checkpoint does not fit: its {fact} is {theirs}, that of this run is {ours}")]
pub struct ResumeError {
    /// The fact that differs.
    pub fact: String,
    /// Its value in the checkpoint.
    pub theirs: String,
    /// Its value in this run.
    pub ours: String,
}

/// The commands that the learned entries came from, as a checkpoint has them; none if they cannot be these.
pub(super) fn born(fact: Option<&String>, n_items: usize, n_entries: usize) -> Vec<u32> {
    let places = fact.map_or("", String::as_str).split_whitespace();
    let born: Result<Vec<u32>, _> = places.map(str::parse).collect();
    let fits =
        |born: &Vec<u32>| born.len() <= n_entries && born.iter().all(|&at| (at as usize) < n_items);
    born.ok().filter(fits).unwrap_or_default()
}
