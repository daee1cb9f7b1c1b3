//! What seems careless about answers. A flag is pointed out to whoever reviews and decides nothing by itself. Pure: of the
//! study, the answers, and what a model made of them, if one was asked.

use super::answer::{Answer, plain};
use super::file::Study;
use super::judge::Verdict;
use super::tongue::is_foreign;
use crate::corpus::admit::command;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// What seems careless about an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Flag {
    /// A showing was hardly in sight.
    Unseen,
    /// It took less time than the study thinks is needed.
    Fast,
    /// Most of it was pasted.
    Pasted,
    /// It is the example's command.
    Copied,
    /// The same words stand for every item of the sitting.
    Same,
    /// It seems to be in another language.
    Foreign,
    /// An item that is there to see whether somebody looks was missed in the sitting.
    Missed,
    /// By the model it holds on some of the pairs alone.
    SomePairs,
    /// By the model it holds on none of the pairs.
    NoPair,
    /// The model cannot read it.
    Unread,
    /// Another participant gave the same words for every item.
    Twin,
    /// The same participant took part more than once.
    Again,
    /// It is of a rehearsal.
    Simulated,
    /// It is too long for a corpus, or has no word.
    Unfit,
}

impl Flag {
    /// All of them.
    pub const ALL: [Flag; 14] = [
        Flag::Unseen,
        Flag::Fast,
        Flag::Pasted,
        Flag::Copied,
        Flag::Same,
        Flag::Foreign,
        Flag::Missed,
        Flag::SomePairs,
        Flag::NoPair,
        Flag::Unread,
        Flag::Twin,
        Flag::Again,
        Flag::Simulated,
        Flag::Unfit,
    ];

    /// Its name in files and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Flag::Unseen => "unseen",
            Flag::Fast => "fast",
            Flag::Pasted => "pasted",
            Flag::Copied => "copied",
            Flag::Same => "same",
            Flag::Foreign => "foreign",
            Flag::Missed => "missed",
            Flag::SomePairs => "some_pairs",
            Flag::NoPair => "no_pair",
            Flag::Unread => "unread",
            Flag::Twin => "twin",
            Flag::Again => "again",
            Flag::Simulated => "simulated",
            Flag::Unfit => "unfit",
        }
    }

    /// The one of this name.
    pub fn of(name: &str) -> Option<Flag> {
        Flag::ALL.into_iter().find(|flag| flag.name() == name)
    }
}

/// The flags of each answer. `verdicts` is what a model made of each, or empty.
pub fn flags(study: &Study, answers: &[&Answer], verdicts: &[Verdict]) -> Vec<BTreeSet<Flag>> {
    let mut sittings: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    let mut workers: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (at, answer) in answers.iter().enumerate() {
        sittings.entry(answer.sitting()).or_default().push(at);
        if !answer.worker.is_empty() && !answer.study.is_empty() {
            workers.entry(&answer.worker).or_default().insert(answer.sitting());
        }
    }
    let mut all: Vec<BTreeSet<Flag>> = vec![BTreeSet::new(); answers.len()];
    for (at, answer) in answers.iter().enumerate() {
        all[at] = own(study, answer);
        all[at].extend(verdicts.get(at).and_then(told));
        if workers.get(answer.worker.as_str()).is_some_and(|sittings| sittings.len() > 1) {
            all[at].insert(Flag::Again);
        }
    }
    let words = |rows: &[usize]| -> Vec<(String, String)> {
        rows.iter().map(|&at| (answers[at].item.clone(), answers[at].plain())).collect()
    };
    let mut said: BTreeMap<Vec<(String, String)>, Vec<&str>> = BTreeMap::new();
    for (sitting, rows) in sittings.iter().filter(|(_, rows)| rows.len() > 1) {
        let distinct: BTreeSet<String> = rows.iter().map(|&at| answers[at].plain()).collect();
        if distinct.len() == 1 {
            rows.iter().for_each(|&at| all[at].extend([Flag::Same]));
        }
        let mut words = words(rows);
        words.sort();
        said.entry(words).or_default().push(sitting);
    }
    for rows in said.values().filter(|s| s.len() > 1).flatten().map(|sitting| &sittings[sitting]) {
        rows.iter().for_each(|&at| all[at].extend([Flag::Twin]));
    }
    for rows in sittings.values() {
        if rows.iter().any(|&at| is_missed(study, answers[at])) {
            rows.iter().for_each(|&at| all[at].extend([Flag::Missed]));
        }
    }
    all
}

/// What an answer tells by itself.
fn own(study: &Study, answer: &Answer) -> BTreeSet<Flag> {
    let (care, limits) = (&answer.care, &study.care);
    let length = answer.command.chars().count() as u32;
    let example = study.words.example.as_ref().map(|example| plain(&example.command));
    // Of what another program collected nothing is known of how it was done.
    let is_watched = !answer.study.is_empty();
    let unseen = care.seen_ms.len() < answer.shown().count()
        || care.seen_ms.iter().any(|&ms| ms < limits.look_ms);
    let flagged = [
        (Flag::Unseen, is_watched && unseen),
        (Flag::Fast, is_watched && care.active_ms < limits.least_ms),
        (Flag::Pasted, care.pasted > 0 && care.pasted * 2 > length),
        (Flag::Copied, example.is_some_and(|example| example == answer.plain())),
        (Flag::Foreign, is_foreign(&study.language, &answer.command)),
        (Flag::Simulated, answer.simulated.is_some()),
        (Flag::Unfit, command(Some(&answer.command)).is_err()),
    ];
    flagged.into_iter().filter(|(_, is)| *is).map(|(flag, _)| flag).collect()
}

fn told(verdict: &Verdict) -> Option<Flag> {
    match verdict {
        Verdict::All => None,
        Verdict::Some(_) => Some(Flag::SomePairs),
        Verdict::None => Some(Flag::NoPair),
        Verdict::Unread => Some(Flag::Unread),
    }
}

/// Whether an item that is there to see whether somebody looks was answered without looking.
fn is_missed(study: &Study, answer: &Answer) -> bool {
    let Some(item) = study.items.iter().find(|item| item.id == answer.item) else { return false };
    let said = format!(" {} ", answer.plain());
    let has =
        |words: &Vec<String>| words.iter().any(|word| said.contains(&format!(" {} ", plain(word))));
    !item.must.iter().all(has)
}
