//! Idioms: whole-sentence entries (after Kwiatkowski et al. 2010, last instead of first). After training, a command whose
//! answer explains fewer of its own rows than a goal that other commands were found to mean becomes one entry, heard only
//! when nothing else is said. Goals that deny something are no idioms, since they win by being weak, and no command with
//! a closed word becomes one.

use super::kept::Kept;
use super::planning::Validation;
use crate::ccg::{ChartConfig, Features, Model, any_closed, parse_words};
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
    /// The weights that answers are given with: those that training ends with.
    features: Features,
    /// For every command, how many of its rows its answer explains.
    explained: Vec<usize>,
    /// Goals that commands were found to mean, with the rows that they explain there.
    meant: IndexMap<TermId, usize, FxBuildHasher>,
    /// The goals that are tried, once all answers are known.
    goals: Vec<TermId>,
    next: usize,
    /// The idioms so far.
    found: Vec<(Vec<String>, TermId)>,
}

impl Idioms {
    /// A search with such weights.
    pub(super) fn new(features: Features) -> Self {
        Idioms {
            features,
            explained: Vec::new(),
            meant: IndexMap::default(),
            goals: Vec::new(),
            next: 0,
            found: Vec::new(),
        }
    }

    /// How many commands were looked at, each once for its answer and once for other goals.
    pub(super) fn seen(&self) -> usize {
        self.explained.len() + self.next
    }

    /// The idioms found so far.
    pub(super) fn found(&self) -> &[(Vec<String>, TermId)] {
        &self.found
    }

    /// What a command is answered, and how many of its rows that explains.
    pub(super) fn answer(
        &mut self,
        (at, command): (usize, &Command<'_>),
        model: &mut Model,
        kept: &mut Kept,
        validation: &mut Validation,
    ) {
        std::mem::swap(&mut model.features, &mut self.features);
        let answer = kept.answer(at, model).unwrap_or_else(|| {
            let config = ChartConfig::of(model);
            let parse = parse_words(model, command.words.to_vec(), config);
            parse.answer().map(|reading| reading.form)
        });
        std::mem::swap(&mut model.features, &mut self.features);
        let terms = &model.grammar.terms;
        let rows = answer.map_or(0, |form| explains(terms, form, command, validation));
        self.explained.push(rows);
        if let Some(form) = answer.filter(|&form| rows > 0 && !denies(terms, form)) {
            *self.meant.entry(form).or_default() += rows;
        }
    }

    /// Looks for a goal that explains more of a command's rows than its answer does.
    pub(super) fn search(
        &mut self,
        command: &Command<'_>,
        terms: &Terms,
        validation: &mut Validation,
    ) {
        if self.next == 0 {
            self.rank(terms);
        }
        let mut most = self.explained.get(self.next).copied().unwrap_or_default();
        self.next += 1;
        if most == command.rows.len() || command.words.is_empty() || any_closed(command.words) {
            return;
        }
        let mut idiom = None;
        for &goal in &self.goals {
            let rows = explains(terms, goal, command, validation);
            if rows > most && 2 * rows > command.rows.len() {
                (most, idiom) = (rows, Some(goal));
            }
        }
        self.found.extend(idiom.map(|goal| (command.words.to_vec(), goal)));
    }

    /// The goals to try: those that explain most first, ties by their printed forms.
    fn rank(&mut self, terms: &Terms) {
        let mut goals: Vec<(usize, String, TermId)> =
            self.meant.iter().map(|(&goal, &rows)| (rows, print(terms, goal), goal)).collect();
        goals.sort_by(|a, b| b.0.cmp(&a.0).then_with(|| a.1.cmp(&b.1)));
        self.goals = goals.into_iter().take(MOST_GOALS).map(|(_, _, goal)| goal).collect();
    }
}

fn explains(
    terms: &Terms,
    form: TermId,
    command: &Command<'_>,
    validation: &mut Validation,
) -> usize {
    command.rows.iter().filter(|row| validation.valid(terms, form, row)).count()
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
