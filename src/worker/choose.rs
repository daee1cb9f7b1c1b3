//! Whether to ask before a command is done, and which of its readings to ask about: where several are equally likely,
//! where the best is doubtful, and where it speaks of things that the world does not have and another does not.

use super::protocol::{Claim, Reading, Refers};
use crate::ccg::{Parse, Reason};

/// Readings that are asked about at once.
const MOST_CHOICES: usize = 3;

/// A reading that scores so much less than the best is no rival of it.
const FAR: f64 = 6.0;

/// The readings to choose from, as places, those that refer first and then by their scores; none where the best is
/// to be done without asking.
pub(super) fn choices(parse: &Parse, readings: &[Reading], is_doubtful: bool) -> Vec<usize> {
    let Some(best) = readings.first() else { return Vec::new() };
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
        None if is_doubtful => (0..rivals).collect(),
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
    let mut told: Vec<&Claim> = Vec::new();
    all.retain(|&at| {
        let claim = readings.get(at).map(|one| &one.claim).filter(|claim| !told.contains(claim));
        told.extend(claim);
        claim.is_some()
    });
    // The likeliest is always among them.
    let place = all.iter().position(|&at| at == 0).filter(|&place| place >= MOST_CHOICES);
    if let Some(place) = place {
        all.swap(place, MOST_CHOICES - 1);
    }
    all.truncate(MOST_CHOICES);
    all
}

/// Whether every phrase of a reading stands for one thing of the world.
fn refers(reading: &Reading) -> bool {
    reading.phrases.iter().all(|phrase| phrase.refers == Refers::One)
}

/// Whether a reading asks for nothing but that something is not so.
const fn denies(reading: &Reading) -> bool {
    matches!(reading.claim, Claim::Not(_))
}
