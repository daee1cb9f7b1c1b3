//! Idioms: whole-sentence entries (after Kwiatkowski et al. 2010, last instead of first). After training, a command whose
//! answer explains fewer of its own rows than a goal that other commands were found to mean becomes one entry, heard only
//! when nothing else is said. Goals that deny something are no idioms, since they win by being weak, and no command with
//! a closed word becomes one.

use super::kept::Kept;
use super::planning::Validation;
use crate::ccg::{ChartConfig, Features, Model, any_closed, parse_words};
use crate::ground::PairId;
use crate::logic::{Node, TermId, Terms, print, read};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// Goals that are tried, those that explain most rows first.
const MOST_GOALS: usize = 400;

/// The facts of a checkpoint that say how far the search is.
pub(super) const SEARCH: [&str; 3] = ["at_idioms", "at_meant", "at_found"];

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
    /// The idioms so far: the place of a command, and its goal.
    found: Vec<(usize, TermId)>,
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

    /// The idioms found so far: places of commands, and their goals.
    pub(super) fn found(&self) -> &[(usize, TermId)] {
        &self.found
    }

    /// How far the search is, as facts of a checkpoint, in the order of [`SEARCH`].
    pub(super) fn place(&self, terms: &Terms) -> [String; 3] {
        let goals = |all: &mut dyn Iterator<Item = (usize, TermId)>| {
            let goal = |(n, goal): (usize, TermId)| format!("{n} {}", print(terms, goal));
            all.map(goal).collect::<Vec<_>>().join("|")
        };
        let numbers = std::iter::once(&self.next).chain(&self.explained);
        let numbers: Vec<String> = numbers.map(usize::to_string).collect();
        let mut meant = self.meant.iter().map(|(&goal, &rows)| (rows, goal));
        let mut found = self.found.iter().copied();
        [numbers.join(" "), goals(&mut meant), goals(&mut found)]
    }

    /// Goes on where a checkpoint of a search among so many commands was made; nothing if it was made of none.
    pub(super) fn resumed(
        mut self,
        place: [&str; 3],
        commands: usize,
        terms: &mut Terms,
    ) -> Option<Self> {
        let mut goals = |text: &str| -> Option<Vec<(usize, TermId)>> {
            let parts = text.split('|').filter(|part| !part.is_empty());
            let goal = |part: &str| {
                let (n, form) = part.split_once(' ')?;
                Some((n.parse().ok()?, read(terms, form).ok()?))
            };
            parts.map(goal).collect()
        };
        let [numbers, meant, found] = place;
        let numbers = numbers.split(' ').map(|n| n.parse().ok()).collect::<Option<Vec<usize>>>()?;
        self.meant = goals(meant)?.into_iter().map(|(rows, goal)| (goal, rows)).collect();
        self.found = goals(found)?;
        let (next, explained) = numbers.split_first()?;
        (self.next, self.explained) = (*next, explained.to_vec());
        let fits = self.explained.len() <= commands
            && (self.next == 0 || self.explained.len() == commands && self.next <= commands)
            && self.found.iter().all(|(at, _)| *at < commands);
        if self.next > 0 {
            self.rank(terms);
        }
        fits.then_some(self)
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
        let at = self.next;
        let mut most = self.explained.get(at).copied().unwrap_or_default();
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
        self.found.extend(idiom.map(|goal| (at, goal)));
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
