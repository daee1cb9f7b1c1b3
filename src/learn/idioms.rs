//! Idioms: whole-sentence entries (after Kwiatkowski et al. 2010, last instead of first). After training, a command whose
//! answer explains fewer of its own rows than a goal that other commands were found to mean becomes one entry, heard only
//! when nothing else is said. Goals that deny something are no idioms, since they win by being weak, and no command with
//! a closed word becomes one.

use super::planning::Validation;
use crate::ccg::{ChartConfig, Model, any_closed, parse_words};
use crate::ground::PairId;
use crate::logic::{Node, TermId, Terms, print};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// Goals that are tried, those that explain most rows first.
const MOST_GOALS: usize = 400;

/// A command with the demonstrations of each row that has it.
pub(super) struct Command<'a> {
    pub(super) words: &'a [String],
    pub(super) rows: &'a [Vec<PairId>],
}

/// The search for idioms. Every step looks at one command, first at what it is answered, then at what it could mean.
pub(super) struct Idioms {
    model: Model,
    /// For every command, how many of its rows its answer explains.
    explained: Vec<usize>,
    /// Goals that commands were found to mean, with the rows that they explain there.
    found: IndexMap<TermId, usize, FxBuildHasher>,
    /// The goals that are tried, once all answers are known.
    goals: Vec<TermId>,
    next: usize,
}

impl Idioms {
    /// A search with a model that has been trained.
    pub(super) fn new(model: Model) -> Self {
        let found = IndexMap::default();
        Idioms { model, explained: Vec::new(), found, goals: Vec::new(), next: 0 }
    }

    /// How many commands were looked at, each once for its answer and once for other goals.
    pub(super) fn seen(&self) -> usize {
        self.explained.len() + self.next
    }

    /// The model with the idioms found so far.
    pub(super) fn model(&self) -> &Model {
        &self.model
    }

    /// What a command is answered, and how many of its rows that explains.
    pub(super) fn answer(&mut self, command: &Command<'_>, validation: &mut Validation) {
        let config = ChartConfig::of(&self.model);
        let parse = parse_words(&mut self.model, command.words.to_vec(), config);
        let answer = parse.answer().map(|reading| reading.form);
        let rows = answer.map_or(0, |form| self.explains(form, command, validation));
        self.explained.push(rows);
        if let Some(form) = answer.filter(|_| rows > 0)
            && !denies(&self.model.grammar.terms, form)
        {
            *self.found.entry(form).or_default() += rows;
        }
    }

    /// Looks for a goal that explains more of a command's rows than its answer does.
    pub(super) fn search(&mut self, command: &Command<'_>, validation: &mut Validation) {
        if self.next == 0 {
            self.rank();
        }
        let mut most = self.explained.get(self.next).copied().unwrap_or_default();
        self.next += 1;
        if most == command.rows.len() || command.words.is_empty() || any_closed(command.words) {
            return;
        }
        let mut idiom = None;
        for place in 0..self.goals.len() {
            let goal = self.goals[place];
            let rows = self.explains(goal, command, validation);
            if rows > most && 2 * rows > command.rows.len() {
                (most, idiom) = (rows, Some(goal));
            }
        }
        if let Some(goal) = idiom {
            // A goal that a chart has made is never too large.
            let _ = self.model.add_idiom(command.words, goal);
        }
    }

    fn explains(&self, form: TermId, command: &Command<'_>, validation: &mut Validation) -> usize {
        let terms = &self.model.grammar.terms;
        command.rows.iter().filter(|row| validation.valid(terms, form, row)).count()
    }

    /// The goals to try: those that explain most first, ties by their printed forms.
    fn rank(&mut self) {
        let terms = &self.model.grammar.terms;
        let mut goals: Vec<(usize, String, TermId)> =
            self.found.iter().map(|(&goal, &rows)| (rows, print(terms, goal), goal)).collect();
        goals.sort_by(|a, b| b.0.cmp(&a.0).then_with(|| a.1.cmp(&b.1)));
        self.goals = goals.into_iter().take(MOST_GOALS).map(|(_, _, goal)| goal).collect();
    }
}

/// Whether a term denies anything.
fn denies(terms: &Terms, term: TermId) -> bool {
    match terms.node(term) {
        Node::Constant(constant) => terms.name(constant) == "not",
        Node::Variable(_) => false,
        Node::Lambda { body, .. } => denies(terms, body),
        Node::Apply { head, args } => {
            denies(terms, head) || args.iter().any(|&arg| denies(terms, arg))
        }
    }
}
