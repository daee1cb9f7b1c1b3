//! Parting a corpus, for cross-validation and for holding some of it out: examples that share a key (a command, a task)
//! stay together, so that none of it is in both halves. A pure function of keys and seed.

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

impl Fold {
    /// The fold of `n` examples with this test half.
    fn with_test(n: u32, mut test: Vec<u32>) -> Fold {
        test.sort_unstable();
        let train = (0..n).filter(|row| test.binary_search(row).is_err()).collect();
        Fold { train, test }
    }
}

/// Parts examples, given by their keys, into `n` folds of about the same size. Keys come in an order that `seed`
/// shuffles, and each goes to the fold that has the fewest examples. Every example is in the test half of just one
/// fold and in the training half of all others. With fewer keys than folds some test halves are empty.
pub fn folds(keys: &[String], n: u32, seed: u32) -> Vec<Fold> {
    let mut tests = vec![Vec::new(); n as usize];
    for group in shuffled(keys, seed) {
        if let Some(fewest) = tests.iter_mut().min_by_key(|test| test.len()) {
            fewest.extend(group);
        }
    }
    tests.into_iter().map(|test| Fold::with_test(keys.len() as u32, test)).collect()
}

/// Holds some examples out: keys come in an order that `seed` shuffles, and each goes to the test half as long as that
/// has no more than `percent` of the examples with it. A key that is too large for it stays out, and smaller ones follow.
pub fn share(keys: &[String], percent: u32, seed: u32) -> Fold {
    let most = keys.len() as u64 * u64::from(percent.min(100)) / 100;
    let mut test = Vec::new();
    for group in shuffled(keys, seed) {
        if (test.len() + group.len()) as u64 <= most {
            test.extend(group);
        }
    }
    Fold::with_test(keys.len() as u32, test)
}

/// Leaves all examples of `n` keys out: keys come in an order that `seed` shuffles, and one without which a kind of
/// examples, of which there is one an example, would be gone from the training half stays.
pub fn leave(keys: &[String], kinds: &[String], n: usize, seed: u32) -> Fold {
    let mut left: IndexMap<&str, usize, FxBuildHasher> = IndexMap::default();
    for kind in kinds {
        *left.entry(kind).or_default() += 1;
    }
    let mut test = Vec::new();
    let mut n_out = 0;
    for group in shuffled(keys, seed) {
        if n_out == n {
            break;
        }
        let mut less = left.clone();
        for kind in group.iter().filter_map(|&row| kinds.get(row as usize)) {
            if let Some(left) = less.get_mut(kind.as_str()) {
                *left -= 1;
            }
        }
        if less.values().all(|&left| left > 0) {
            left = less;
            n_out += 1;
            test.extend(group);
        }
    }
    Fold::with_test(keys.len() as u32, test)
}

/// The examples of each key, keys in an order that `seed` shuffles.
fn shuffled(keys: &[String], seed: u32) -> Vec<Vec<u32>> {
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
    groups
}
