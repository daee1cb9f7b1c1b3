//! Pairs of states for a study: a seeded world that fulfils what a task asks of it, and the end of a shortest plan to
//! its goal in which only what the command says to move is moved. Each pair is checked by the goal evaluator, and
//! together they are drawn so that a nearby reading (another task's goal, or one that the task is unlike) does not
//! explain them all. Invariant: a pure function of tasks, name, number of pairs and seed.

use super::tasks::{Paint, StudyTask};
use crate::corpus::Pair;
use crate::domain::layout::{NOWHERE, Place};
use crate::domain::{Color, Direction, Layout, Lock, Object, Plan, Rules, State, generate};
use crate::ground::{Goal, Task};
use crate::logic::{TermId, Terms, read};
use crate::mdp::{Budget, Outcome, Settings, Solver};
use crate::plan::AStar;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Worlds that are tried for one pair.
const TRIES: usize = 600;
/// Fitting worlds among which the one is chosen that disproves most.
const CANDIDATES: usize = 60;
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
    goal: TermId,
    /// Readings that the pairs so far do not disprove, with what they are called.
    open: Vec<(TermId, String)>,
    rng: Pcg64Mcg,
    n: usize,
    pairs: Vec<Pair>,
    next: Search,
}

/// The search for one pair.
#[derive(Debug, Default)]
struct Search {
    tries: usize,
    /// Worlds that would do.
    fitting: usize,
    /// The one among them that leaves fewest readings open, and how many.
    best: Option<(usize, Pair)>,
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
        let mut open: Vec<(TermId, String)> = Vec::new();
        let others = tasks.iter().map(|t| (&t.goal, &t.name));
        for (form, name) in others.chain(task.unlike.iter().map(|f| (f, f))) {
            let term = term(form)?;
            if term != goal && !open.iter().any(|o| o.0 == term) {
                open.push((term, name.clone()));
            }
        }
        let rng = Pcg64Mcg::seed_from_u64(mixed(seed, name));
        let task = task.clone();
        Ok(Self { task, terms, goal, open, rng, n, pairs: Vec::new(), next: Search::default() })
    }

    /// How many pairs there are so far.
    pub fn progress(&self) -> usize {
        self.pairs.len()
    }

    /// Tries one more world; the pairs, or why there are none, at the end.
    pub fn step(&mut self) -> Option<Result<Drawn, DrawError>> {
        let Self { task, terms, goal, open, rng, n, pairs, next } = self;
        if pairs.len() == *n {
            let open = open.iter().map(|o| o.1.clone()).collect();
            return Some(Ok(Drawn { pairs: pairs.clone(), open }));
        }
        next.tries += 1;
        match pair(terms, *goal, task, rng) {
            Ok(pair) if !pairs.contains(&pair) => {
                let left = open.iter().filter(|o| explains(terms, o.0, &pair)).count();
                next.fitting += 1;
                if next.best.as_ref().is_none_or(|b| left < b.0) {
                    next.best = Some((left, pair));
                }
            }
            Ok(_) => next.why = "it was drawn before",
            Err(reason) => next.why = reason,
        }
        let is_best = next.best.as_ref().is_some_and(|b| b.0 == 0);
        if is_best || next.fitting == CANDIDATES || next.tries == TRIES {
            let Search { best, why, .. } = std::mem::take(next);
            let Some((_, pair)) = best else {
                return Some(Err(DrawError::NoWorld { task: task.name.clone(), why }));
            };
            open.retain(|o| explains(terms, o.0, &pair));
            pairs.push(pair);
        }
        None
    }
}

/// Whether a form is false before and true after, its references bound before.
fn explains(terms: &Terms, form: TermId, pair: &Pair) -> bool {
    Goal::new(terms, form, &pair.pre).is_ok_and(|g| !g.holds(&pair.pre) && g.holds(&pair.post))
}

/// One world and the end of a plan in it, or what is wrong with this draw.
fn pair(
    terms: &Terms,
    goal: TermId,
    task: &StudyTask,
    rng: &mut Pcg64Mcg,
) -> Result<Pair, &'static str> {
    let pre = world(task, rng)?;
    let bound = Goal::new(terms, goal, &pre).map_err(|_| "its goal is too large")?;
    if !bound.failures().is_empty() {
        return Err("a phrase of its goal does not refer");
    }
    if bound.holds(&pre) {
        return Err("its goal holds already");
    }
    let rules = Rules { movable: bound.movable(&pre), ..Rules::default() };
    let problem = Task::new(&bound, &pre, rules).map_err(|_| "it is too large to be planned in")?;
    let mut search = AStar::new(&problem, Settings { budget: BUDGET, ..Settings::default() });
    let (Outcome::Solved, Some(plan)) = (search.run(), search.plan()) else {
        return Err("no plan reaches its goal");
    };
    if !ACTIONS.contains(&plan.actions.len()) {
        return Err("its goal is too near or too far");
    }
    let post = problem.replay(&plan.actions).pop().unwrap_or_else(|| pre.clone());
    let pair = Pair { pre, post };
    if explains(terms, goal, &pair) { Ok(pair) } else { Err("its plan misses its goal") }
}

/// Three rooms like those of the corpora, with the colours and the things that a task asks for.
fn world(task: &StudyTask, rng: &mut Pcg64Mcg) -> Result<State, &'static str> {
    let empty = Plan { objects: (0, 0), ..Plan::default() };
    let mut state = generate(&empty, rng.random());
    let mut colors = task.rooms.clone();
    for room in &mut state.rooms {
        if !colors.is_empty() {
            room.color = colors.swap_remove(below(colors.len(), rng));
        }
    }
    let mut sizes: Vec<i64> = state.rooms.iter().map(|r| r.bounds.area()).collect();
    sizes.sort_unstable();
    let is_apart = |pair: &[i64]| pair[1] * 4 >= pair[0] * 5;
    if task.apart && !sizes.windows(2).all(is_apart) {
        return Err("its rooms are too much of one size");
    }
    let layout = Layout::new(&state);
    let stands = layout.place(state.agent.x, state.agent.y);
    let is_free =
        |&p: &Place| layout.door(p).is_none() && stands != Some(p) && !is_corner(&layout, p);
    let mut floor: Vec<Place> = layout.places().filter(is_free).collect();
    for (number, look) in task.things.iter().enumerate() {
        let named: Vec<Color> = task
            .things
            .iter()
            .filter(|t| t.shape == look.shape)
            .filter_map(|t| if let Paint::Is(color) = t.paint { Some(color) } else { None })
            .collect();
        let others: Vec<Color> =
            Color::ALL.iter().copied().filter(|c| !named.contains(c)).collect();
        let color = match look.paint {
            Paint::Is(color) => color,
            Paint::Any => Color::ALL[below(Color::ALL.len(), rng)],
            Paint::Other if others.is_empty() => return Err("every colour of a shape is named"),
            Paint::Other => others[below(others.len(), rng)],
        };
        if floor.is_empty() {
            return Err("its floor is too small for its things");
        }
        let (x, y) = layout.cell(floor.swap_remove(below(floor.len(), rng)));
        let (name, shape) = (format!("object{number}"), look.shape);
        state.objects.push(Object { name, shape, color, size: None, x, y });
    }
    state.doors.iter_mut().for_each(|door| door.lock = Lock::Unlocked);
    Ok(state)
}

/// Whether there is wall on two sides that meet: nothing is pushed out of there.
fn is_corner(layout: &Layout, place: Place) -> bool {
    let wall = |d| layout.neighbour(place, d) == NOWHERE;
    (wall(Direction::North) || wall(Direction::South))
        && (wall(Direction::East) || wall(Direction::West))
}

/// The seed of one task: that of the study with the task's name, so that a task's pairs do not hang on its place
/// in the file.
fn mixed(seed: u64, name: &str) -> u64 {
    let hash = blake3::hash(name.as_bytes());
    let first = hash.as_bytes().iter().take(8);
    seed ^ first.fold(0, |all, &byte| all << 8 | u64::from(byte))
}

/// An index below `len`, which is not 0; drawn as u32, so that it is the same on every target.
fn below(len: usize, rng: &mut Pcg64Mcg) -> usize {
    rng.random_range(0..u32::try_from(len).unwrap_or(u32::MAX)) as usize
}
