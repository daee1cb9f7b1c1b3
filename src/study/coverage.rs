//! How far a study has come, told without a server: answers by task, how alike they are, and the study that asks for
//! what is still missing.

use super::file::Study;
use super::flags::Flag;
use super::review::Review;
use crate::corpus::Decision;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A task's answers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Coverage {
    /// Its label, or the item's name where it has none.
    pub task: String,
    /// Its items in the study.
    pub items: usize,
    /// Answers.
    pub answers: usize,
    /// Those that were approved.
    pub approved: usize,
    /// Those that were rejected.
    pub rejected: usize,
    /// Answers that a model reads as holding on all pairs, where one was asked.
    pub valid: usize,
    /// How alike the words of answers that were not rejected are: the mean share of words that two of them have in
    /// common (Dice's coefficient). 1 when there are fewer than two.
    pub agreement: f64,
}

/// Every task of a study, in its order.
pub fn coverage(study: &Study, review: &Review) -> Vec<Coverage> {
    let mut all: Vec<Coverage> = Vec::new();
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    let mut words: Vec<Vec<Vec<String>>> = Vec::new();
    let mut place = |task: String, all: &mut Vec<Coverage>, words: &mut Vec<Vec<Vec<String>>>| {
        *places.entry(task.clone()).or_insert_with(|| {
            all.push(Coverage { task, agreement: 1.0, ..Coverage::default() });
            words.push(Vec::new());
            all.len() - 1
        })
    };
    for item in study.items.iter().filter(|item| item.must.is_empty()) {
        let at = place(item.task.clone().unwrap_or_else(|| item.id.clone()), &mut all, &mut words);
        all[at].items += 1;
    }
    let unsure = [Flag::SomePairs, Flag::NoPair, Flag::Unread];
    for row in &review.rows {
        let task = row.answer.task.clone().unwrap_or_else(|| row.answer.item.clone());
        let is_check = study.checks().any(|at| study.items[at].id == row.answer.item);
        if is_check {
            continue;
        }
        let at = place(task, &mut all, &mut words);
        let found = &mut all[at];
        found.answers += 1;
        found.approved += usize::from(row.decision == Decision::Approved);
        found.valid +=
            usize::from(review.is_judged() && !unsure.iter().any(|f| row.flags.contains(f)));
        if let Decision::Rejected(_) = row.decision {
            found.rejected += 1;
        } else {
            words[at].push(row.answer.plain().split(' ').map(str::to_owned).collect());
        }
    }
    for (found, said) in all.iter_mut().zip(&words) {
        found.agreement = agreement(said);
    }
    all
}

/// The mean of Dice's coefficient over all pairs of answers; of many answers, each with the next fifty.
fn agreement(said: &[Vec<String>]) -> f64 {
    let (mut sum, mut n) = (0.0, 0u32);
    for (at, one) in said.iter().enumerate() {
        for other in said.iter().skip(at + 1).take(50) {
            let common = one.iter().filter(|word| other.contains(word)).count();
            let all = (one.len() + other.len()).max(1);
            sum += (2 * common) as f64 / all as f64;
            n += 1;
        }
    }
    if n == 0 { 1.0 } else { (sum / f64::from(n)).min(1.0) }
}

/// The study that asks again of what has fewer answers than wanted (those that were not rejected); nothing when there is
/// enough of everything.
pub fn top_up(study: &Study, review: &Review, wanted: usize) -> Option<Study> {
    let lacks: Vec<String> = coverage(study, review)
        .into_iter()
        .filter(|found| found.answers - found.rejected < wanted)
        .map(|found| found.task)
        .collect();
    let items = study.items.iter().filter(|item| {
        !item.must.is_empty() || lacks.contains(item.task.as_ref().unwrap_or(&item.id))
    });
    let items: Vec<_> = items.cloned().collect();
    let name = format!("{}, top-up", study.name);
    let asked = study.asked.map(|asked| asked.min(items.len()));
    (!lacks.is_empty()).then(|| Study { items, name, asked, ..study.clone() })
}
