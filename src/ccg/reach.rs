//! Which syntactic categories can take part in a full parse of a sentence: an exact first pass over syntax alone
//! (coarse to fine, after Charniak et al. 2006), so that the chart builds no meaning that leads nowhere. The
//! normal form is not asked here: it only takes away.

use super::chart::ChartConfig;
use super::clauses::Clauses;
use super::combinator::Grammar;
use super::syntax::SyntaxId;

/// For every span the categories that some full parse may use there.
pub(super) struct Reach {
    spans: Vec<Vec<Node>>,
    words: usize,
    clauses: Clauses,
    in_time: bool,
}

/// A category over a span.
struct Node {
    syntax: SyntaxId,
    /// Whether a sentence can come of it.
    useful: bool,
    /// Whether it comes about otherwise than by a shift.
    plain: bool,
    ways: Vec<Way>,
}

/// How a category comes about: the places of its parts in their spans.
#[derive(Clone, Copy)]
enum Way {
    Join { split: usize, left: usize, right: usize },
    Shift { child: usize },
}

impl Reach {
    /// The pass over a sentence of `words` words; `lexical` has the categories that the lexicon gives, each with its
    /// span's first word and one past the last.
    pub(super) fn new(
        grammar: &mut Grammar,
        words: usize,
        config: &ChartConfig,
        lexical: impl Iterator<Item = (usize, usize, SyntaxId)>,
    ) -> Self {
        let spans = (0..words * (words + 1)).map(|_| Vec::new()).collect();
        let ChartConfig { clauses, in_time, .. } = *config;
        let mut reach = Reach { spans, words, clauses: clauses.with(words), in_time };
        for (start, end, syntax) in lexical {
            let is_of_time = grammar.syntaxes.is_in_time(syntax);
            if !reach.clauses.admit(start, end) || is_of_time && !in_time {
                continue;
            }
            let at = reach.at(start, end);
            place(&mut reach.spans[at], syntax).plain = true;
        }
        for width in 1..=words {
            for start in 0..=words - width {
                if reach.clauses.admit(start, start + width) {
                    reach.fill(grammar, start, start + width);
                }
            }
        }
        if words > 0 {
            let top = &reach.spans[reach.at(0, words)];
            // A command that was made a clause of time is no more than a command.
            let is_root = |&root: &usize| {
                let Node { syntax, plain, .. } = top[root];
                syntax.is_sentence() && (plain || syntax != SyntaxId::T)
            };
            let roots: Vec<usize> = (0..top.len()).filter(is_root).collect();
            roots.into_iter().for_each(|root| reach.mark(root));
        }
        reach
    }

    /// Whether a full parse may use the category over the span.
    pub(super) fn is_useful(&self, start: usize, end: usize, syntax: SyntaxId) -> bool {
        self.spans[self.at(start, end)].iter().any(|node| node.useful && node.syntax == syntax)
    }

    /// Whether a full parse may use anything over the span.
    pub(super) fn is_open(&self, start: usize, end: usize) -> bool {
        self.spans[self.at(start, end)].iter().any(|node| node.useful)
    }

    fn at(&self, start: usize, end: usize) -> usize {
        start * (self.words + 1) + end
    }

    fn fill(&mut self, grammar: &mut Grammar, start: usize, end: usize) {
        let at = self.at(start, end);
        let mut cell = std::mem::take(&mut self.spans[at]);
        for split in start + 1..end {
            let (lefts, rights) =
                (&self.spans[self.at(start, split)], &self.spans[self.at(split, end)]);
            for (left, l) in lefts.iter().enumerate() {
                for (right, r) in rights.iter().enumerate() {
                    for &(_, syntax) in grammar.rows(l.syntax, r.syntax) {
                        let node = place(&mut cell, syntax);
                        node.plain = true;
                        node.ways.push(Way::Join { split, left, right });
                    }
                }
            }
        }
        for late in [false, true].into_iter().filter(|late| self.in_time || !late) {
            for child in 0..cell.len() {
                let from = cell[child].syntax;
                for (_, syntax) in grammar.shifts_of(from, late) {
                    place(&mut cell, syntax).ways.push(Way::Shift { child });
                }
            }
        }
        self.spans[at] = cell;
    }

    /// Marks everything that a full parse can be made of.
    fn mark(&mut self, root: usize) {
        let mut open = vec![(0, self.words, root)];
        while let Some((start, end, place)) = open.pop() {
            let at = self.at(start, end);
            let node = &mut self.spans[at][place];
            if std::mem::replace(&mut node.useful, true) {
                continue;
            }
            for &way in &node.ways {
                match way {
                    Way::Shift { child } => open.push((start, end, child)),
                    Way::Join { split, left, right } => {
                        open.extend([(start, split, left), (split, end, right)]);
                    }
                }
            }
        }
    }
}

/// The node of a category in a cell.
fn place(cell: &mut Vec<Node>, syntax: SyntaxId) -> &mut Node {
    let known = cell.iter().position(|node| node.syntax == syntax);
    let at = known.unwrap_or_else(|| {
        cell.push(Node { syntax, useful: false, plain: false, ways: Vec::new() });
        cell.len() - 1
    });
    &mut cell[at]
}
