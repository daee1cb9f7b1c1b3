//! The sheet itself: rows and what became of them. Lookups are answered from plain arrays, and a view is looked for once
//! as long as nothing changes, so that a hundred thousand rows are scrolled at once.

use super::care::{Marks, Rules, duplicate, invalid, short, strange};
use super::change::{Before, Deed, Done, History, Verdict};
use super::row::{Half, Line, Outcome, Rule, Source, Status};
use super::view::{Facet, Facets, MOST_LINES, MOST_VALUES, Sort, View, Window};
use crate::corpus::{Decision, Example};
use indexmap::{IndexMap, IndexSet};
use rustc_hash::FxBuildHasher;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use std::hash::Hash;
use std::sync::Arc;

/// A corpus that is worked on.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    examples: Arc<[Example]>,
    sources: Vec<Source>,
    decisions: Vec<Decision>,
    halves: Vec<Half>,
    outcomes: Vec<Option<Outcome>>,
    /// For each row the place of its best form.
    best: Vec<Option<u32>>,
    forms: IndexSet<String, FxBuildHasher>,
    marks: IndexMap<(u32, Rule), String, FxBuildHasher>,
    /// Whether rejected rows are used all the same.
    with_rejected: bool,
    history: History,
    /// Grows with every change.
    revision: u32,
    seen: Option<(View, u32, Vec<u32>)>,
}

/// How a sheet stands.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Care {
    /// Grows with every change of decisions, halves, outcomes and marks: what was looked at before may be old.
    pub revision: u32,
    /// Rows in all.
    pub rows: u32,
    /// Those that are learned from.
    pub train: u32,
    /// Those that a model is judged on.
    pub held_out: u32,
    /// Those that are rejected.
    pub rejected: u32,
    /// What was done or undone just now.
    pub done: Option<Done>,
    /// What can be undone.
    pub undo: Option<Done>,
    /// What can be done again.
    pub redo: Option<Done>,
}

impl Sheet {
    /// The sheet of some files' good rows, rejected ones among them.
    pub fn new(sources: Vec<Source>, examples: Vec<Example>, with_rejected: bool) -> Sheet {
        let n = examples.len();
        Sheet {
            decisions: examples.iter().map(|example| example.decision.clone()).collect(),
            examples: examples.into(),
            sources,
            halves: vec![Half::Train; n],
            outcomes: vec![None; n],
            best: vec![None; n],
            with_rejected,
            ..Sheet::default()
        }
    }

    /// The rows.
    pub fn examples(&self) -> &Arc<[Example]> {
        &self.examples
    }

    /// The files.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// The rows of a file, by number.
    pub fn rows_of(&self, file: usize) -> std::ops::Range<usize> {
        let before: usize = self.sources.iter().take(file).map(|source| source.rows).sum();
        before..before + self.sources.get(file).map_or(0, |source| source.rows)
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.examples.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.examples.is_empty()
    }

    /// What was decided of each row.
    pub fn decisions(&self) -> &[Decision] {
        &self.decisions
    }

    /// Which half each row is in.
    pub fn halves(&self) -> &[Half] {
        &self.halves
    }

    /// The rows of a half that are used: those that are not rejected, unless these are used too.
    pub fn rows_in(&self, half: Half) -> Vec<u32> {
        let is_used = |row: &u32| {
            let at = *row as usize;
            self.halves[at] == half
                && (self.with_rejected || !matches!(self.decisions[at], Decision::Rejected(_)))
        };
        (0..self.len() as u32).filter(is_used).collect()
    }

    /// How the sheet stands.
    pub fn care(&self, done: Option<Done>) -> Care {
        let is_rejected = |decision: &&Decision| matches!(decision, Decision::Rejected(_));
        let [undo, redo] = self.history.next();
        Care {
            revision: self.revision,
            rows: self.len() as u32,
            train: self.rows_in(Half::Train).len() as u32,
            held_out: self.rows_in(Half::HeldOut).len() as u32,
            rejected: self.decisions.iter().filter(is_rejected).count() as u32,
            done,
            undo,
            redo,
        }
    }

    /// Decides something of rows; those that there are not are left out.
    pub fn decide(&mut self, rows: &[u32], verdict: &Verdict) -> Care {
        let mut rows: Vec<u32> =
            rows.iter().copied().filter(|&row| (row as usize) < self.len()).collect();
        rows.sort_unstable();
        rows.dedup();
        let decision = match verdict {
            Verdict::Approve => Decision::Approved,
            Verdict::Reject(why) => Decision::Rejected(why.trim().into()),
            Verdict::Reopen => Decision::Open,
            Verdict::Put(half) => {
                let to: Vec<(u32, Half)> = rows.into_iter().map(|row| (row, *half)).collect();
                return self.put(Deed::Put(*half), to);
            }
        };
        let deed = match verdict {
            Verdict::Approve => Deed::Approve,
            Verdict::Reject(_) => Deed::Reject,
            Verdict::Reopen | Verdict::Put(_) => Deed::Reopen,
        };
        rows.retain(|&row| self.decisions[row as usize] != decision);
        let to = rows.into_iter().map(|row| (row, decision.clone())).collect();
        let before = self.exchange(Before::Decisions(to));
        self.did(deed, before)
    }

    /// Puts every row in the half that is said of it.
    pub fn divide(&mut self, halves: &[Half]) -> Care {
        let to = (0..self.len() as u32).zip(halves.iter().copied()).collect();
        self.put(Deed::Split, to)
    }

    fn put(&mut self, deed: Deed, mut to: Vec<(u32, Half)>) -> Care {
        to.retain(|&(row, half)| self.halves[row as usize] != half);
        let before = self.exchange(Before::Halves(to));
        self.did(deed, before)
    }

    fn did(&mut self, deed: Deed, before: Before) -> Care {
        let done = self.history.add(deed, before);
        self.care(done)
    }

    /// Undoes the last change, or does again what was undone last.
    pub fn turn(&mut self, back: bool) -> Care {
        let mut history = std::mem::take(&mut self.history);
        let done = history.turn(back, |before| self.exchange(before));
        self.history = history;
        self.care(done)
    }

    /// Puts values in place, and gives those that were there.
    fn exchange(&mut self, mut values: Before) -> Before {
        self.revision += 1;
        match &mut values {
            Before::Decisions(rows) => {
                for (row, value) in rows {
                    std::mem::swap(&mut self.decisions[*row as usize], value);
                }
            }
            Before::Halves(rows) => {
                for (row, value) in rows {
                    std::mem::swap(&mut self.halves[*row as usize], value);
                }
            }
        }
        values
    }

    /// Forgets what a model made of the rows.
    pub fn forget_outcomes(&mut self) {
        self.revision += 1;
        self.outcomes.fill(None);
        self.best.fill(None);
        self.forms.clear();
        self.marks.retain(|(_, rule), _| *rule != Rule::Invalid);
    }

    /// Says what a model makes of a row, and its best form.
    pub fn judged(&mut self, row: u32, outcome: Outcome, form: Option<&str>) {
        self.revision += 1;
        let at = row as usize;
        self.best[at] = form.map(|form| match self.forms.get_index_of(form) {
            Some(place) => place as u32,
            None => self.forms.insert_full(form.to_owned()).0 as u32,
        });
        self.outcomes[at] = Some(outcome);
    }

    /// What the model makes of the rows.
    pub fn outcomes(&self) -> &[Option<Outcome>] {
        &self.outcomes
    }

    /// Marks the rows by all rules, as strict as these are.
    pub fn mark(&mut self, rules: Rules) {
        self.revision += 1;
        let marks: [Marks; 4] = [
            invalid(&self.outcomes),
            strange(&self.examples, rules),
            duplicate(&self.examples),
            short(&self.examples, rules),
        ];
        self.marks =
            marks.into_iter().flatten().map(|(row, rule, why)| ((row, rule), why)).collect();
    }

    /// A window of a view.
    pub fn window(&mut self, view: &View, offset: u32, count: u32) -> Window {
        let rows = self.seen_rows(view);
        let (total, count) = (rows.len() as u32, count.min(MOST_LINES) as usize);
        let rows: Vec<u32> = rows.iter().skip(offset as usize).take(count).copied().collect();
        let lines = rows.into_iter().filter_map(|row| self.line(row)).collect();
        Window { total, offset, lines }
    }

    /// All rows of a view, in its order.
    pub fn seen_rows(&mut self, view: &View) -> &[u32] {
        let is_known = |(of, at, _): &(View, u32, Vec<u32>)| of == view && *at == self.revision;
        if !self.seen.as_ref().is_some_and(is_known) {
            self.seen = Some((view.clone(), self.revision, self.rows_seen(view)));
        }
        self.seen.as_ref().map_or(&[], |(_, _, rows)| rows)
    }

    fn rows_seen(&self, view: &View) -> Vec<u32> {
        let words: Vec<String> = view.text.split_whitespace().map(str::to_lowercase).collect();
        let files = view.file.map(|file| self.rows_of(file as usize));
        let is_in = |row: &u32| {
            let at = *row as usize;
            let Some(example) = self.examples.get(at) else { return false };
            let is = |wanted: &Option<String>, value: &Option<String>| {
                wanted.as_deref().is_none_or(|wanted| value.as_deref().unwrap_or("") == wanted)
            };
            let has_words = || {
                let (command, id) = (example.command.to_lowercase(), example.id.to_lowercase());
                words.iter().all(|word| command.contains(word) || id.contains(word))
            };
            is(&view.task, &example.task)
                && is(&view.worker, &example.worker)
                && view.status.is_none_or(|status| Status::of(&self.decisions[at]) == status)
                && view.half.is_none_or(|half| self.halves[at] == half)
                && view.outcome.is_none_or(|outcome| self.outcomes[at] == Some(outcome))
                && view.rule.is_none_or(|rule| self.marks.contains_key(&(*row, rule)))
                && files.as_ref().is_none_or(|files| files.contains(&at))
                && (words.is_empty() || has_words())
        };
        let mut rows: Vec<u32> = (0..self.len() as u32).filter(is_in).collect();
        rows.sort_by(|&a, &b| {
            let order = self.compare(view.sort, a as usize, b as usize);
            let order = if view.descending { order.reverse() } else { order };
            order.then(a.cmp(&b))
        });
        if view.sort == Sort::Row && view.descending {
            rows.reverse();
        }
        rows
    }

    fn compare(&self, sort: Sort, a: usize, b: usize) -> Ordering {
        let (one, other) = (&self.examples[a], &self.examples[b]);
        match sort {
            Sort::Row => Ordering::Equal,
            Sort::Command => one.command.cmp(&other.command),
            Sort::Task => one.task.cmp(&other.task),
            Sort::Worker => one.worker.cmp(&other.worker),
            Sort::Status => Status::of(&self.decisions[a]).cmp(&Status::of(&self.decisions[b])),
            Sort::Outcome => self.outcomes[a].cmp(&self.outcomes[b]),
            Sort::Pairs => one.pairs.len().cmp(&other.pairs.len()),
            Sort::Length => one.command.len().cmp(&other.command.len()),
        }
    }

    /// A row as a line.
    pub fn line(&self, row: u32) -> Option<Line> {
        let at = row as usize;
        let example = self.examples.get(at)?;
        let file = (0..self.sources.len()).find(|&file| self.rows_of(file).contains(&at));
        let rules = [Rule::Invalid, Rule::Strange, Rule::Duplicate, Rule::Short];
        let mark = |rule| Some((rule, self.marks.get(&(row, rule))?.clone()));
        Some(Line {
            row,
            file: file.unwrap_or_default() as u32,
            line: example.line,
            id: example.id.clone(),
            command: example.command.clone(),
            task: example.task.clone(),
            worker: example.worker.clone(),
            pairs: example.pairs.len() as u32,
            decision: self.decisions[at].clone(),
            half: self.halves[at],
            outcome: self.outcomes[at],
            form: self.best[at].and_then(|place| self.forms.get_index(place as usize)).cloned(),
            marks: rules.into_iter().filter_map(mark).collect(),
        })
    }

    /// What there is to filter by, with the number of rows of each.
    pub fn facets(&self) -> Facets {
        let text = |value: &Option<String>| value.clone().unwrap_or_default();
        Facets {
            tasks: facet(self.examples.iter().map(|example| text(&example.task))),
            workers: facet(self.examples.iter().map(|example| text(&example.worker))),
            statuses: counts(self.decisions.iter().map(Status::of)),
            outcomes: counts(self.outcomes.iter().flatten().copied()),
            rules: counts(self.marks.keys().map(|(_, rule)| *rule)),
            halves: counts(self.halves.iter().copied()),
            files: self.sources.iter().map(|source| source.rows as u32).collect(),
        }
    }
}

/// How often each value occurs, in the order of values.
fn counts<T: Ord + Hash + Eq>(values: impl Iterator<Item = T>) -> Vec<(T, u32)> {
    let mut counts: IndexMap<T, u32, FxBuildHasher> = IndexMap::default();
    values.for_each(|value| *counts.entry(value).or_default() += 1);
    counts.sort_unstable_keys();
    counts.into_iter().collect()
}

fn facet(values: impl Iterator<Item = String>) -> Facet {
    let mut values = counts(values);
    values.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
    let more = values.len().saturating_sub(MOST_VALUES) as u32;
    values.truncate(MOST_VALUES);
    Facet { values, more }
}
