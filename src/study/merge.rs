//! Answers from many files as one list, in any order and however they came (`gather`). Invariant: the same answers give the
//! same list, in whichever order and how often their files come.

use super::answer::Decided;
use super::gather::Gathering;
use crate::corpus::{Decision, Flaw};
use std::cmp::Ordering;

/// Answers that were merged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Merged {
    /// Each once, by sitting and turn, with what its file says was decided of it.
    pub answers: Vec<Decided>,
    /// How often one came again.
    pub doubles: usize,
    /// What is wrong with files, each with its file's name.
    pub flaws: Vec<(String, Flaw)>,
    /// How many rows or objects of files are no answer for that.
    pub left_out: usize,
}

/// Merges files, each a name and a text.
pub fn merge<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Merged {
    let mut merged = Merged::default();
    for (name, text) in files {
        let mut gathering = Gathering::new(text);
        while gathering.step() {}
        let Gathering { answers, flaws, left_out, .. } = gathering;
        merged.left_out += left_out;
        merged.flaws.extend(flaws.into_iter().map(|flaw| (name.to_owned(), flaw)));
        merged.answers.extend(answers);
    }
    merged.doubles = unite(&mut merged.answers);
    merged
}

/// Leaves each answer once, by sitting and turn; how many came again. Of two of one name the one with most said of it stays,
/// and then the first by its letters.
pub fn unite(answers: &mut Vec<Decided>) -> usize {
    let is_open = |decision: &Decision| *decision == Decision::Open;
    let order = |(a, one): &Decided, (b, other): &Decided| -> Ordering {
        let keys = (a.sitting(), a.turn, &a.id).cmp(&(b.sitting(), b.turn, &b.id));
        keys.then(is_open(one).cmp(&is_open(other))).then_with(|| a.line().cmp(&b.line()))
    };
    answers.sort_by(order);
    let all = answers.len();
    answers.dedup_by(|later, earlier| later.0.id == earlier.0.id);
    all - answers.len()
}
