//! The CKY chart: edges over spans, each the best way to a category, kept within a beam. No result depends on
//! hash or insertion order: edges are ordered by score, then category; the derivations of one edge by rule row,
//! split, left and right.

use super::category::Category;
use super::combinator::{Grammar, Made, RuleId};
use super::features::{Feature, Features};
use super::reach::Reach;
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
    /// Whether a functor or a shift may throw its argument away.
    pub allow_throwing: bool,
}

impl Default for ChartConfig {
    /// The paper's beam; a budget of a fraction of a second, so that whoever pumps a job is soon heard again.
    fn default() -> Self {
        ChartConfig {
            beam: 150,
            budget: 200_000,
            all_derivations: false,
            allow_vacuous: false,
            allow_throwing: false,
        }
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
    /// The words that have the category, first and one past the last: those around them are absorbed.
    pub own: (usize, usize),
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
    /// Whether as a functor it throws its first argument away, and its second.
    throws: [bool; 2],
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
    /// Fills a chart over `words` words with what can be part of a sentence. Edges whose sorts do not fit, and those
    /// that `admit` refuses, are left out.
    pub fn fill(
        grammar: &mut Grammar,
        features: &Features,
        words: usize,
        lexical: Vec<Lexical>,
        admit: impl FnMut(&Grammar, (usize, usize), Category) -> bool,
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
        let loss = features.value(Feature::Lost);
        let given = chart.lexical.iter().map(|item| (item.start, item.end, item.category.syntax));
        let reach = Reach::new(grammar, words, given);
        let cell = Cell { span: (0, 0), edges: Vec::new(), known: FxHashMap::default(), admit };
        let mut filling = Filling { chart, grammar, features, loss, config, items, reach, cell };
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

    /// The edges over the whole sentence, best first.
    pub fn roots(&self) -> std::ops::Range<u32> {
        if self.words == 0 { 0..0 } else { self.at(0, self.words).edges.clone() }
    }

    /// The edges that lead up to any of `tops`, which are of this chart, with their spans.
    pub fn below(&self, tops: impl IntoIterator<Item = u32>) -> Vec<(usize, usize, u32)> {
        let mut seen = vec![false; self.edges.len()];
        let mut open: Vec<(usize, usize, u32)> =
            tops.into_iter().map(|edge| (0, self.words, edge)).collect();
        let mut found = Vec::new();
        while let Some((start, end, edge)) = open.pop() {
            if std::mem::replace(&mut seen[edge as usize], true) {
                continue;
            }
            found.push((start, end, edge));
            for step in self.steps(edge) {
                match step {
                    Step::Lexical(_) => {}
                    Step::Shift { child, .. } => open.push((start, end, child)),
                    Step::Binary { left, right, .. } => {
                        let is_left = |split: &usize| self.at(start, *split).edges.contains(&left);
                        let split = (start + 1..end).find(is_left).unwrap_or(end);
                        open.extend([(start, split, left), (split, end, right)]);
                    }
                }
            }
        }
        found
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
struct Filling<'a, A> {
    chart: Chart,
    grammar: &'a mut Grammar,
    features: &'a Features,
    /// What it adds to a score that a step loses a predicate.
    loss: f64,
    config: ChartConfig,
    /// The lexical items of each span.
    items: Vec<Vec<u32>>,
    reach: Reach,
    cell: Cell<A>,
}

/// The edges of the span at work, by category and how they were made.
struct Cell<A> {
    span: (usize, usize),
    edges: Vec<Edge>,
    /// The place of an edge among them, or `NONE` for one that is not admitted.
    known: FxHashMap<(Category, Made), u32>,
    admit: A,
}

/// A derivation on its way into a cell.
struct Found {
    category: Category,
    made: Made,
    score: f64,
    step: Step,
    split: u32,
}

impl<A: FnMut(&Grammar, (usize, usize), Category) -> bool> Filling<'_, A> {
    fn span(&mut self, start: usize, end: usize) {
        self.cell.known.clear();
        self.cell.span = (start, end);
        let items = std::mem::take(&mut self.items[start * (self.chart.words + 1) + end]);
        for index in items {
            let Lexical { category, score, .. } = self.chart.lexical[index as usize];
            if !self.reach.is_useful(start, end, category.syntax) {
                continue;
            }
            let step = Step::Lexical(index);
            self.add(Found { category, made: Made::Plainly, score, step, split: start as u32 });
        }
        for split in start + 1..end {
            self.join(start, split, end);
        }
        let first = self.chart.edges.len() as u32;
        self.keep();
        self.shift(first, start, end);
        self.store(first, start, end);
    }

    fn add(&mut self, found: Found) {
        let others = self.config.all_derivations.then_some(&mut self.chart.others);
        self.cell.add(self.grammar, others, found);
    }

    /// All pairs of neighbours that a rule combines.
    fn join(&mut self, start: usize, split: usize, end: usize) {
        let Filling { chart, grammar, features, loss, config, reach, cell, .. } = self;
        let Chart { spans, edges, others, tried, over_budget, words, .. } = chart;
        let (lefts, rights) =
            (&spans[start * (*words + 1) + split], &spans[split * (*words + 1) + end]);
        for (left_syntax, lefts) in &lefts.groups {
            for (right_syntax, rights) in &rights.groups {
                for row in 0..grammar.rows(*left_syntax, *right_syntax).len() {
                    let (rule, syntax) = grammar.rows(*left_syntax, *right_syntax)[row];
                    if !reach.is_useful(start, end, syntax) {
                        continue;
                    }
                    let own = features.value(Feature::Rule(rule));
                    for &l in lefts {
                        let left = edges[l as usize];
                        for &r in rights {
                            let right = edges[r as usize];
                            if !rule.admits(left.made, right.made)
                                || !config.allow_throwing && rule.throws(left.throws, right.throws)
                            {
                                continue;
                            }
                            if *tried >= config.budget {
                                *over_budget = true;
                                return;
                            }
                            *tried += 1;
                            let (f, g) = (left.category.meaning, right.category.meaning);
                            let Some(meaning) = grammar.combine(rule, f, g, config.allow_vacuous)
                            else {
                                continue;
                            };
                            let lost = f64::from(grammar.lost(&[f, g], meaning));
                            let found = Found {
                                category: Category { syntax, meaning },
                                made: rule.makes(),
                                score: left.score + right.score + own + lost * *loss,
                                step: Step::Binary { rule, left: l, right: r },
                                split: split as u32,
                            };
                            let others = config.all_derivations.then_some(&mut *others);
                            cell.add(grammar, others, found);
                        }
                    }
                }
            }
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
        let edges = &mut self.cell.edges;
        if edges.len() > self.config.beam {
            edges.select_nth_unstable_by(self.config.beam, order);
            edges.truncate(self.config.beam);
        }
        edges.sort_unstable_by(order);
        self.chart.edges.append(edges);
    }

    /// Shifts what was kept, at most once: what comes out stands behind it, beyond the beam.
    fn shift(&mut self, first: u32, start: usize, end: usize) {
        self.cell.known.clear();
        for child in first..self.chart.edges.len() as u32 {
            let edge = *self.chart.edge(child);
            for (rule, category) in self.grammar.shifted(edge.category) {
                if !self.reach.is_useful(start, end, category.syntax)
                    || !self.config.allow_throwing && self.grammar.shift_throws(rule)
                {
                    continue;
                }
                let lost = self.grammar.lost(&[edge.category.meaning], category.meaning);
                let own = self.features.value(Feature::Rule(rule));
                let score = edge.score + own + f64::from(lost) * self.loss;
                let step = Step::Shift { rule, child };
                let split = start as u32;
                self.add(Found { category, made: Made::ByShift, score, step, split });
            }
        }
        self.chart.edges.append(&mut self.cell.edges);
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

impl<A: FnMut(&Grammar, (usize, usize), Category) -> bool> Cell<A> {
    /// Adds a derivation: a new edge, a better way to a known one, or another way, kept if there is a place for it.
    fn add(&mut self, grammar: &mut Grammar, others: Option<&mut Vec<(Step, u32)>>, found: Found) {
        let Found { category, made, score, step, split } = found;
        let Cell { span, edges, known, admit } = self;
        let place = *known.entry((category, made)).or_insert_with(|| {
            if !grammar.fits(category.meaning) || !admit(grammar, *span, category) {
                return NONE;
            }
            let throws = [0, 1].map(|after| grammar.throws(category.meaning, after));
            edges.push(Edge { category, made, score, step, throws, other: NONE, split });
            edges.len() as u32 - 1
        });
        let Some(edge) = edges.get_mut(place as usize) else { return };
        if edge.step == step {
            return;
        }
        let better = match score.total_cmp(&edge.score) {
            Ordering::Greater => true,
            Ordering::Less => false,
            Ordering::Equal => key(step, split) < key(edge.step, edge.split),
        };
        let worse = if better { edge.step } else { step };
        if better {
            (edge.score, edge.step, edge.split) = (score, step, split);
        }
        if let Some(others) = others {
            others.push((worse, edge.other));
            edge.other = others.len() as u32 - 1;
        }
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
