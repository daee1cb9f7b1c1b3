//! What is owed to whom: a line a participant, as a table.

use super::answer::{Answer, code};
use super::file::Study;
use super::review::Review;
use crate::corpus::{Decision, guarded};
use std::collections::BTreeMap;

/// What is owed to a participant.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Due {
    /// Who it is.
    pub worker: String,
    /// Answers, those approved, and those rejected.
    pub answers: [u32; 3],
    /// Their active time, in milliseconds.
    pub active_ms: u64,
    /// What is owed, in hundredths; nothing where the study says of no pay.
    pub cents: Option<u64>,
    /// The completion codes of their sittings: what they were shown when all was answered.
    pub codes: Vec<String>,
}

/// What is owed to everybody, by name; answers of rehearsals are nobody's.
pub fn dues(study: &Study, review: &Review) -> Vec<Due> {
    let mut all: BTreeMap<&str, Due> = BTreeMap::new();
    for row in review.rows.iter().filter(|row| row.answer.simulated.is_none()) {
        let worker = row.answer.worker.as_str();
        let due = all.entry(worker).or_insert_with(|| Due {
            worker: worker.to_owned(),
            cents: study.pay.as_ref().map(|_| 0),
            ..Due::default()
        });
        due.answers[0] += 1;
        due.answers[1] += u32::from(row.decision == Decision::Approved);
        due.answers[2] += u32::from(matches!(row.decision, Decision::Rejected(_)));
        due.active_ms += u64::from(row.answer.care.active_ms);
    }
    let paid = |mut due: Due| {
        let each = study.pay.as_ref().map(|pay| u64::from(pay.cents));
        due.cents = each.map(|cents| cents * u64::from(due.answers[1]));
        due.codes = codes(review, &due.worker);
        due
    };
    all.into_values().map(paid).collect()
}

/// The codes of a participant's sittings that were answered to the end.
fn codes(review: &Review, worker: &str) -> Vec<String> {
    let mut sittings: BTreeMap<&str, Vec<&Answer>> = BTreeMap::new();
    for row in review.rows.iter().filter(|row| row.answer.worker == worker) {
        sittings.entry(row.answer.sitting()).or_default().push(&row.answer);
    }
    let is_whole = |all: &&Vec<&Answer>| {
        all.iter().all(|one| one.turn[1] == all.len() && !one.study.is_empty())
    };
    sittings.values().filter(is_whole).map(|all| code(&all[0].study, all.iter().copied())).collect()
}

/// The pay sheet as a table.
pub fn sheet(study: &Study, review: &Review) -> String {
    let currency = study.pay.as_ref().map_or("", |pay| pay.currency.as_str());
    let mut out =
        String::from("worker,answers,approved,rejected,minutes,amount,currency,codes\r\n");
    for due in dues(study, review) {
        let Due { worker, answers: [all, approved, rejected], active_ms, cents, codes } = due;
        let amount =
            cents.map_or(String::new(), |cents| format!("{}.{:02}", cents / 100, cents % 100));
        let worker = guarded(&worker).replace('"', "\"\"");
        let currency = guarded(currency).replace('"', "\"\"");
        let minutes = active_ms as f64 / 60_000.0;
        out += &format!(
            "\"{worker}\",{all},{approved},{rejected},{minutes:.1},{amount},\"{currency}\",{}\r\n",
            codes.join(" ")
        );
    }
    out
}
