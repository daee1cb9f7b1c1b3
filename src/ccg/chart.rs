//! The CKY chart: edges over spans, each the best way to a category, kept within a beam. No result depends on
//! hash or insertion order: edges are ordered by score, then category; the derivations of one edge by rule row,
//! split, left and right.

use super::category::Category;
use super::combinator::{Grammar, Made, RuleId};
use super::syntax::SyntaxId;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// What limits a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChartConfig {
    /// Edges kept per span.
    pub beam: usize,
    /// Derivations tried in all; beyond it the chart stays as it is and says so.
    pub budget: usize,
    /// Whether every derivation of an edge is kept, or the best alone.
    pub all_derivations: bool,
    /// Whether a functor may add nothing to its argument, as placeholders do.
    pub allow_vacuous: bool,
}

impl Default for ChartConfig {
    /// The paper's beam; a budget that a sentence of 50 words rarely reaches.
    fn default() -> Self {
        ChartConfig { beam: 150, budget: 2_000_000, all_derivations: false, allow_vacuous: false }
    }
}

impl ChartConfig {
    /// The settings that a model was trained with.
    pub fn of(model: &super::Model) -> Self {
        let fact = |name: &str| model.facts.get(name)?.parse().ok();
        let default = ChartConfig::default();
        ChartConfig {
            beam: fact("beam").unwrap_or(default.beam),
            budget: fact("budget").unwrap_or(default.budget),
            ..default
        }
    }
}

/// A category that the lexicon gives to a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lexical {
    /// The first word.
    pub start: usize,
    /// One past the last word.
    pub end: usize,
    /// The words of the span that are skipped.
    pub skipped: usize,
    /// The category.
    pub category: Category,
    /// Its score.
    pub score: f64,
    /// The caller's name for it.
    pub item: u32,
}

/// How an edge came about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// From the lexicon: an index into [`Chart::lexical`].
    Lexical(u32),
    /// From two neighbours.
    Binary {
        /// The rule.
        rule: RuleId,
        /// The edge to the left.
        left: u32,
        /// The edge to the right.
        right: u32,
    },
    /// From one edge of the same span.
    Shift {
        /// The rule.
        rule: RuleId,
        /// The edge.
        child: u32,
    },
}

/// A category over a span.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// The category.
    pub category: Category,
    /// How it was made, for the normal form.
    pub made: Made,
    /// The best score of its derivations.
    pub score: f64,
    /// Its best derivation.
    pub step: Step,
    /// The first of its other derivations, where they are kept.
    other: u32,
    /// Where its best derivation splits the span, for ties.
    split: u32,
}

const NONE: u32 = u32::MAX;

/// The edges of one span, by syntax.
#[derive(Clone, Debug, Default)]
struct Span {
    edges: std::ops::Range<u32>,
    groups: Vec<(SyntaxId, Vec<u32>)>,
}

/// A finished chart.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The lexical items it was built from.
    pub lexical: Vec<Lexical>,
    /// Whether the budget ended it.
    pub over_budget: bool,
    /// Derivations tried.
    pub tried: usize,
    edges: Vec<Edge>,
    others: Vec<(Step, u32)>,
    spans: Vec<Span>,
    words: usize,
}

impl Chart {
    /// Fills a chart over `words` words.
    pub fn fill(
        grammar: &mut Grammar,
        words: usize,
        lexical: Vec<Lexical>,
        rule_score: impl Fn(RuleId) -> f64,
        config: ChartConfig,
    ) -> Chart {
        let spans = vec![Span::default(); words * (words + 1)];
        let chart = Chart {
            lexical,
            over_budget: false,
            tried: 0,
            edges: Vec::new(),
            others: Vec::new(),
            spans,
            words,
        };
        let mut items = vec![Vec::new(); words * (words + 1)];
        for (index, item) in (0..).zip(&chart.lexical) {
            items[item.start * (words + 1) + item.end].push(index);
        }
        let (cell, known) = (Vec::new(), FxHashMap::default());
        let mut filling = Filling { chart, grammar, rule_score, config, items, cell, known };
        for width in 1..=words {
            for start in 0..=words - width {
                filling.span(start, start + width);
            }
        }
        filling.chart
    }

    /// The edge behind an index.
    pub fn edge(&self, index: u32) -> &Edge {
        &self.edges[index as usize]
    }

    /// The number of edges.
    pub fn n_edges(&self) -> usize {
        self.edges.len()
    }

    /// The edges over the whole sentence, best first.
    pub fn roots(&self) -> std::ops::Range<u32> {
        if self.words == 0 { 0..0 } else { self.at(0, self.words).edges.clone() }
    }

    /// Every derivation of an edge that was kept, the best first.
    pub fn steps(&self, index: u32) -> impl Iterator<Item = Step> {
        let edge = self.edge(index);
        let mut next = edge.other;
        std::iter::once(edge.step).chain(std::iter::from_fn(move || {
            let &(step, after) = self.others.get(next as usize)?;
            next = after;
            Some(step)
        }))
    }

    fn at(&self, start: usize, end: usize) -> &Span {
        &self.spans[start * (self.words + 1) + end]
    }
}

/// A chart while it is filled, with the cell at work.
struct Filling<'a, F> {
    chart: Chart,
    grammar: &'a mut Grammar,
    rule_score: F,
    config: ChartConfig,
    /// The lexical items of each span.
    items: Vec<Vec<u32>>,
    cell: Vec<Edge>,
    known: FxHashMap<(Category, Made), u32>,
}

impl<F: Fn(RuleId) -> f64> Filling<'_, F> {
    fn span(&mut self, start: usize, end: usize) {
        self.cell.clear();
        self.known.clear();
        let items = std::mem::take(&mut self.items[start * (self.chart.words + 1) + end]);
        for index in items {
            let item = self.chart.lexical[index as usize];
            self.add(item.category, Made::Plainly, item.score, Step::Lexical(index), start);
        }
        for split in start + 1..end {
            self.join(start, split, end);
        }
        let first = self.chart.edges.len() as u32;
        self.keep();
        self.shift(first, start);
        self.store(first, start, end);
    }

    /// All pairs of neighbours that a rule combines.
    fn join(&mut self, start: usize, split: usize, end: usize) {
        let n_left = self.chart.at(start, split).groups.len();
        let n_right = self.chart.at(split, end).groups.len();
        for left in 0..n_left {
            for right in 0..n_right {
                let left_syntax = self.chart.at(start, split).groups[left].0;
                let right_syntax = self.chart.at(split, end).groups[right].0;
                if self.grammar.rows(left_syntax, right_syntax).is_empty() {
                    continue;
                }
                let rows = self.grammar.rows(left_syntax, right_syntax).to_vec();
                let lefts = self.chart.at(start, split).groups[left].1.clone();
                let rights = self.chart.at(split, end).groups[right].1.clone();
                for (rule, syntax) in rows {
                    let own = (self.rule_score)(rule);
                    for &l in &lefts {
                        for &r in &rights {
                            self.combine(rule, syntax, own, (l, r), split);
                        }
                    }
                }
            }
        }
    }

    fn combine(
        &mut self,
        rule: RuleId,
        syntax: SyntaxId,
        own: f64,
        (l, r): (u32, u32),
        split: usize,
    ) {
        let (left, right) = (*self.chart.edge(l), *self.chart.edge(r));
        if !rule.admits(left.made, right.made) {
            return;
        }
        if self.chart.tried >= self.config.budget {
            self.chart.over_budget = true;
            return;
        }
        self.chart.tried += 1;
        let meanings = (left.category.meaning, right.category.meaning);
        let vacuous = self.config.allow_vacuous;
        if let Some(meaning) = self.grammar.combine(rule, meanings.0, meanings.1, vacuous) {
            let score = left.score + right.score + own;
            let step = Step::Binary { rule, left: l, right: r };
            self.add(Category { syntax, meaning }, rule.makes(), score, step, split);
        }
    }

    /// Adds a derivation to the cell: a new edge, a better way to a known one, or another way.
    fn add(&mut self, category: Category, made: Made, score: f64, step: Step, split: usize) {
        let split = split as u32;
        let new = Edge { category, made, score, step, other: NONE, split };
        let place = *self.known.entry((category, made)).or_insert(self.cell.len() as u32);
        let Some(edge) = self.cell.get_mut(place as usize) else {
            return self.cell.push(new);
        };
        let better = match score.total_cmp(&edge.score) {
            Ordering::Greater => true,
            Ordering::Less => false,
            Ordering::Equal => key(step, split) < key(edge.step, edge.split),
        };
        let worse = if better { edge.step } else { step };
        if better {
            (edge.score, edge.step, edge.split) = (score, step, split);
        }
        if self.config.all_derivations {
            self.chart.others.push((worse, edge.other));
            edge.other = self.chart.others.len() as u32 - 1;
        }
    }

    /// Orders the cell and moves what the beam holds into the chart.
    fn keep(&mut self) {
        let Grammar { terms, syntaxes, .. } = &*self.grammar;
        let order = |x: &Edge, y: &Edge| {
            y.score
                .total_cmp(&x.score)
                .then_with(|| x.category.compare(y.category, syntaxes, terms))
                .then_with(|| x.made.cmp(&y.made))
        };
        if self.cell.len() > self.config.beam {
            self.cell.select_nth_unstable_by(self.config.beam, order);
            self.cell.truncate(self.config.beam);
        }
        self.cell.sort_unstable_by(order);
        self.chart.edges.append(&mut self.cell);
    }

    /// Shifts what was kept, at most once: what comes out stands behind it, beyond the beam.
    fn shift(&mut self, first: u32, start: usize) {
        self.known.clear();
        for child in first..self.chart.edges.len() as u32 {
            let edge = *self.chart.edge(child);
            for (rule, category) in self.grammar.shifts(edge.category) {
                let score = edge.score + (self.rule_score)(rule);
                self.add(category, Made::ByShift, score, Step::Shift { rule, child }, start);
            }
        }
        self.chart.edges.append(&mut self.cell);
    }

    /// Files the edges from `first` on by syntax.
    fn store(&mut self, first: u32, start: usize, end: usize) {
        let mut span = Span { edges: first..self.chart.edges.len() as u32, groups: Vec::new() };
        for index in span.edges.clone() {
            let syntax = self.chart.edge(index).category.syntax;
            match span.groups.iter_mut().find(|(known, _)| *known == syntax) {
                Some((_, members)) => members.push(index),
                None => span.groups.push((syntax, vec![index])),
            }
        }
        self.chart.spans[start * (self.chart.words + 1) + end] = span;
    }
}

/// The order of derivations of one edge that score alike: composed before lexical, then by rule, split, left, right.
fn key(step: Step, split: u32) -> (u8, u32, u32, u32) {
    match step {
        Step::Binary { rule, left, right } => (rule.0, split, left, right),
        Step::Shift { rule, child } => (rule.0, split, child, 0),
        Step::Lexical(item) => (u8::MAX, split, item, 0),
    }
}
