//! Which rows a person should look at before anything is learned from them. Each rule is a pure function of the rows
//! (and of what a model makes of them) that says why.

use super::row::Outcome;
use crate::ccg::words;
use crate::corpus::Example;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};
use serde::{Deserialize, Serialize};
use std::hash::{BuildHasher, BuildHasherDefault};

/// A reason to look at a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rule {
    /// No reading that the model gives does what was shown, or there is no reading.
    Invalid,
    /// It has hardly a word in common with the others of its task.
    Strange,
    /// The same person said the same of the same demonstrations before.
    Duplicate,
    /// It has too few words.
    Short,
}

/// How strict the rules are.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rules {
    /// Commands with fewer words are too short.
    pub least_words: u32,
    /// A command is strange when its words are so much rarer in its task than those of the task's middle command:
    /// a share of it, in percent.
    pub strange_percent: u32,
    /// Tasks with fewer commands have none that is strange.
    pub least_commands: u32,
}

impl Default for Rules {
    fn default() -> Self {
        Rules { least_words: 2, strange_percent: 40, least_commands: 8 }
    }
}

/// Marks of rows: the row, the rule and why, in the order of rules and rows.
pub type Marks = Vec<(u32, Rule, String)>;

/// Commands of fewer words.
pub fn short(examples: &[Example], rules: Rules) -> Marks {
    let mark = |(row, example): (u32, &Example)| {
        let n = words(&example.command).len();
        let is_short = n < rules.least_words as usize;
        is_short.then(|| (row, Rule::Short, format!("{n} of at least {} words", rules.least_words)))
    };
    (0..).zip(examples).filter_map(mark).collect()
}

/// Rows that say what the same person said before, of the same demonstrations.
pub fn duplicate(examples: &[Example]) -> Marks {
    let hasher = BuildHasherDefault::<rustc_hash::FxHasher>::default();
    let mut seen: FxHashMap<u64, Vec<u32>> = FxHashMap::default();
    let mut marks = Vec::new();
    for (row, example) in (0..).zip(examples) {
        let said = words(&example.command);
        let before =
            seen.entry(hasher.hash_one((&said, &example.worker, &example.pairs))).or_default();
        let is_same = |other: &Example| {
            other.worker == example.worker
                && other.pairs == example.pairs
                && words(&other.command) == said
        };
        let first =
            before.iter().filter_map(|&row| examples.get(row as usize)).find(|o| is_same(o));
        match first {
            Some(first) => {
                let why = format!("the same as {} (line {})", first.id, first.line);
                marks.push((row, Rule::Duplicate, why));
            }
            None => before.push(row),
        }
    }
    marks
}

/// Rows whose words are rare among the other commands of their task.
pub fn strange(examples: &[Example], rules: Rules) -> Marks {
    let mut tasks: IndexMap<&str, Vec<u32>, FxBuildHasher> = IndexMap::default();
    for (row, example) in (0..).zip(examples) {
        if let Some(task) = &example.task {
            tasks.entry(task).or_default().push(row);
        }
    }
    let mut marks = Vec::new();
    for (task, rows) in &tasks {
        if rows.len() < (rules.least_commands as usize).max(2) {
            continue;
        }
        let said: Vec<FxHashSet<String>> = rows
            .iter()
            .filter_map(|&row| examples.get(row as usize))
            .map(|example| words(&example.command).into_iter().collect())
            .collect();
        let mut counts: FxHashMap<&str, u32> = FxHashMap::default();
        for word in said.iter().flatten() {
            *counts.entry(word).or_default() += 1;
        }
        // How many of the others have one of its words, on average over its words, in thousandths.
        let others = rows.len() as u32 - 1;
        let shared = |own: &FxHashSet<String>| {
            let among: u32 =
                own.iter().map(|word| counts.get(word.as_str()).map_or(0, |n| n - 1)).sum();
            u64::from(among) * 1_000 / u64::from(others * own.len().max(1) as u32)
        };
        let shares: Vec<u64> = said.iter().map(shared).collect();
        let mut sorted = shares.clone();
        sorted.sort_unstable();
        let middle = sorted.get(sorted.len() / 2).copied().unwrap_or_default();
        for (&row, &share) in rows.iter().zip(&shares) {
            if share * 100 < middle * u64::from(rules.strange_percent) {
                let why = format!(
                    "its words stand in {} % of the other commands of {task}, those of a usual one in {} %",
                    share / 10,
                    middle / 10
                );
                marks.push((row, Rule::Strange, why));
            }
        }
    }
    marks.sort_by_key(|&(row, ..)| row);
    marks
}

/// Rows of which a model makes nothing that was shown.
pub fn invalid(outcomes: &[Option<Outcome>]) -> Marks {
    let mark = |(row, outcome): (u32, &Option<Outcome>)| {
        let why = match outcome {
            Some(Outcome::Invalid) => "no reading does what was shown",
            Some(Outcome::Unread) => "there is no reading",
            _ => return None,
        };
        Some((row, Rule::Invalid, why.to_owned()))
    };
    (0..).zip(outcomes).filter_map(mark).collect()
}
