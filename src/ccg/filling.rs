//! Filling a chart, span after span. Where the beam is to leave few of many pairs of neighbours, those that can score
//! most are tried first, and no more once the rest cannot reach the beam (after Huang and Chiang 2005, exact because a
//! step adds nothing but the rule's weight and what it loses).

use super::category::Category;
use super::chart::{Chart, ChartConfig, Derivations, Edge, Lexical, NONE, Span, Step};
use super::combinator::{Grammar, Made, RuleId};
use super::features::{Feature, Features};
use super::reach::Reach;
use super::syntax::SyntaxId;
use crate::logic::order;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Edges kept of what clauses are put together to, where the beam is not narrower.
const JOINED: usize = 32;
/// Pairs after which it is asked whether the rest can reach the beam.
const PATIENCE: usize = 64;

/// Admits every edge: one for all who do, so that what fills a chart is compiled once for them.
pub(super) fn all_edges(_: &Grammar, _: (usize, usize), _: Category) -> bool {
    true
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
        let chart = Chart::new(words, lexical);
        let mut items = vec![Vec::new(); words * (words + 1)];
        for (index, item) in (0..).zip(&chart.lexical) {
            items[item.start * (words + 1) + item.end].push(index);
        }
        let loss = features.value(Feature::Lost);
        let given = chart.lexical.iter().map(|item| (item.start, item.end, item.category.syntax));
        let reach = Reach::new(grammar, words, &config, given);
        let cell = Cell { span: (0, 0), edges: Vec::new(), known: FxHashMap::default(), admit };
        let mut filling = Filling { chart, grammar, features, loss, config, items, reach, cell };
        for width in 1..=words {
            for start in 0..=words - width {
                filling.span(start, start + width);
            }
        }
        filling.chart
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

/// The pairs of neighbours that one rule combines at one place.
struct Grid {
    split: u32,
    rule: RuleId,
    syntax: SyntaxId,
    /// What the rule adds to a score.
    own: f64,
    left: Group,
    right: Group,
}

/// The edges of one syntax over a span, by their places in [`Chart::spans`].
#[derive(Clone, Copy)]
struct Group {
    span: usize,
    group: usize,
    len: usize,
}

/// A pair that is next in its row of a grid, the one that can score most first.
#[derive(PartialEq)]
struct Next {
    bound: f64,
    grid: usize,
    row: usize,
    column: usize,
}

impl Eq for Next {}

impl PartialOrd for Next {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Next {
    fn cmp(&self, other: &Self) -> Ordering {
        let place = |next: &Next| (next.grid, next.row, next.column);
        self.bound.total_cmp(&other.bound).then_with(|| place(other).cmp(&place(self)))
    }
}

impl<A: FnMut(&Grammar, (usize, usize), Category) -> bool> Filling<'_, A> {
    fn span(&mut self, start: usize, end: usize) {
        if !self.reach.is_open(start, end) {
            return;
        }
        let joined = self.config.clauses.part(start, end);
        let beam = if joined { self.config.beam.min(JOINED) } else { self.config.beam };
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
        let grids = self.grids(start, end);
        let pairs = grids.iter().map(|grid| grid.left.len * grid.right.len);
        let is_much = pairs.sum::<usize>() > beam;
        if is_much && self.loss <= 0.0 && self.config.derivations != Derivations::All {
            self.join_best(&grids, beam);
        } else {
            self.join(&grids);
        }
        let first = self.chart.edges.len() as u32;
        self.keep(beam);
        self.shift(first, start, end);
        self.store(first, start, end);
    }

    fn add(&mut self, found: Found) {
        let all = self.config.derivations != Derivations::Best;
        let others = all.then_some(&mut self.chart.others);
        self.cell.add(self.grammar, others, found);
    }

    /// Which neighbours can be put together, and how.
    fn grids(&mut self, start: usize, end: usize) -> Vec<Grid> {
        let Filling { chart, grammar, features, reach, .. } = self;
        let mut grids = Vec::new();
        for split in start + 1..end {
            let [left, right] = [(start, split), (split, end)].map(|(a, b)| chart.place(a, b));
            let groups = |span: usize| {
                let groups = chart.spans[span].groups.iter().enumerate();
                groups.map(move |(group, (syntax, edges))| {
                    (*syntax, Group { span, group, len: edges.len() })
                })
            };
            for (left_syntax, left) in groups(left) {
                for (right_syntax, right) in groups(right) {
                    for &(rule, syntax) in grammar.rows(left_syntax, right_syntax) {
                        if reach.is_useful(start, end, syntax) {
                            let own = features.value(Feature::Rule(rule));
                            grids.push(Grid {
                                split: split as u32,
                                rule,
                                syntax,
                                own,
                                left,
                                right,
                            });
                        }
                    }
                }
            }
        }
        grids
    }

    /// Puts all pairs of neighbours together.
    fn join(&mut self, grids: &[Grid]) {
        for grid in grids {
            for l in 0..grid.left.len {
                let left = self.member(grid.left, l);
                for r in 0..grid.right.len {
                    let right = self.member(grid.right, r);
                    if !self.put_together(grid, left, right) {
                        return;
                    }
                }
            }
        }
    }

    fn member(&self, Group { span, group, .. }: Group, place: usize) -> u32 {
        self.chart.spans[span].groups[group].1[place]
    }

    /// Puts pairs of neighbours together, those that can score most first, until the rest cannot reach the beam.
    fn join_best(&mut self, grids: &[Grid], beam: usize) {
        // What shifts made stands behind the rest of its group.
        let sorted = |chart: &Chart, group: Group| {
            let mut edges = chart.spans[group.span].groups[group.group].1.clone();
            let score = |edge: u32| chart.edges[edge as usize].score;
            order::sort_by(&mut edges, |&a, &b| score(b).total_cmp(&score(a)));
            edges
        };
        let sides: Vec<[Vec<u32>; 2]> = grids
            .iter()
            .map(|grid| [grid.left, grid.right].map(|group| sorted(&self.chart, group)))
            .collect();
        let next = |chart: &Chart, grid: usize, row: usize, column: usize| {
            let [lefts, rights] = &sides[grid];
            let (&left, &right) = (lefts.get(row)?, rights.get(column)?);
            let bound = chart.edge(left).score + chart.edge(right).score + grids[grid].own;
            Some(Next { bound, grid, row, column })
        };
        let first = (0..grids.len()).filter_map(|grid| next(&self.chart, grid, 0, 0));
        let mut open: BinaryHeap<Next> = first.collect();
        let mut seen = 0;
        while let Some(Next { bound, grid, row, column }) = open.pop() {
            seen += 1;
            if seen % PATIENCE == 0 && self.is_full(bound, beam) {
                self.chart.is_cut = true;
                return;
            }
            let [lefts, rights] = &sides[grid];
            if !self.put_together(&grids[grid], lefts[row], rights[column]) {
                return;
            }
            open.extend(next(&self.chart, grid, row, column + 1));
            if column == 0 {
                open.extend(next(&self.chart, grid, row + 1, 0));
            }
        }
    }

    /// Whether the beam is full of what scores more.
    fn is_full(&self, score: f64, beam: usize) -> bool {
        let edges = &self.cell.edges;
        edges.len() >= beam && edges.iter().filter(|edge| edge.score > score).count() >= beam
    }

    /// Puts two neighbours together, if the rule admits them; `false` when the budget is spent.
    fn put_together(&mut self, grid: &Grid, l: u32, r: u32) -> bool {
        let Filling { chart, grammar, loss, config, cell, .. } = self;
        let (left, right) = (chart.edges[l as usize], chart.edges[r as usize]);
        let Grid { split, rule, syntax, own, .. } = *grid;
        if !rule.admits(left.made, right.made)
            || right.made == Made::ByShift && grammar.syntaxes.forbids_along(left.category.syntax)
            || !config.allow_throwing && rule.throws(left.throws, right.throws)
        {
            return true;
        }
        if chart.tried >= config.budget {
            chart.over_budget = true;
            return false;
        }
        chart.tried += 1;
        let (f, g) = (left.category.meaning, right.category.meaning);
        let Some(meaning) = grammar.combine(rule, f, g, config.allow_vacuous) else { return true };
        let lost = f64::from(grammar.lost(&[f, g], meaning));
        let found = Found {
            category: Category { syntax, meaning },
            made: rule.makes(),
            score: left.score + right.score + own + lost * *loss,
            step: Step::Binary { rule, left: l, right: r },
            split,
        };
        let all = config.derivations != Derivations::Best;
        cell.add(grammar, all.then_some(&mut chart.others), found);
        true
    }

    /// Orders the cell and moves what the beam holds into the chart.
    fn keep(&mut self, beam: usize) {
        let grammar = &*self.grammar;
        let order = |x: &Edge, y: &Edge| x.compare(y, grammar);
        let edges = &mut self.cell.edges;
        if edges.len() > beam {
            self.chart.is_cut = true;
            edges.select_nth_unstable_by(beam, order);
            edges.truncate(beam);
        }
        edges.sort_unstable_by(order);
        self.chart.edges.append(edges);
    }

    /// Shifts what was kept: what comes out stands behind it, beyond the beam. Nothing is shifted twice, but that what
    /// comes out as a command may be made a clause of time.
    fn shift(&mut self, first: u32, start: usize, end: usize) {
        for late in [false, true] {
            self.cell.known.clear();
            let mut known: Vec<(SyntaxId, Vec<(RuleId, SyntaxId)>)> = Vec::new();
            for child in first..self.chart.edges.len() as u32 {
                let from = self.chart.edge(child).category.syntax;
                let place = known.iter().position(|(syntax, _)| *syntax == from);
                let place = place.unwrap_or_else(|| {
                    known.push((from, self.shifts(from, (start, end), late)));
                    known.len() - 1
                });
                let edge = *self.chart.edge(child);
                for &(rule, syntax) in &known[place].1 {
                    let made = self.grammar.shift_makes(rule, edge.made);
                    self.shift_edge((child, edge), (rule, syntax), made, start as u32);
                }
            }
            self.chart.edges.append(&mut self.cell.edges);
        }
    }

    /// The shifts of a syntactic category that lead to something over a span.
    fn shifts(
        &self,
        from: SyntaxId,
        (start, end): (usize, usize),
        late: bool,
    ) -> Vec<(RuleId, SyntaxId)> {
        let Filling { grammar, reach, config, .. } = self;
        let leads = |&(rule, syntax): &(RuleId, SyntaxId)| {
            reach.is_useful(start, end, syntax)
                && (config.allow_throwing || !grammar.shift_throws(rule))
        };
        grammar.shifts_of(from, late).filter(leads).collect()
    }

    fn shift_edge(
        &mut self,
        (child, edge): (u32, Edge),
        (rule, syntax): (RuleId, SyntaxId),
        made: Made,
        split: u32,
    ) {
        let part = edge.category.meaning;
        let Some(meaning) = self.grammar.meaning(rule, &[part]) else { return };
        let own = self.features.value(Feature::Rule(rule));
        let score = edge.score + own + f64::from(self.grammar.lost(&[part], meaning)) * self.loss;
        let (category, step) = (Category { syntax, meaning }, Step::Shift { rule, child });
        self.add(Found { category, made, score, step, split });
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
