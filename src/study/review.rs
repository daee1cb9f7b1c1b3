//! Reviewing: answers with their flags beside them, what is decided of each and why, one by one or by a rule; what a rule
//! decides can be decided otherwise afterwards. Nothing is decided before a person says so.

use super::answer::Answer;
use super::file::Study;
use super::flags::{Flag, flags};
use super::judge::Verdict;
use super::merge::Merged;
use crate::corpus::{Cells, Decision, Example};
use std::collections::BTreeSet;

/// An answer under review.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The answer.
    pub answer: Answer,
    /// What seems careless about it.
    pub flags: BTreeSet<Flag>,
    /// What was decided of it.
    pub decision: Decision,
}

/// Answers under review.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Review {
    /// Each answer once, by sitting and turn.
    pub rows: Vec<Row>,
    /// What a model made of each, or nothing.
    verdicts: Vec<Verdict>,
}

impl Review {
    /// The answers of a study that were merged; answers to another study are none of them, and counted.
    pub fn new(study: &Study, merged: Merged) -> (Review, usize) {
        let own = study.fingerprint();
        let is_own = |answer: &Answer| answer.study.is_empty() || answer.study == own;
        let all = merged.answers.into_iter().zip(merged.decided);
        let (mine, others): (Vec<_>, Vec<_>) = all.partition(|(answer, _)| is_own(answer));
        let row = |(answer, decision)| Row { answer, flags: BTreeSet::new(), decision };
        let mut review = Review { rows: mine.into_iter().map(row).collect(), verdicts: Vec::new() };
        review.flag(study);
        (review, others.len())
    }

    /// The answers.
    pub fn answers(&self) -> Vec<Answer> {
        self.rows.iter().map(|row| row.answer.clone()).collect()
    }

    /// Takes in what a model made of each answer.
    pub fn judged(&mut self, study: &Study, verdicts: Vec<Verdict>) {
        self.verdicts = verdicts;
        self.flag(study);
    }

    /// What a model made of an answer, if one was asked.
    pub fn verdict(&self, row: usize) -> Option<&Verdict> {
        self.verdicts.get(row)
    }

    /// Whether a model was asked.
    pub fn is_judged(&self) -> bool {
        !self.verdicts.is_empty()
    }

    /// Decides something of an answer.
    pub fn decide(&mut self, row: usize, decision: Decision) {
        if let Some(row) = self.rows.get_mut(row) {
            row.decision = decision;
        }
    }

    /// Decides the same of all that is open: those with one of these flags are rejected, each with its flags as the
    /// reason, and all others approved. How many were rejected, and how many approved.
    pub fn decide_by(
        &mut self,
        wanted: &BTreeSet<Flag>,
        why: impl Fn(Flag) -> String,
    ) -> (usize, usize) {
        let (mut rejected, mut approved) = (0, 0);
        for row in self.rows.iter_mut().filter(|row| row.decision == Decision::Open) {
            let reasons: Vec<String> =
                row.flags.intersection(wanted).map(|&flag| why(flag)).collect();
            if reasons.is_empty() {
                row.decision = Decision::Approved;
                approved += 1;
            } else {
                row.decision = Decision::Rejected(reasons.join("; ").into());
                rejected += 1;
            }
        }
        (rejected, approved)
    }

    /// The answers as examples of a corpus, each with what was decided of it; `rest` fills cells that are kept.
    pub fn examples(&self, rest: impl Fn(&Row) -> Cells) -> Vec<Example> {
        let example = |row: &Row| Example {
            id: row.answer.id.clone(),
            line: 0,
            command: row.answer.command.clone(),
            task: row.answer.task.clone(),
            worker: Some(row.answer.worker.clone()).filter(|worker| !worker.is_empty()),
            decision: row.decision.clone(),
            pairs: row.answer.pairs.iter().map(super::file::Showing::pair).collect(),
            rest: rest(row),
            keys: Cells::default(),
        };
        self.rows.iter().map(example).collect()
    }

    fn flag(&mut self, study: &Study) {
        let found = flags(study, &self.answers(), &self.verdicts);
        for (row, flags) in self.rows.iter_mut().zip(found) {
            row.flags = flags;
        }
    }
}
