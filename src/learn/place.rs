//! Where a run stands, as a checkpoint says it, why a run cannot go on from one, and the order of an epoch.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

/// The facts of a checkpoint that a finished model does not have.
pub(super) const PLACE: [&str; 5] =
    ["at_epoch", "at_example", "at_valid", "at_updates", "at_over_budget"];

/// The fact of a checkpoint that says which commands the learned entries came from.
pub(super) const BORN: &str = "at_born";

/// The fact of a checkpoint that says when it was asked for new entries of each command.
pub(super) const ASKED: &str = "at_asked";

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

/// So many commands in the order of an epoch: every run of this seed has the same.
pub(super) fn order(n_items: usize, seed: u32, epoch: u32) -> Vec<u32> {
    let mut order: Vec<u32> = (0..n_items as u32).collect();
    let mut random = Pcg32::seed_from_u64(u64::from(seed) << 32 | u64::from(epoch));
    for last in (1..order.len() as u32).rev() {
        let other = random.random_range(0..=last);
        order.swap(last as usize, other as usize);
    }
    order
}
