//! Demonstrations for a study: a seeded world that fulfils what a task asks of it, and the end of a shortest plan to
//! its goal in which only what the command says to move is moved. Each pair is checked by the goal evaluator, and
//! together they are drawn so that a nearby reading (another task's goal, or one that the task is unlike) does not
//! explain them all. A task over time is shown by the whole run (see `runs`). Invariant: a pure function of tasks, name, number of pairs and seed.

use super::runs;
use super::tasks::StudyTask;
use super::world::world;
use crate::corpus::Pair;
use crate::domain::{Movable, Rules, State, Way};
use crate::ground::{Entity, Goal, Task, Validator, lesser};
use crate::logic::ty::RUN;
use crate::logic::{TermId, Terms, print, read};
use crate::mdp::{Budget, Outcome, Settings, Solver};
use crate::plan::AStar;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// Worlds that are tried for one pair.
const TRIES: usize = 600;
/// Fitting worlds among which the one is chosen that disproves most.
const CANDIDATES: usize = 60;
/// As many are enough when one of them leaves open nothing that the task says it is unlike.
const ENOUGH: usize = 12;
/// Fewest and most actions between before and after: something is to be seen, and to be followed.
const ACTIONS: std::ops::RangeInclusive<usize> = 2..=60;
/// Objects out of the way: enough for any world of a task.
const BUDGET: Budget = Budget { steps: 20_000, states: 200_000 };

/// The pairs of a task.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// As many as were asked for.
    pub pairs: Vec<Pair>,
    /// Readings that the pairs leave open beside the task's own goal: other tasks by name, others by form.
    pub open: Vec<String>,
}

/// Why there are no pairs.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DrawError {
    /// A form or a name that reading the file would have refused.
    #[error("task `{task}`: {message}")]
    BadTask {
        /// Its name.
        task: String,
        /// What is wrong.
        message: String,
    },
    /// No world fulfils what the task asks.
    #[error("task `{task}`: none of {TRIES} worlds will do; the last one failed because {why}")]
    NoWorld {
        /// Its name.
        task: String,
        /// What was wrong with the last world.
        why: &'static str,
    },
}

/// Pairs for a task, being drawn.
#[derive(Debug)]
pub struct Drawing {
    task: StudyTask,
    terms: Terms,
    forms: Forms,
    /// Readings that the pairs so far do not disprove.
    open: Vec<Reading>,
    rng: Pcg64Mcg,
    n: usize,
    pairs: Vec<Pair>,
    next: Search,
}

/// What the states of a pair fulfil.
#[derive(Debug)]
struct Forms {
    goal: TermId,
    /// For a task over time what asks for less; `None` for a goal of states.
    lesser: Option<Vec<TermId>>,
    before: Vec<TermId>,
    /// The goal with what holds after besides: where a plan is to end.
    end: TermId,
    /// Whether the way there is shown where the goal is one of states, too.
    has_ways: bool,
}

/// Something else that the pairs could show.
#[derive(Debug)]
struct Reading {
    term: TermId,
    name: String,
    /// Whether the task says that it is unlike this: such are disproved first.
    is_near: bool,
}

/// The search for one pair.
#[derive(Debug, Default)]
struct Search {
    tries: usize,
    /// Worlds that would do.
    fitting: usize,
    /// The one among them that leaves fewest readings open, and how many: of those that are near, of all.
    best: Option<([usize; 2], Pair)>,
    /// What was wrong with the last world that would not.
    why: &'static str,
}

/// Draws `n` pairs for the task of this name.
///
/// # Errors
/// When there is no such task, or no world for it.
pub fn draw(tasks: &[StudyTask], name: &str, n: usize, seed: u64) -> Result<Drawn, DrawError> {
    let mut drawing = Drawing::new(tasks, name, n, seed)?;
    loop {
        if let Some(ended) = drawing.step() {
            return ended;
        }
    }
}

impl Drawing {
    /// Draws `n` pairs for the task of this name, one of these.
    ///
    /// # Errors
    /// When there is no such task.
    pub fn new(tasks: &[StudyTask], name: &str, n: usize, seed: u64) -> Result<Self, DrawError> {
        let bad = |message: String| DrawError::BadTask { task: name.to_owned(), message };
        let task = tasks
            .iter()
            .find(|t| t.name == name)
            .ok_or_else(|| bad("there is no task of this name".into()))?;
        let mut terms = Terms::new();
        let mut term = |form: &str| read(&mut terms, form).map_err(|e| bad(e.to_string()));
        let goal = term(&task.goal)?;
        let mut open: Vec<Reading> = Vec::new();
        let others = tasks.iter().map(|t| (&t.goal, &t.name));
        for (form, name) in others.chain(task.unlike.iter().map(|f| (f, f))) {
            let (term, is_near) = (term(form)?, task.unlike.contains(form));
            if term != goal && !open.iter().any(|o| o.term == term) {
                open.push(Reading { term, name: name.clone(), is_near });
            }
        }
        let lesser = (terms.ty(goal) == RUN).then(|| lesser(&mut terms, goal));
        for &term in lesser.iter().flatten() {
            // What asks for less than a task is near to it.
            match open.iter_mut().find(|known| known.term == term) {
                Some(known) => known.is_near = true,
                None => open.push(Reading { term, name: print(&terms, term), is_near: true }),
            }
        }
        let mut term = |form: &str| read(&mut terms, form).map_err(|e| bad(e.to_string()));
        let before = task.before.iter().map(|f| term(f)).collect::<Result<_, _>>()?;
        let end = match (&lesser, &task.after[..]) {
            (Some(_), []) => goal,
            (Some(_), _) => return Err(bad("what is so after a run is said by its goal".into())),
            (None, after) => term(&format!("(and:<t*,t> {} {})", task.goal, after.join(" ")))?,
        };
        let forms = Forms { goal, lesser, before, end, has_ways: false };
        let rng = Pcg64Mcg::seed_from_u64(mixed(seed, name));
        let task = task.clone();
        Ok(Self { task, terms, forms, open, rng, n, pairs: Vec::new(), next: Search::default() })
    }

    /// Shows the way as well, whatever the goal: runs in place of pairs.
    #[must_use]
    pub fn with_ways(mut self) -> Drawing {
        self.forms.has_ways = true;
        self
    }

    /// How many pairs there are so far.
    pub fn progress(&self) -> usize {
        self.pairs.len()
    }

    /// Tries one more world; the pairs, or why there are none, at the end.
    pub fn step(&mut self) -> Option<Result<Drawn, DrawError>> {
        let Self { task, terms, forms, open, rng, n, pairs, next } = self;
        if pairs.len() == *n {
            let open = open.iter().map(|o| o.name.clone()).collect();
            return Some(Ok(Drawn { pairs: pairs.clone(), open }));
        }
        next.tries += 1;
        match pair(terms, forms, task, rng) {
            Ok(pair) if !pairs.contains(&pair) => {
                let left: Vec<&Reading> =
                    open.iter().filter(|o| explains(terms, o.term, &pair)).collect();
                let left = [left.iter().filter(|o| o.is_near).count(), left.len()];
                next.fitting += 1;
                if next.best.as_ref().is_none_or(|b| left < b.0) {
                    next.best = Some((left, pair));
                }
            }
            Ok(_) => next.why = "it was drawn before",
            Err(reason) => next.why = reason,
        }
        let is_best = next.best.as_ref().is_some_and(|b| match b.0 {
            [0, all] => all == 0 || next.fitting >= ENOUGH,
            _ => false,
        });
        if is_best || next.fitting == CANDIDATES || next.tries == TRIES {
            let Search { best, why, .. } = std::mem::take(next);
            let Some((_, pair)) = best else {
                return Some(Err(DrawError::NoWorld { task: task.name.clone(), why }));
            };
            open.retain(|o| explains(terms, o.term, &pair));
            pairs.push(pair);
        }
        None
    }
}

/// Whether a form is false before and true after, its references bound before; a run is to show it.
fn explains(terms: &Terms, form: TermId, pair: &Pair) -> bool {
    if let Some(way) = &pair.way {
        let mut validator = Validator::new();
        let shown = validator.shown(&pair.pre, &pair.post, Some(way));
        return validator.valid(terms, form, &[shown]);
    }
    Goal::new(terms, form, &pair.pre).is_ok_and(|g| !g.holds(&pair.pre) && g.holds(&pair.post))
}

/// One world and the end of a plan in it, or what is wrong with this draw.
fn pair(
    terms: &Terms,
    forms: &Forms,
    task: &StudyTask,
    rng: &mut Pcg64Mcg,
) -> Result<Pair, &'static str> {
    let pre = world(task, rng)?;
    let bind = |form| Goal::new(terms, form, &pre).map_err(|_| "a form is too large");
    if let Some(lesser) = &forms.lesser {
        for &form in &forms.before {
            if !bind(form)?.holds(&pre) {
                return Err("it does not begin as it should");
            }
        }
        let settings = Settings { budget: BUDGET, ..Settings::default() };
        let pair = runs::draw(terms, (forms.goal, lesser), pre, settings, &ACTIONS)?;
        let shows = explains(terms, forms.goal, &pair);
        return if shows { Ok(pair) } else { Err("its plan misses its goal") };
    }
    let bound = bind(forms.goal)?;
    if !bound.failures().is_empty() {
        return Err("a phrase of its goal does not refer");
    }
    if bound.holds(&pre) {
        return Err("its goal holds already");
    }
    for &form in &forms.before {
        if !bind(form)?.holds(&pre) {
            return Err("it does not begin as it should");
        }
    }
    let end = bind(forms.end)?;
    let rules = Rules { movable: movable(&bound, &pre), ..Rules::default() };
    let problem = Task::new(&end, &pre, rules).map_err(|_| "it is too large to be planned in")?;
    let mut search = AStar::new(&problem, Settings { budget: BUDGET, ..Settings::default() });
    let (Outcome::Solved, Some(plan)) = (search.run(), search.plan()) else {
        return Err("no plan reaches its goal");
    };
    if !ACTIONS.contains(&plan.actions.len()) {
        return Err("its goal is too near or too far");
    }
    let post = problem.replay(&plan.actions).pop().unwrap_or_else(|| pre.clone());
    let way = || Box::new(Way { actions: plan.actions.clone().into(), ..Way::default() });
    let pair = Pair { pre, post, way: forms.has_ways.then(way) };
    if explains(terms, forms.goal, &pair) { Ok(pair) } else { Err("its plan misses its goal") }
}

/// What the goal says to move; where it only says what shall not be, the one thing of which it says so, or all.
fn movable(goal: &Goal, initial: &State) -> Movable {
    let movable = goal.movable(initial);
    match goal.mover(initial) {
        Some(Entity::Object(name)) => {
            let index = initial.objects.iter().position(|o| o.name == name);
            index.map_or(movable, |index| movable.with(index))
        }
        None if movable == Movable::NONE => Movable::ALL,
        _ => movable,
    }
}

/// The seed of one task: that of the study with the task's name, so that a task's pairs do not hang on its place
/// in the file.
fn mixed(seed: u64, name: &str) -> u64 {
    let hash = blake3::hash(name.as_bytes());
    let first = hash.as_bytes().iter().take(8);
    seed ^ first.fold(0, |all, &byte| all << 8 | u64::from(byte))
}
