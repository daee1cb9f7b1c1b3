//! Derivations: how a reading was put together, rebuilt from a chart, with the features that scored it and a
//! drawing as the field prints them.

use super::category::Category;
use super::chart::{Chart, Step};
use super::combinator::{Grammar, RuleId, Side};
use super::features::{Feature, root_features};
use super::hearing::taken;
use super::lexicon::EntryId;
use super::model::Model;
use crate::logic::{TermId, print_human};

/// A proof tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Derivation {
    /// Words with their category.
    Leaf {
        /// The first word.
        start: usize,
        /// One past the last word.
        end: usize,
        /// The words of the entry, in the same way: those around them are absorbed.
        own: (usize, usize),
        /// The entry.
        entry: EntryId,
        /// Its category.
        category: Category,
    },
    /// One or two constituents put together.
    Node {
        /// The rule.
        rule: RuleId,
        /// One child of a shift, two of a binary rule.
        children: Vec<Derivation>,
        /// What came out.
        category: Category,
    },
}

impl Derivation {
    /// The best derivation of an edge. `entry_of` names the entry of a lexical item.
    pub fn of(chart: &Chart, edge: u32, entry_of: &impl Fn(u32) -> EntryId) -> Derivation {
        let found = chart.edge(edge);
        let category = found.category;
        let node = |rule, children| Derivation::Node { rule, children, category };
        match found.step {
            Step::Lexical(index) => {
                let item = &chart.lexical[index as usize];
                Derivation::Leaf {
                    start: item.start,
                    end: item.end,
                    own: item.own,
                    entry: entry_of(item.item),
                    category,
                }
            }
            Step::Binary { rule, left, right } => {
                node(rule, vec![Self::of(chart, left, entry_of), Self::of(chart, right, entry_of)])
            }
            Step::Shift { rule, child } => node(rule, vec![Self::of(chart, child, entry_of)]),
        }
    }

    /// The words it spans: the first and one past the last.
    pub fn span(&self) -> (usize, usize) {
        match self {
            Derivation::Leaf { start, end, .. } => (*start, *end),
            Derivation::Node { children, .. } => {
                let first = children.first().map_or(0, |child| child.span().0);
                (first, children.last().map_or(0, |child| child.span().1))
            }
        }
    }

    /// What it makes.
    pub fn category(&self) -> Category {
        match self {
            Derivation::Leaf { category, .. } | Derivation::Node { category, .. } => *category,
        }
    }

    /// The entry of a leaf.
    pub fn entry(&self) -> Option<EntryId> {
        match self {
            Derivation::Leaf { entry, .. } => Some(*entry),
            Derivation::Node { .. } => None,
        }
    }

    /// Its leaves from left to right.
    pub fn leaves(&self) -> Vec<&Derivation> {
        match self {
            Derivation::Leaf { .. } => vec![self],
            Derivation::Node { children, .. } => children.iter().flat_map(Self::leaves).collect(),
        }
    }

    /// The places of the words that its leaves absorb, from left to right.
    pub fn absorbed(&self) -> Vec<usize> {
        let around = |leaf: &Derivation| match *leaf {
            Derivation::Leaf { start, end, own, .. } => (start..own.0).chain(own.1..end),
            Derivation::Node { .. } => (0..0).chain(0..0),
        };
        self.leaves().into_iter().flat_map(around).collect()
    }

    /// The places of the words whose meaning a functor or a shift throws away, with what it throws away.
    pub fn thrown(&self, grammar: &Grammar) -> Vec<(usize, Category)> {
        let Derivation::Node { rule, children, .. } = self else { return Vec::new() };
        let lost = match &children[..] {
            [left, right] => {
                let [f, g] = [left, right].map(|child| child.category().meaning);
                grammar.thrown(*rule, f, g).map(|side| match side {
                    Side::Left => left,
                    _ => right,
                })
            }
            [child] => grammar.shift_throws(*rule).then_some(child),
            _ => None,
        };
        let lost = lost.into_iter().flat_map(|lost| {
            let own = lost.leaves().into_iter().flat_map(Self::own);
            own.map(|at| (at, lost.category()))
        });
        lost.chain(children.iter().flat_map(|child| child.thrown(grammar))).collect()
    }

    /// The places of a leaf's own words.
    fn own(&self) -> std::ops::Range<usize> {
        match *self {
            Derivation::Leaf { own, .. } => own.0..own.1,
            Derivation::Node { .. } => 0..0,
        }
    }

    /// Every feature of the reading that the derivation ends in, as often as it occurs. `empty` gives the entry by
    /// which the word at a place means nothing; a word without one is skipped.
    pub fn features(
        &self,
        model: &Model,
        form: TermId,
        words: &[String],
        empty: &[Option<EntryId>],
    ) -> Vec<Feature> {
        let Grammar { terms, sorts, .. } = &model.grammar;
        self.features_besides(model, root_features(terms, sorts, form), words, empty)
    }

    /// The same, when the features of the goal as a whole are known.
    pub fn features_besides(
        &self,
        model: &Model,
        mut features: Vec<Feature>,
        words: &[String],
        empty: &[Option<EntryId>],
    ) -> Vec<Feature> {
        for at in self.absorbed() {
            features.extend(model.absorption_features(&words[at], empty[at]));
        }
        self.collect_features(model, words, &mut features);
        features
    }

    fn collect_features(&self, model: &Model, words: &[String], found: &mut Vec<Feature>) {
        match self {
            Derivation::Leaf { own: (start, end), entry, .. } => {
                found.extend(model.entry_features(*entry));
                let taken = taken(model, &words[*start..*end], *entry);
                found.extend(taken.into_iter().flat_map(|(_, features)| features));
            }
            Derivation::Node { rule, children, category } => {
                children.iter().for_each(|child| child.collect_features(model, words, found));
                found.push(Feature::Rule(*rule));
                let parts: Vec<TermId> = children.iter().map(|c| c.category().meaning).collect();
                let lost = model.grammar.lost(&parts, category.meaning) as usize;
                found.extend(std::iter::repeat_n(Feature::Lost, lost));
            }
        }
    }

    /// The proof as the field draws it: words, categories below them, a ruled line for each step; then what each
    /// leaf means.
    pub fn print(&self, model: &Model, words: &[String]) -> String {
        let syntaxes = &model.grammar.syntaxes;
        let (first, last) = self.span();
        let mut starts = vec![0; last + 1];
        for leaf in self.leaves() {
            let (start, end) = leaf.span();
            let text = words[start..end].join(" ").chars().count();
            let width = text.max(syntaxes.text(leaf.category().syntax).chars().count()) + 2;
            (start + 1..=end).for_each(|at| starts[at] = starts[start] + width);
        }
        let columns = |(start, end): (usize, usize)| {
            (starts[start] - starts[first], starts[end] - starts[first] - 2)
        };
        let mut rows: Vec<String> = Vec::new();
        self.draw(&columns, words, model, &mut rows);
        for leaf in self.leaves() {
            let (start, end) = leaf.span();
            let meaning = print_human(&model.grammar.terms, leaf.category().meaning);
            rows.push(format!("{} := {meaning}", words[start..end].join(" ")));
        }
        rows.join("\n")
    }

    /// Draws the subtree; returns the first free row below it.
    fn draw(
        &self,
        columns: &impl Fn((usize, usize)) -> (usize, usize),
        words: &[String],
        model: &Model,
        rows: &mut Vec<String>,
    ) -> usize {
        let (start, end) = self.span();
        let (left, right) = columns((start, end));
        let syntax = model.grammar.syntaxes.text(self.category().syntax);
        match self {
            Derivation::Leaf { .. } => {
                place(rows, 0, left, right, &words[start..end].join(" "));
                place(rows, 1, left, right, syntax);
                2
            }
            Derivation::Node { rule, children, .. } => {
                let below = children.iter().map(|child| child.draw(columns, words, model, rows));
                let row = below.max().unwrap_or(0);
                let name = model.grammar.rule_name(*rule);
                let dashes = (right - left).saturating_sub(name.chars().count());
                place(rows, row, left, right, &format!("{}{name}", "-".repeat(dashes)));
                place(rows, row + 1, left, right, syntax);
                row + 2
            }
        }
    }
}

/// Writes `text` centred between two columns of a row.
fn place(rows: &mut Vec<String>, row: usize, left: usize, right: usize, text: &str) {
    if rows.len() <= row {
        rows.resize(row + 1, String::new());
    }
    let room = (right - left).saturating_sub(text.chars().count());
    let line = &mut rows[row];
    let have = line.chars().count();
    line.push_str(&" ".repeat((left + room / 2).saturating_sub(have)));
    line.push_str(text);
}
