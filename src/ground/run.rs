//! Which runs satisfy a task, by the definition over parts and positions: for a run s₀…sₙ all of its beginnings at once,
//! a bit for each last state. No residual is made and nothing is planned, so that learning can ask this often.

use super::outline::{Outline, Part, Valuation};

/// Which beginnings of a run satisfy a task: those that end with these states, from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Beginnings(Vec<u64>);

impl Beginnings {
    /// Of a run, by what holds in each of its states.
    pub fn of(outline: &Outline, run: &[Valuation]) -> Beginnings {
        let words = run.len().div_ceil(64);
        let holds = |at: usize, guard: usize| run[at] >> guard & 1 == 1;
        // What each part makes of the runs that begin at the state after the one at hand.
        let mut rest = vec![vec![0; words]; outline.parts().len()];
        for at in (0..run.len()).rev() {
            let mut from_here: Vec<Vec<u64>> = Vec::with_capacity(rest.len());
            for (place, part) in outline.parts().iter().enumerate() {
                let mut ends = match part {
                    Part::Done => vec![u64::MAX; words],
                    Part::Failed => vec![0; words],
                    Part::Always(guard) if holds(at, *guard) => {
                        let mut ends = rest[place].clone();
                        ends[at / 64] |= 1 << (at % 64);
                        ends
                    }
                    Part::Always(_) => vec![0; words],
                    Part::Until { hold, reach, then } => {
                        let reached = holds(at, *reach).then(|| &from_here[*then]);
                        let held = holds(at, *hold).then(|| &rest[place]);
                        join(words, 0, reached.into_iter().chain(held), |a, b| a | b)
                    }
                    Part::All(parts) => {
                        join(words, u64::MAX, parts.iter().map(|&part| &from_here[part]), |a, b| {
                            a & b
                        })
                    }
                    Part::Any(parts) => {
                        join(words, 0, parts.iter().map(|&part| &from_here[part]), |a, b| a | b)
                    }
                };
                forget_before(&mut ends, at);
                from_here.push(ends);
            }
            rest = from_here;
        }
        let mut whole = rest.pop().unwrap_or_default();
        // Bits beyond the last state say nothing.
        if let (Some(last), over @ 1..) = (whole.last_mut(), run.len() % 64) {
            *last &= (1 << over) - 1;
        }
        Beginnings(whole)
    }

    /// Whether the one that ends with a state does.
    pub fn holds(&self, last: usize) -> bool {
        self.0.get(last / 64).is_some_and(|word| word >> (last % 64) & 1 == 1)
    }

    /// The last state of the shortest.
    pub fn first(&self) -> Option<usize> {
        let (at, word) = self.0.iter().enumerate().find(|(_, word)| **word != 0)?;
        Some(at * 64 + word.trailing_zeros() as usize)
    }
}

fn join<'a>(
    words: usize,
    unit: u64,
    sets: impl Iterator<Item = &'a Vec<u64>>,
    with: fn(u64, u64) -> u64,
) -> Vec<u64> {
    let mut joined = vec![unit; words];
    for set in sets {
        joined.iter_mut().zip(set).for_each(|(word, &other)| *word = with(*word, other));
    }
    joined
}

/// A run that begins with a state does not end before it.
fn forget_before(ends: &mut [u64], at: usize) {
    ends[..at / 64].fill(0);
    if let Some(word) = ends.get_mut(at / 64) {
        *word &= u64::MAX << (at % 64);
    }
}
