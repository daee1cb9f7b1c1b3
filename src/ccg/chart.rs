//! The CKY chart: edges over spans, each the best way to a category, kept within a beam. No result depends on
//! hash or insertion order: edges are ordered by score, then category; the derivations of one edge by rule row,
//! split, left and right.

use super::category::Category;
use super::clauses::Clauses;
use super::combinator::{Grammar, Made, RuleId};
use super::syntax::SyntaxId;
use crate::logic::order::sort_by_key;
use std::cmp::Ordering;

/// Which derivations of an edge a chart keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derivations {
    /// The best.
    Best,
    /// All, as long as the beam cuts nothing off ([`Chart::is_whole`]).
    Whole,
    /// All of the edges that the beam leaves, however bad.
    All,
}

/// What limits a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChartConfig {
    /// Edges kept per span.
    pub beam: usize,
    /// Derivations tried in all; beyond it the chart stays as it is and says so.
    pub budget: usize,
    /// Which derivations of an edge are kept.
    pub derivations: Derivations,
    /// Whether a functor may add nothing to its argument, as placeholders do.
    pub allow_vacuous: bool,
    /// Whether a functor or a shift may throw its argument away.
    pub allow_throwing: bool,
    /// The clauses, which are read one by one.
    pub clauses: Clauses,
    /// Whether a sentence may ask for a task over time.
    pub in_time: bool,
}

impl Default for ChartConfig {
    /// The paper's beam; a budget of a fraction of a second, so that whoever pumps a job is soon heard again.
    fn default() -> Self {
        ChartConfig {
            beam: 150,
            budget: 200_000,
            derivations: Derivations::Best,
            allow_vacuous: false,
            allow_throwing: false,
            clauses: Clauses::ONE,
            in_time: true,
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
    pub(super) throws: [bool; 2],
    /// The first of its other derivations, where they are kept.
    pub(super) other: u32,
    /// Where its best derivation splits the span, for ties.
    pub(super) split: u32,
}

pub(super) const NONE: u32 = u32::MAX;

/// The edges of one span, by syntax.
#[derive(Clone, Debug, Default)]
pub(super) struct Span {
    pub(super) edges: std::ops::Range<u32>,
    pub(super) groups: Vec<(SyntaxId, Vec<u32>)>,
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
    /// Whether the beam cut an edge off.
    pub(super) is_cut: bool,
    pub(super) edges: Vec<Edge>,
    pub(super) others: Vec<(Step, u32)>,
    pub(super) spans: Vec<Span>,
    pub(super) words: usize,
}

impl Edge {
    /// The order of the edges of a span, but for those that shifts made: by score, then category, then how they were
    /// made.
    pub(super) fn compare(&self, other: &Edge, grammar: &Grammar) -> Ordering {
        let score = other.score.total_cmp(&self.score);
        let Grammar { syntaxes, terms, .. } = grammar;
        score
            .then_with(|| self.category.compare(other.category, syntaxes, terms))
            .then_with(|| self.made.cmp(&other.made))
    }
}

impl Chart {
    /// A chart over so many words without edges, from these items.
    pub(super) fn new(words: usize, lexical: Vec<Lexical>) -> Self {
        Chart {
            lexical,
            over_budget: false,
            tried: 0,
            is_cut: false,
            edges: Vec::new(),
            others: Vec::new(),
            spans: vec![Span::default(); words * (words + 1)],
            words,
        }
    }

    /// Whether every edge that there can be is in it: which ones these are does not hang on the weights.
    pub fn is_whole(&self) -> bool {
        !self.is_cut && !self.over_budget
    }

    /// The edge behind an index.
    pub fn edge(&self, index: u32) -> &Edge {
        &self.edges[index as usize]
    }

    /// The edges over the whole sentence, best first.
    pub fn roots(&self) -> std::ops::Range<u32> {
        if self.words == 0 { 0..0 } else { self.at(0, self.words).edges.clone() }
    }

    /// All edges, with their spans.
    pub(super) fn all(&self) -> Vec<(usize, usize, u32)> {
        let places =
            (0..self.words).flat_map(|start| (start + 1..=self.words).map(move |end| (start, end)));
        let edges = places.flat_map(|(start, end)| {
            self.at(start, end).edges.clone().map(move |edge| (start, end, edge))
        });
        edges.collect()
    }

    /// The edges of each span that has more than a beam holds, in their order; those that shifts made are not counted.
    pub(super) fn crowds(&self, beam: usize) -> impl Iterator<Item = std::ops::Range<usize>> {
        let mut crowds: Vec<_> = self
            .spans
            .iter()
            .filter_map(|span| {
                let plain = |&edge: &u32| !self.edge(edge).made.is_shifted();
                let first = span.edges.start as usize;
                let edges = first..first + span.edges.clone().take_while(plain).count();
                (edges.len() > beam).then_some(edges)
            })
            .collect();
        sort_by_key(&mut crowds, |crowd| crowd.start);
        crowds.into_iter()
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

    /// The place of a span among [`Chart::spans`].
    pub(super) fn place(&self, start: usize, end: usize) -> usize {
        start * (self.words + 1) + end
    }

    fn at(&self, start: usize, end: usize) -> &Span {
        &self.spans[self.place(start, end)]
    }
}
