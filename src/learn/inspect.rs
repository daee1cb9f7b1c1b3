//! What a model has learned, for a person who looks: its entries by word and by meaning with weight and use, the same
//! model without some of them, and what tells two models apart. Entries are the same where words, category and meaning are.

use super::audit::Rows;
use crate::ccg::{EntryId, EntryText, Feature, Model, Origin};
use crate::logic::print;
use indexmap::{IndexMap, IndexSet};
use rustc_hash::{FxBuildHasher, FxHashMap};
use serde::{Deserialize, Serialize};

/// The most entries of a window.
pub const MOST_ENTRIES: u32 = 1_000;

/// The most lines of each table of differences.
const MOST_LINES: usize = 500;

/// What moved by less is as it was.
const LEAST: f64 = 1e-9;

/// Which entries, and in which order.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct EntryView {
    /// What their words, category or meaning contain.
    pub text: String,
    /// Whether those of the seed are left out.
    pub learned: bool,
    /// By what they are sorted.
    pub sort: EntrySort,
    /// Whether the last comes first.
    pub descending: bool,
}

impl Default for EntryView {
    /// All, what is used most first.
    fn default() -> Self {
        Self { text: String::new(), learned: false, sort: EntrySort::Uses, descending: true }
    }
}

/// By what entries are sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "the names say it")]
pub enum EntrySort {
    /// The order in which they came into the lexicon.
    Place,
    Words,
    Meaning,
    Weight,
    Uses,
}

/// An entry of the lexicon and what there is to say of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EntryLine {
    /// Its place in the lexicon, from 0.
    pub place: u32,
    /// The entry.
    pub entry: EntryText,
    /// What its use adds to a score.
    pub weight: f64,
    /// The command that it was learned from, where that is known.
    pub from: Option<String>,
    /// The rows whose best reading uses it.
    pub uses: Rows,
}

/// Some entries of a lexicon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EntryWindow {
    /// Entries that the view has in all.
    pub total: u32,
    /// The place of the first line among them.
    pub offset: u32,
    /// The lines.
    pub lines: Vec<EntryLine>,
    /// Whole commands with a meaning of their own, of the whole model.
    pub idioms: Vec<(String, String)>,
    /// What some of the rows say that the lines name.
    pub sentences: Vec<(u32, String)>,
}

/// For entries that were learned the command that each came from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origins(FxHashMap<(String, String, String), String>);

impl Origins {
    /// Those of a model's learned entries, in the lexicon's order, as the training that made it tells.
    pub fn new(model: &Model, commands: &[String]) -> Origins {
        let learned = model.lexicon.entries().iter().copied();
        let learned = learned.filter(|&id| model.lexicon.origin(id) != Origin::Seed);
        let mut known = Origins::default();
        for (id, command) in learned.zip(commands) {
            known.0.insert(key(EntryText::of(model, id)), command.clone());
        }
        known
    }

    fn of(&self, entry: &EntryText) -> Option<String> {
        self.0.get(&key(entry.clone())).cloned()
    }
}

fn key(entry: EntryText) -> (String, String, String) {
    (entry.words, entry.syntax, entry.meaning)
}

/// A window of a model's lexicon.
pub fn entries(
    model: &Model,
    (view, offset, count): (&EntryView, u32, u32),
    origins: &Origins,
    uses: impl Fn(EntryId) -> Rows,
) -> EntryWindow {
    let wanted = view.text.to_lowercase();
    let mut found: Vec<EntryLine> = Vec::new();
    for (place, &id) in (0..).zip(model.lexicon.entries()) {
        let entry = EntryText::of(model, id);
        let has = |text: &str| text.to_lowercase().contains(&wanted);
        if (entry.learned || !view.learned)
            && (has(&entry.words) || has(&entry.meaning) || has(&entry.syntax))
        {
            let (weight, from, uses) = (model.entry_score(id), origins.of(&entry), uses(id));
            found.push(EntryLine { place, entry, weight, from, uses });
        }
    }
    found.sort_by(|a, b| {
        let order = match view.sort {
            EntrySort::Place => a.place.cmp(&b.place),
            EntrySort::Words => a.entry.words.cmp(&b.entry.words),
            EntrySort::Meaning => a.entry.meaning.cmp(&b.entry.meaning),
            EntrySort::Weight => a.weight.total_cmp(&b.weight),
            EntrySort::Uses => a.uses.count.cmp(&b.uses.count),
        };
        let order = if view.descending { order.reverse() } else { order };
        order.then(a.place.cmp(&b.place))
    });
    let total = found.len() as u32;
    let count = count.min(MOST_ENTRIES) as usize;
    let idioms = model.lexicon.idioms().map(|(words, id)| {
        let goal = model.lexicon.category(id).meaning;
        (words.join(" "), print(&model.grammar.terms, goal))
    });
    EntryWindow {
        sentences: Vec::new(),
        total,
        offset,
        lines: found.into_iter().skip(offset as usize).take(count).collect(),
        idioms: idioms.collect(),
    }
}

/// A model without the entries of these places in its lexicon. The rest of it stays, weights among it.
pub fn without(model: &Model, places: &[u32]) -> Model {
    let mut place = 0;
    let stays = |line: &&str| {
        let is_entry = line.starts_with("entry\t");
        let is_out = is_entry && places.contains(&place);
        place += u32::from(is_entry);
        !is_out
    };
    let text = model.print();
    let left: Vec<&str> = text.split_inclusive('\n').filter(stays).collect();
    // What was printed can be read, and no line hangs on an entry: features name candidates, too.
    Model::read(&left.concat()).unwrap_or_else(|_| model.clone())
}

/// What tells two models apart.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Difference {
    /// Facts that differ, each as the first and as the second has it.
    pub facts: Vec<(String, Option<String>, Option<String>)>,
    /// Entries of both.
    pub common: u32,
    /// Entries that the first alone has.
    pub first_alone: Entries,
    /// Entries that the second alone has.
    pub second_alone: Entries,
    /// Entries of both with other weights, those that moved most first, as the first and as the second has them.
    pub entries: Vec<(EntryText, f64, f64)>,
    /// Other features with other weights, those that moved most first.
    pub features: Vec<(String, f64, f64)>,
}

/// Entries, of which the first few are listed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Entries {
    /// How many there are.
    pub count: u32,
    /// The first of them, each with its weight.
    pub first: Vec<(EntryText, f64)>,
}

/// Holds two models against each other.
pub fn difference(first: &Model, second: &Model) -> Difference {
    let (ours, theirs) = (weighed(first), weighed(second));
    let alone = |one: &Weighed, other: &Weighed| {
        let alone: Vec<(EntryText, f64)> = one
            .iter()
            .filter(|(key, _)| !other.contains_key(*key))
            .map(|(_, e)| e.clone())
            .collect();
        Entries { count: alone.len() as u32, first: alone.into_iter().take(MOST_LINES).collect() }
    };
    let both: Vec<(EntryText, f64, f64)> = ours
        .iter()
        .filter_map(|(key, (entry, a))| Some((entry.clone(), *a, theirs.get(key)?.1)))
        .collect();
    let names: IndexSet<&String, FxBuildHasher> =
        first.facts.keys().chain(second.facts.keys()).collect();
    let fact = |name: &String| {
        let (a, b) = (first.facts.get(name).cloned(), second.facts.get(name).cloned());
        (a != b).then(|| (name.clone(), a, b))
    };
    let (a, b) = (features(first), features(second));
    let names_of: IndexSet<&String, FxBuildHasher> = a.keys().chain(b.keys()).collect();
    let weight = |of: &IndexMap<String, f64, FxBuildHasher>, name: &String| {
        of.get(name).copied().unwrap_or_default()
    };
    let features =
        names_of.into_iter().map(|name| (name.clone(), weight(&a, name), weight(&b, name)));
    Difference {
        facts: names.into_iter().filter_map(fact).collect(),
        common: both.len() as u32,
        first_alone: alone(&ours, &theirs),
        second_alone: alone(&theirs, &ours),
        entries: most_moved(both),
        features: most_moved(features.collect()),
    }
}

type Weighed = IndexMap<(String, String, String), (EntryText, f64), FxBuildHasher>;

fn weighed(model: &Model) -> Weighed {
    let entry = |&id: &EntryId| {
        let entry = EntryText::of(model, id);
        (key(entry.clone()), (entry, model.entry_score(id)))
    };
    model.lexicon.entries().iter().map(entry).collect()
}

/// Weights by feature, but for those of entries and templates, which are told with the entries.
fn features(model: &Model) -> IndexMap<String, f64, FxBuildHasher> {
    let told = model.features.iter().filter(|(feature, weight, _)| {
        !matches!(feature, Feature::Entry(_) | Feature::Template(_)) && *weight != 0.0
    });
    told.map(|(feature, weight, _)| {
        (model.feature_text(feature).trim_end().replace('\t', " "), weight)
    })
    .collect()
}

/// Those that moved, the farthest first.
fn most_moved<T>(mut all: Vec<(T, f64, f64)>) -> Vec<(T, f64, f64)> {
    let by = |(_, a, b): &(T, f64, f64)| (a - b).abs();
    all.retain(|moved| by(moved) > LEAST);
    all.sort_by(|a, b| by(b).total_cmp(&by(a)));
    all.truncate(MOST_LINES);
    all
}
