//! Reviewing: answers with their flags beside them, what is decided of each and why, one by one or by a rule; what a rule
//! decides can be decided otherwise afterwards. Nothing is decided before a person says so.

use super::answer::{Answer, Decided};
use super::file::Study;
use super::flags::{Flag, flags};
use super::judge::Verdict;
use super::showing::Showing;
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

impl Row {
    /// The answer as an example of a corpus, with what was decided of it; `rest` fills cells that are kept.
    pub fn example(&self, rest: Cells) -> Example {
        let Answer { id, command, task, worker, .. } = &self.answer;
        Example {
            id: id.clone(),
            line: 0,
            command: command.clone(),
            task: task.clone(),
            worker: Some(worker.clone()).filter(|worker| !worker.is_empty()),
            decision: self.decision.clone(),
            pairs: self.answer.shown().map(Showing::pair).cloned().collect(),
            rest,
            keys: Cells::default(),
        }
    }
}

impl Review {
    /// The answers to a study among those that were merged; and those to another one, which are none of them.
    pub fn new(study: &Study, answers: Vec<Decided>) -> (Review, Vec<Decided>) {
        let own = study.fingerprint();
        let is_own = |answer: &Answer| answer.study.is_empty() || answer.study == own;
        let (mine, others): (Vec<_>, Vec<_>) =
            answers.into_iter().partition(|(answer, _)| is_own(answer));
        let row = |(answer, decision)| Row { answer, flags: BTreeSet::new(), decision };
        let mut review = Review { rows: mine.into_iter().map(row).collect(), verdicts: Vec::new() };
        review.flag(study);
        (review, others)
    }

    /// The answers, with what was decided of each.
    pub fn into_answers(self) -> impl Iterator<Item = Decided> {
        self.rows.into_iter().map(|row| (row.answer, row.decision))
    }

    /// The answers.
    pub fn answers(&self) -> impl Iterator<Item = &Answer> {
        self.rows.iter().map(|row| &row.answer)
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

    fn flag(&mut self, study: &Study) {
        let found = flags(study, &self.answers().collect::<Vec<&Answer>>(), &self.verdicts);
        for (row, flags) in self.rows.iter_mut().zip(found) {
            row.flags = flags;
        }
    }
}
