//! Whether to ask before a command is done, and which of its readings to ask about: where several are equally likely,
//! where the best is doubtful, and where it speaks of things that the world does not have and another does not. What
//! would come to the same in this world is one; and where one alone can be meant here, and every word was used, the
//! world knows better than the sentence: nothing is asked, unless the probability is low indeed, or what is forbidden is
//! forbidden once all is done.

use super::protocol::{Claim, Fate, Reading, Refers, Taken, Word, lost};
use crate::ccg::{Parse, Reason};

/// Readings that are asked about at once.
const MOST_CHOICES: usize = 3;

/// A reading that scores so much less than the best is no rival of it.
const FAR: f64 = 6.0;

/// Below this probability the page asks even where one reading alone can be meant.
const LOW: f64 = 0.5;

/// The readings to choose from, as places, those that refer first and then by their scores; none where the best is
/// to be done without asking.
pub(super) fn choices(
    parse: &Parse,
    readings: &[Reading],
    words: &[Word],
    taken: &[Taken],
    doubt: Option<(f64, bool)>,
    forbids_idly: bool,
) -> Vec<usize> {
    let Some(best) = readings.first() else { return Vec::new() };
    // Without what lies beyond the language a command says something else.
    let is_beyond = words.iter().any(|word| lost(word).is_some());
    let is_doubtful = is_beyond || forbids_idly || doubt.is_some_and(|(_, asks)| asks);
    let rivals = readings.iter().take_while(|one| best.score - one.score <= FAR).count();
    let fits = |at: &usize| readings.get(*at).is_some_and(refers);
    // One of several may be there where another is not.
    let can_be_done = matches!(best.claim, Claim::Any(_));
    let mut all: Vec<usize> = match parse.reason {
        Some(Reason::Tie) => (0..parse.tied()).collect(),
        Some(_) => return Vec::new(),
        // What cannot be done is told as such, however it was meant.
        None if is_doubtful && !can_be_done && !(0..rivals).any(|at| fits(&at)) => {
            return Vec::new();
        }
        None if is_doubtful => {
            let is_low = doubt.is_some_and(|(probability, _)| probability < LOW);
            let others = readings.get(1..rivals).unwrap_or_default();
            let alone = !others.iter().any(|one| refers(one) && !is_same(one, best));
            if alone
                && refers(best)
                && !is_low
                && !forbids_idly
                && taken.is_empty()
                && !is_beyond
                && words.iter().all(is_used)
            {
                return Vec::new();
            }
            (0..rivals).collect()
        }
        None if refers(best) => return Vec::new(),
        None => {
            let other = |at: &usize| fits(at) && readings.get(*at).is_some_and(|one| !denies(one));
            let Some(other) = (1..rivals).find(other) else { return Vec::new() };
            vec![other, 0]
        }
    };
    let (first, last): (Vec<usize>, Vec<usize>) = all.into_iter().partition(fits);
    all = first;
    all.extend(last);
    let mut told: Vec<&Reading> = Vec::new();
    all.retain(|&at| {
        let Some(reading) = readings.get(at) else { return false };
        let is_new = !told.iter().any(|other| is_same(reading, other));
        told.extend(is_new.then_some(reading));
        is_new
    });
    // The likeliest is always among them.
    let place = all.iter().position(|&at| at == 0).filter(|&place| place >= MOST_CHOICES);
    if let Some(place) = place {
        all.swap(place, MOST_CHOICES - 1);
    }
    all.truncate(MOST_CHOICES);
    all
}

/// Whether two readings say the same, or come to the same in this world: they are about the same things, and hold in the
/// same cells.
fn is_same(one: &Reading, other: &Reading) -> bool {
    let holds = !one.cells.is_empty() && one.cells == other.cells;
    one.claim == other.claim
        || holds && refers(one) && refers(other) && is_about(one, other) && is_about(other, one)
}

/// Whether all things that a reading is about are where one is that the other is about.
fn is_about(one: &Reading, other: &Reading) -> bool {
    cells(one).all(|cell| cells(other).any(|other| cell == other))
}

/// Where the things are that a reading is about.
fn cells(reading: &Reading) -> impl Iterator<Item = &[(i32, i32)]> {
    let referents = reading.phrases.iter().flat_map(|phrase| &phrase.referents);
    referents.map(|referent| &*referent.cells)
}

/// Whether a word was used, or means nothing by itself: not left out, and no word that turns round, joins or orders
/// without its meaning.
fn is_used(word: &Word) -> bool {
    match word.fate {
        Fate::Meant => true,
        Fate::Empty => word.closed.is_none(),
        Fate::Skipped | Fate::Unknown | Fate::Idle => false,
    }
}

/// Whether every phrase of a reading stands for one thing of the world.
fn refers(reading: &Reading) -> bool {
    reading.phrases.iter().all(|phrase| phrase.refers == Refers::One)
}

/// Whether a reading asks for nothing but that something is not so.
const fn denies(reading: &Reading) -> bool {
    matches!(reading.claim, Claim::Not(_))
}
