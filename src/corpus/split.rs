//! Folds for cross-validation: examples that share a key (a command, a task) stay together, so that none of it
//! is in both halves. A pure function of keys and seed.

use indexmap::IndexMap;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use rustc_hash::FxBuildHasher;

/// One way to part a corpus, as indices into it in ascending order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Fold {
    /// What is learned from.
    pub train: Vec<u32>,
    /// What is judged on.
    pub test: Vec<u32>,
}

/// Parts examples, given by their keys, into `n` folds of about the same size. Keys come in an order that `seed`
/// shuffles, and each goes to the fold that has the fewest examples. Every example is in the test half of just one
/// fold and in the training half of all others. With fewer keys than folds some test halves are empty.
pub fn folds(keys: &[String], n: u32, seed: u32) -> Vec<Fold> {
    let mut groups: IndexMap<&str, Vec<u32>, FxBuildHasher> = IndexMap::default();
    for (row, key) in (0..).zip(keys) {
        groups.entry(key).or_default().push(row);
    }
    let mut groups: Vec<Vec<u32>> = groups.into_values().collect();
    let mut random = Pcg32::seed_from_u64(u64::from(seed));
    for last in (1..groups.len() as u32).rev() {
        let other = random.random_range(0..=last);
        groups.swap(last as usize, other as usize);
    }
    let mut folds = vec![Fold::default(); n as usize];
    for group in groups {
        if let Some(fewest) = folds.iter_mut().min_by_key(|fold| fold.test.len()) {
            fewest.test.extend(group);
        }
    }
    for fold in &mut folds {
        fold.test.sort_unstable();
        let is_train = |row: &u32| fold.test.binary_search(row).is_err();
        fold.train = (0..keys.len() as u32).filter(is_train).collect();
    }
    folds
}
