//! What one participant is shown: a pure function of the study and of who they are, so that who comes again sees the
//! same. Items that check whether somebody looks are among them for everybody.

use super::file::{Order, Study};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

/// An item's turn.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Turn {
    /// The item's place in the study.
    pub item: usize,
    /// The places of what is shown of it.
    pub shows: Vec<usize>,
}

/// The turns of a participant.
pub fn plan(study: &Study, participant: &str) -> Vec<Turn> {
    plan_among(study, participant, |_| true)
}

/// The same, of items that are `wanted`; those that check whether somebody looks always are.
pub fn plan_among(study: &Study, participant: &str, wanted: impl Fn(usize) -> bool) -> Vec<Turn> {
    let mut random = Pcg32::seed_from_u64(mixed(study.seed, participant));
    let is_check = |at: &usize| !study.items[*at].must.is_empty();
    let mut items: Vec<usize> =
        (0..study.items.len()).filter(|at| !is_check(at) && wanted(*at)).collect();
    if let Some(asked) = study.asked.filter(|&asked| asked < items.len()) {
        items = drawn(items, asked, &mut random);
        items.sort_unstable();
    }
    items.extend(study.checks());
    match study.order {
        Order::Fixed => items.sort_unstable(),
        Order::Shuffled => items = drawn(items.clone(), items.len(), &mut random),
    }
    let turn = |item: usize| {
        let all = &study.items[item].shows;
        let mut shows = drawn((0..all.len()).collect(), study.shown, &mut random);
        // Pairs before runs, as in an answer.
        shows.sort_by_key(|&at| all[at].steps().is_some());
        Turn { item, shows }
    };
    items.into_iter().map(turn).collect()
}

/// So many of these, in an order by chance; drawn as u32, so that it is the same on every target.
fn drawn(mut from: Vec<usize>, n: usize, random: &mut Pcg32) -> Vec<usize> {
    let n = n.min(from.len());
    for at in 0..n {
        let left = u32::try_from(from.len() - at).unwrap_or(u32::MAX);
        let other = at + random.random_range(0..left) as usize;
        from.swap(at, other);
    }
    from.truncate(n);
    from
}

/// The seed of a participant.
fn mixed(seed: u32, participant: &str) -> u64 {
    let hash = blake3::hash(participant.as_bytes());
    let first = hash.as_bytes().iter().take(8);
    u64::from(seed) ^ first.fold(0, |all, &byte| all << 8 | u64::from(byte))
}
