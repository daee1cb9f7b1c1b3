//! A participant that is simulated: what they say is what people said of the same items once, accepted or rejected. How
//! long they look and how they type is alike for both, so that a flag on it can only be right by chance. A pure function
//! of study and seed.

use super::file::{Rehearsed, Study};
use super::plan::{Turn, plan_among};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

/// Participants of a hundred that are careless.
const CARELESS: u32 = 8;

/// What a simulated participant does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Script {
    /// Their name.
    pub worker: String,
    /// Whether they are careless.
    pub careless: bool,
    /// What they are asked.
    pub turns: Vec<Turn>,
    /// What they do, by turn.
    pub acts: Vec<Act>,
}

/// What they do in a turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Act {
    /// The words.
    pub words: String,
    /// Milliseconds that they look.
    pub looks_ms: u32,
}

/// The participant of a seed.
pub fn script(study: &Study, seed: u32) -> Script {
    let mut random = Pcg32::seed_from_u64(u64::from(seed) ^ 0x5117);
    let careless = random.random_range(0..100u32) < CARELESS;
    let worker = format!("simulated-{seed}");
    let fits = |said: &&Rehearsed| said.careless == careless;
    let has = |item: usize| study.items[item].rehearsed.iter().any(|said| fits(&said));
    let any = (0..study.items.len()).any(has);
    let turns = plan_among(study, &worker, |item| !any || has(item));
    let act = |turn: &Turn| {
        let item = &study.items[turn.item];
        let said: Vec<&Rehearsed> = item.rehearsed.iter().filter(fits).collect();
        let chosen = random.random_range(0..u32::try_from(said.len().max(1)).unwrap_or(1));
        let words = match said.get(chosen as usize) {
            Some(said) => said.words.clone(),
            None => without_words(study, turn),
        };
        Act { words, looks_ms: random.random_range(4_000..20_000u32) }
    };
    let acts = turns.iter().map(act).collect();
    Script { worker, careless, turns, acts }
}

/// What to say of an item that nobody has said anything of: the words that it must have, or its label's.
fn without_words(study: &Study, turn: &Turn) -> String {
    let item = &study.items[turn.item];
    let must: Vec<&str> =
        item.must.iter().filter_map(|any| any.first()).map(String::as_str).collect();
    match must.is_empty() {
        true => item.task.as_ref().unwrap_or(&item.id).replace(['-', '_'], " "),
        false => must.join(" "),
    }
}
