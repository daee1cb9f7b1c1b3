//! Which task a wrong answer would have done: its form is tried on the demonstrations of a few commands of every
//! task. A wrong answer counts once, for the task of which it does the largest share of those commands; its own
//! task goes first among equals (then its command asks for something else than its kind), then the corpus' order.
//! Work is bounded: a form is tried on [`REPRESENTATIVES`] commands a task.

use crate::corpus::Example;
use crate::ground::{PairId, Validator};
use crate::logic::{TermId, Terms};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;
use std::collections::BTreeMap;

/// Commands of a task that stand for it, spread evenly over the corpus.
pub const REPRESENTATIVES: usize = 8;

/// How often an answer to a command of one task did another, by name; `None` is a command without a label, and an
/// answer that does none of the tasks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Confusion {
    counts: BTreeMap<(Option<String>, Option<String>), usize>,
}

impl Confusion {
    /// Counts a wrong answer to a command of a task, which does what another asks.
    pub fn count(&mut self, task: Option<&str>, does: Option<&str>) {
        let key = (task.map(str::to_owned), does.map(str::to_owned));
        *self.counts.entry(key).or_default() += 1;
    }

    /// The cells that are not zero, in the order of names: the task, what was done, how often.
    pub fn cells(&self) -> impl Iterator<Item = (Option<&str>, Option<&str>, usize)> {
        self.counts.iter().map(|((task, does), &n)| (task.as_deref(), does.as_deref(), n))
    }

    /// Takes in what was counted elsewhere.
    pub fn add(&mut self, other: Confusion) {
        for (cell, n) in other.counts {
            *self.counts.entry(cell).or_default() += n;
        }
    }
}

/// What recognises tasks by their demonstrations.
pub(super) struct Observer {
    validator: Validator,
    /// The pairs of each representative of a task.
    tasks: IndexMap<String, Vec<Vec<PairId>>, FxBuildHasher>,
}

impl Observer {
    /// An observer of the labelled tasks of a corpus.
    pub(super) fn new(examples: &[Example]) -> Self {
        let mut labelled: IndexMap<&str, Vec<&Example>, FxBuildHasher> = IndexMap::default();
        for example in examples {
            if let Some(task) = &example.task {
                labelled.entry(task).or_default().push(example);
            }
        }
        let mut validator = Validator::new();
        let mut tasks = IndexMap::default();
        for (task, all) in labelled {
            let n = all.len().min(REPRESENTATIVES);
            let spread = (0..n).filter_map(|i| all.get(i * all.len() / n));
            let pairs = spread.map(|example| {
                example
                    .pairs
                    .iter()
                    .map(|pair| validator.shown(&pair.pre, &pair.post, pair.way.as_deref()))
                    .collect()
            });
            let pairs: Vec<Vec<PairId>> = pairs.collect();
            tasks.insert(task.to_owned(), pairs);
        }
        Observer { validator, tasks }
    }

    /// The task that a form does, if any.
    pub(super) fn recognise(
        &mut self,
        terms: &Terms,
        form: TermId,
        own: Option<&str>,
    ) -> Option<&str> {
        let mut best: Option<(usize, usize, &str)> = None;
        let own_first = |task: &&String| own != Some(task.as_str());
        let mut order: Vec<&String> = self.tasks.keys().collect();
        order.sort_by_key(own_first);
        for task in order {
            let Some(commands) = self.tasks.get(task) else { continue };
            let validator = &mut self.validator;
            let done = commands.iter().filter(|pairs| validator.valid(terms, form, pairs)).count();
            // done / n > most / of, in whole numbers
            let is_more = best.is_none_or(|(most, of, _)| done * of > most * commands.len());
            if done > 0 && is_more {
                best = Some((done, commands.len(), task));
            }
        }
        best.map(|(_, _, task)| task)
    }
}
