//! What a chart found, kept for the next time: while the lexicon says the same of a sentence, only the weights can have
//! changed, and then one walk over the derivations that lead to goals gives what a new chart would, to the last bit.
//! Invariant: it comes of a chart that neither beam nor budget cut ([`Chart::is_whole`]), since which edges there are
//! then does not hang on the weights. What a beam would leave of them does: it is worked out with the scores.

use super::chart::{Chart, Edge, Lexical, Step};
use super::combinator::{Grammar, RuleId};
use super::derivation::Derivation;
use super::features::{Feature, Features, Vector};
use super::goals::{Goal, Goals};
use super::lexicon::EntryId;
use super::model::Model;
use super::parse::{Reading, is_goal, rank, ranked};
use super::syntax::SyntaxId;
use crate::logic::{TermId, order};
use std::cmp::Ordering;
use std::rc::Rc;

/// The derivations of all goals of a sentence.
#[derive(Debug)]
pub struct Forest {
    /// Edges and lexical items, as far as goals are made of them. Parts stand before what is made of them.
    chart: Chart,
    /// The place of each lexical item among those that the chart was given.
    items: Vec<u32>,
    /// Every derivation of every edge.
    ways: Vec<Way>,
    /// One past each edge's derivations.
    ends: Vec<u32>,
    tops: Vec<Top>,
    beam: usize,
    /// The edges of spans of which the beam may leave some, but for those that shifts made.
    crowds: Vec<std::ops::Range<usize>>,
    /// Whether the beam left an edge, and all that one of its derivations is made of.
    alive: Vec<bool>,
}

/// A derivation.
#[derive(Clone, Copy, Debug)]
struct Way {
    step: Step,
    split: u32,
    /// Predicates that it loses.
    lost: u32,
}

/// An edge that means a goal.
#[derive(Debug)]
struct Top {
    edge: u32,
    /// What it means, once asked for: the beam may never leave it.
    goal: Option<Rc<Goal>>,
    /// φ of its best derivation, once asked for.
    vector: Option<Rc<Vector>>,
}

impl Forest {
    /// The forest of a whole chart that keeps all derivations, for a beam. It must be scored before it is read.
    pub fn of(grammar: &Grammar, chart: &Chart, beam: usize) -> Self {
        let mut roots: Vec<u32> = chart.roots().collect();
        roots.retain(|&root| is_goal(grammar, chart.edge(root)));
        let crowds: Vec<_> = chart.crowds(beam).collect();
        // What leads to no goal takes its place in the beam all the same.
        let mut below = match crowds.is_empty() {
            true => chart.below(roots.iter().copied()),
            false => chart.all(),
        };
        below.sort_unstable_by_key(|&(.., edge)| edge);
        let place = |edge: u32| {
            below.binary_search_by_key(&edge, |&(.., edge)| edge).unwrap_or(usize::MAX) as u32
        };
        let mut kept = Chart::new(0, Vec::new());
        let (mut items, mut ways, mut ends) = (Vec::new(), Vec::new(), Vec::new());
        for &(start, _, index) in &below {
            let edge = *chart.edge(index);
            for step in chart.steps(index) {
                let lost = |parts: &[u32]| {
                    let meaning = |&part: &u32| chart.edge(part).category.meaning;
                    let parts: Vec<TermId> = parts.iter().map(meaning).collect();
                    grammar.lost(&parts, edge.category.meaning)
                };
                ways.push(match step {
                    Step::Lexical(item) => {
                        items.push(item);
                        Way { step, split: start as u32, lost: 0 }
                    }
                    Step::Binary { rule, left, right } => {
                        let lost = lost(&[left, right]);
                        let (left, right) = (place(left), place(right));
                        let split = below.get(left as usize).map_or(0, |&(_, split, _)| split);
                        Way { step: Step::Binary { rule, left, right }, split: split as u32, lost }
                    }
                    Step::Shift { rule, child } => {
                        let lost = lost(&[child]);
                        let step = Step::Shift { rule, child: place(child) };
                        Way { step, split: start as u32, lost }
                    }
                });
            }
            kept.edges.push(edge);
            ends.push(ways.len() as u32);
        }
        items.sort_unstable();
        kept.lexical = items.iter().map(|&item| chart.lexical[item as usize]).collect();
        for way in &mut ways {
            if let Step::Lexical(item) = &mut way.step {
                *item = items.binary_search(item).unwrap_or(usize::MAX) as u32;
            }
        }
        // What the chart gave as the best derivation stands first.
        let mut first = 0;
        for (edge, &end) in kept.edges.iter_mut().zip(&ends) {
            edge.step = ways[first].step;
            first = end as usize;
        }
        let top = |root| Top { edge: place(root), goal: None, vector: None };
        let tops = roots.into_iter().map(top).collect();
        let alive = vec![false; ends.len()];
        Forest { chart: kept, items, ways, ends, tops, beam, crowds, alive }
    }

    /// Edges and derivations: what it takes to keep it.
    pub fn size(&self) -> usize {
        self.ends.len() + self.ways.len()
    }

    /// Scores everything anew, with the items that a chart would be given now: the same with other scores.
    pub fn rescore(&mut self, grammar: &Grammar, features: &Features, lexical: &[Lexical]) {
        for (own, &item) in self.chart.lexical.iter_mut().zip(&self.items) {
            own.score = lexical[item as usize].score;
        }
        let loss = features.value(Feature::Lost);
        let rules: Vec<f64> =
            grammar.rules().map(|rule| features.value(Feature::Rule(rule))).collect();
        let own = |rule: RuleId| rules[usize::from(rule.0)];
        // Whether the best derivation of an edge is another than before.
        let mut changed = vec![false; self.ends.len()];
        let mut start = 0;
        let mut crowds = 0;
        for at in 0..self.ends.len() {
            if self.crowds.get(crowds).is_some_and(|crowd| crowd.end == at) {
                self.thin_out(grammar, crowds);
                crowds += 1;
            }
            let end = self.ends[at] as usize;
            let mut best: Option<(f64, Way)> = None;
            for &way in &self.ways[start..end] {
                let edges = &self.chart.edges;
                let lost = f64::from(way.lost);
                let is_open = match way.step {
                    Step::Lexical(_) => true,
                    Step::Binary { left, right, .. } => {
                        self.alive[left as usize] && self.alive[right as usize]
                    }
                    Step::Shift { child, .. } => self.alive[child as usize],
                };
                if !is_open {
                    continue;
                }
                let score = match way.step {
                    Step::Lexical(item) => self.chart.lexical[item as usize].score,
                    Step::Binary { rule, left, right } => {
                        let (left, right) = (&edges[left as usize], &edges[right as usize]);
                        left.score + right.score + own(rule) + lost * loss
                    }
                    Step::Shift { rule, child } => {
                        edges[child as usize].score + own(rule) + lost * loss
                    }
                };
                let is_better = best.is_none_or(|(most, other)| {
                    let order = score.total_cmp(&most);
                    order.then_with(|| self.compare_ways(grammar, other, way)).is_gt()
                });
                if is_better {
                    best = Some((score, way));
                }
            }
            start = end;
            let was_alive = std::mem::replace(&mut self.alive[at], best.is_some());
            if let Some((score, Way { step, split, .. })) = best {
                let of = |part: u32| changed[part as usize];
                let is_new = !was_alive || step != self.chart.edges[at].step;
                changed[at] = is_new
                    || match step {
                        Step::Lexical(_) => false,
                        Step::Binary { left, right, .. } => of(left) || of(right),
                        Step::Shift { child, .. } => of(child),
                    };
                let edge = &mut self.chart.edges[at];
                (edge.score, edge.step, edge.split) = (score, step, split);
            }
        }
        if crowds < self.crowds.len() {
            self.thin_out(grammar, crowds);
        }
        for top in &mut self.tops {
            if changed[top.edge as usize] || !self.alive[top.edge as usize] {
                top.vector = None;
            }
        }
    }

    /// Leaves of the edges of a span what the beam holds.
    fn thin_out(&mut self, grammar: &Grammar, crowd: usize) {
        let mut edges: Vec<u32> =
            self.crowds[crowd].clone().filter(|&at| self.alive[at]).map(|at| at as u32).collect();
        if edges.len() > self.beam {
            let order =
                |a: &u32, b: &u32| self.chart.edge(*a).compare(self.chart.edge(*b), grammar);
            edges.select_nth_unstable_by(self.beam, order);
            edges[self.beam..].iter().for_each(|&edge| self.alive[edge as usize] = false);
        }
    }

    /// The distinct goals, ranked.
    pub fn readings(&mut self, model: &mut Model, goals: &mut Goals) -> Vec<Reading> {
        let Model { grammar, features, .. } = model;
        for top in self.tops.iter_mut().filter(|top| self.alive[top.edge as usize]) {
            let meaning = self.chart.edge(top.edge).category.meaning;
            top.goal.get_or_insert_with(|| goals.get(grammar, meaning));
        }
        let is_alive = |top: &&Top| self.alive[top.edge as usize];
        let mut tops: Vec<&Top> = self.tops.iter().filter(is_alive).collect();
        order::sort_by(&mut tops, |a, b| self.compare_edges(grammar, a.edge, b.edge));
        let found = tops.into_iter().filter_map(|Top { edge, goal, .. }| {
            let goal = goal.as_ref()?;
            let score = goal.scored(features, self.chart.edge(*edge).score);
            Some((score, Rc::clone(goal), *edge))
        });
        ranked(&grammar.terms, found)
    }

    /// The one best of the readings; `None` where there is none, or several share the best rank.
    pub fn answer(readings: &[Reading]) -> Option<TermId> {
        match readings {
            [first, second, ..] if rank(first.score) == rank(second.score) => None,
            [first, ..] => Some(first.form),
            [] => None,
        }
    }

    /// The distinct goals, ranked, each with φ of its best derivation; words and those that mean nothing, as heard.
    pub fn vectors(
        &mut self,
        model: &mut Model,
        goals: &mut Goals,
        words: &[String],
        empty: &[Option<EntryId>],
    ) -> Vec<(TermId, Rc<Vector>)> {
        let ranked = self.readings(model, goals);
        let mut readings = Vec::with_capacity(ranked.len());
        for Reading { form, edge, .. } in ranked {
            let Some(top) = self.tops.iter_mut().find(|top| top.edge == edge) else { continue };
            let known = top.vector.clone();
            let vector = known.unwrap_or_else(|| {
                let derivation = Derivation::of(&self.chart, edge, &EntryId::from_item);
                let root = top.goal.as_ref().map_or(Vec::new(), |goal| goal.features.clone());
                let occurring = derivation.features_besides(model, root, words, empty);
                Rc::new(model.features.vector(&occurring))
            });
            top.vector = Some(Rc::clone(&vector));
            readings.push((form, vector));
        }
        readings
    }

    /// The order of derivations of one edge that score alike, as a chart has it.
    fn compare_ways(&self, grammar: &Grammar, a: Way, b: Way) -> Ordering {
        let key = |way: Way| match way.step {
            Step::Binary { rule, .. } | Step::Shift { rule, .. } => (rule.0, way.split),
            Step::Lexical(_) => (u8::MAX, way.split),
        };
        key(a).cmp(&key(b)).then_with(|| match (a.step, b.step) {
            (Step::Lexical(a), Step::Lexical(b)) => a.cmp(&b),
            (Step::Shift { child: a, .. }, Step::Shift { child: b, .. }) => {
                self.compare_edges(grammar, a, b)
            }
            (Step::Binary { left, right, .. }, Step::Binary { left: l, right: r, .. }) => {
                let order = self.compare_edges(grammar, left, l);
                order.then_with(|| self.compare_edges(grammar, right, r))
            }
            _ => Ordering::Equal,
        })
    }

    /// The order of two edges over the same span, as a chart has it: what shifts made stands behind the rest, in the
    /// order in which they come upon it, clauses of time last.
    fn compare_edges(&self, grammar: &Grammar, a: u32, b: u32) -> Ordering {
        let (x, y) = (self.chart.edge(a), self.chart.edge(b));
        let is_late = |edge: &Edge| edge.category.syntax == SyntaxId::T;
        match (x.made.is_shifted(), y.made.is_shifted()) {
            _ if a == b => Ordering::Equal,
            (true, true) if is_late(x) != is_late(y) => is_late(x).cmp(&is_late(y)),
            (false, false) => x.compare(y, grammar),
            (true, true) => {
                let first = |edge: u32| {
                    let children = self.shifted(edge);
                    children.min_by(|&a, &b| self.compare_children(grammar, a, b))
                };
                match (first(a), first(b)) {
                    (Some(a), Some(b)) => self.compare_children(grammar, a, b),
                    (a, b) => b.is_some().cmp(&a.is_some()),
                }
            }
            (x, y) => x.cmp(&y),
        }
    }

    /// What an edge is shifted from, and how.
    fn shifted(&self, edge: u32) -> impl Iterator<Item = (u32, RuleId)> {
        let at = edge as usize;
        let start = at.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        self.ways[start..self.ends[at] as usize].iter().filter_map(|way| match way.step {
            Step::Shift { rule, child } if self.alive[child as usize] => Some((child, rule)),
            _ => None,
        })
    }

    fn compare_children(&self, grammar: &Grammar, a: (u32, RuleId), b: (u32, RuleId)) -> Ordering {
        self.compare_edges(grammar, a.0, b.0).then_with(|| a.1.cmp(&b.1))
    }
}
