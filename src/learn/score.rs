//! What is counted when a model is judged (Williams et al., Section VI): precision, recall and F1, once without
//! and once with the parse that skips words. All figures derive from one mark a command.

use serde::{Deserialize, Serialize};

/// What came of a command.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// No answer: no parse, or several forms tied for best.
    #[default]
    Silent,
    /// One best form, but not what was shown.
    Wrong,
    /// One best form, false before and true after every demonstration.
    Right,
}

/// How one command was answered.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mark {
    /// The label of its task.
    pub task: Option<String>,
    /// What came of it when tied forms abstain.
    pub answer: Verdict,
    /// What came of it when tied forms abstain only where no single one refers in all states before.
    pub resolved: Verdict,
    /// Whether words were skipped.
    pub skipped: bool,
    /// The probability that the answer says it is right with.
    pub probability: Option<f64>,
    /// Whether a page would ask before doing it.
    pub asked: bool,
}

/// Who answers when several forms are tied for best.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ties {
    /// Nobody: the paper's scoring.
    Abstain,
    /// The one form all of whose phrases refer in the states before, if there is one such.
    Refer,
}

/// How often a model answered and was right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// Commands that got an answer.
    pub answered: usize,
    /// Answers that hold on all demonstrations.
    pub correct: usize,
}

impl Score {
    /// correct / answered; 0 when nothing was answered.
    pub fn precision(self) -> f64 {
        ratio(self.correct, self.answered)
    }

    /// correct / `total`; 0 when there is nothing.
    pub fn recall(self, total: usize) -> f64 {
        ratio(self.correct, total)
    }

    /// The harmonic mean of precision and recall.
    pub fn f1(self, total: usize) -> f64 {
        let (p, r) = (self.precision(), self.recall(total));
        if p + r == 0.0 { 0.0 } else { 2.0 * p * r / (p + r) }
    }

    /// Precision, recall and F1 of so many commands.
    pub fn figures(self, total: usize) -> [f64; 3] {
        [self.precision(), self.recall(total), self.f1(total)]
    }

    fn count(&mut self, verdict: Verdict) {
        self.answered += usize::from(verdict != Verdict::Silent);
        self.correct += usize::from(verdict == Verdict::Right);
    }
}

/// What an evaluation has found so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scores {
    /// Commands seen.
    pub total: usize,
    /// Without skipping words.
    pub plain: Score,
    /// With the skipping parse counted.
    pub skipping: Score,
}

impl Scores {
    /// The scores of marks.
    pub fn of<'a>(marks: impl IntoIterator<Item = &'a Mark>, ties: Ties) -> Self {
        let mut scores = Scores::default();
        marks.into_iter().for_each(|mark| scores.count(mark, ties));
        scores
    }

    /// Takes in one more mark.
    pub fn count(&mut self, mark: &Mark, ties: Ties) {
        let verdict = if ties == Ties::Abstain { mark.answer } else { mark.resolved };
        self.total += 1;
        self.plain.count(if mark.skipped { Verdict::Silent } else { verdict });
        self.skipping.count(verdict);
    }

    /// Precision, recall and F1 without skipping, then the same three with.
    pub fn figures(self) -> [f64; 6] {
        let [a, b, c] = self.plain.figures(self.total);
        let [d, e, f] = self.skipping.figures(self.total);
        [a, b, c, d, e, f]
    }
}

fn ratio(part: usize, whole: usize) -> f64 {
    if whole == 0 { 0.0 } else { part as f64 / whole as f64 }
}
