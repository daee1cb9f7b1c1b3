//! What there is to plan for, a goal of states or a task over time, as one kind of problem, so that whoever solves both has
//! its solvers once. A state of a task over time bears the stage of the task as its mark.

use super::course::Course;
use super::errand::{Errand, ErrandError, errand};
use super::task::Task;
use crate::domain::layout::Place;
use crate::domain::{Action, Direction, Dynamics, Packed, Rules, State};
use crate::mdp::{Leaps, Mdp, Sharpened, Watch, each_action};

/// Something to be done from an initial state, under the rules of a world.
#[derive(Debug)]
pub enum Undertaking {
    /// A goal.
    Goal(Box<Task>),
    /// A task over time.
    Course(Box<Errand>),
}

impl Undertaking {
    /// Compiles a task over time that was bound to `initial`.
    ///
    /// # Errors
    /// When the state is illegal or too large to be planned in, or the task has too many stages.
    pub fn course(
        course: &Course,
        initial: &State,
        rules: Rules,
    ) -> Result<Undertaking, ErrandError> {
        let errand = errand(course, initial, rules)?;
        errand.problem().dynamics().bears_mark().map_err(super::TaskError::from)?;
        Ok(Undertaking::Course(Box::new(errand)))
    }

    /// The world's moves.
    #[must_use]
    pub fn dynamics(&self) -> &Dynamics {
        match self {
            Undertaking::Goal(task) => task.dynamics(),
            Undertaking::Course(errand) => errand.problem().dynamics(),
        }
    }

    /// Whether nothing is left to chance.
    #[must_use]
    pub fn is_deterministic(&self) -> bool {
        match self {
            Undertaking::Goal(task) => task.is_deterministic(),
            Undertaking::Course(errand) => errand.problem().is_deterministic(),
        }
    }

    /// Whether what has come to this state can never be brought to its end, by what was done.
    #[must_use]
    pub fn has_failed(&self, at: Packed) -> bool {
        match self {
            Undertaking::Goal(_) => false,
            Undertaking::Course(errand) => errand.watch().has_failed(at.mark()),
        }
    }

    /// Whether a task came to more stages than are kept: that there is no way is then not proved.
    #[must_use]
    pub fn is_over(&self) -> bool {
        match self {
            Undertaking::Goal(_) => false,
            Undertaking::Course(errand) => errand.watch().is_over(),
        }
    }

    /// The same problem with no two states taken for one: what a person watches.
    #[must_use]
    pub const fn world(&self) -> Around<'_> {
        Around(self)
    }

    /// A state of [`Undertaking::world`] as policies know it.
    #[must_use]
    pub fn known(&self, at: Packed) -> Packed {
        match self {
            Undertaking::Goal(task) => task.dynamics().quotient(at),
            Undertaking::Course(errand) => {
                errand.problem().dynamics().quotient(at.unmarked()).marked(at.mark())
            }
        }
    }

    /// A state of the world; nothing if it is one of another.
    #[must_use]
    pub fn packed(&self, state: &State) -> Option<Packed> {
        let dynamics = self.dynamics();
        dynamics.pack(state).ok().filter(|&packed| dynamics.unpack(packed) == *state)
    }

    /// What a run has come to, however its states came about: a task over time to its stage; nothing if there is none, or
    /// if one of its states is of another world.
    #[must_use]
    pub fn along(&self, run: &[State]) -> Option<Packed> {
        let run: Vec<Packed> = run.iter().map(|state| self.packed(state)).collect::<Option<_>>()?;
        match self {
            Undertaking::Goal(_) => run.last().copied(),
            Undertaking::Course(errand) => {
                let (first, later) = run.split_first()?;
                let begin = (*first, errand.watch().begin(*first));
                let step = |(_, stage), &state| (state, errand.watch().step(stage, state));
                let (last, stage) = later.iter().fold(begin, step);
                Some(last.marked(stage))
            }
        }
    }

    /// What stands in a state of the world.
    #[must_use]
    pub fn state(&self, at: Packed) -> State {
        match self {
            Undertaking::Goal(task) => task.dynamics().unpack(at),
            Undertaking::Course(errand) => errand.problem().dynamics().unpack(at.unmarked()),
        }
    }

    /// The state, as policies know it, that differs from one in where the robot stands and faces: a task over time has
    /// come to its stage there.
    #[must_use]
    pub fn moved(&self, at: Packed, place: Place, heading: Direction) -> Option<Packed> {
        match self {
            Undertaking::Goal(task) => {
                let dynamics = task.dynamics();
                Some(dynamics.quotient(dynamics.with_agent(at, place, heading)?))
            }
            Undertaking::Course(errand) => {
                let dynamics = errand.problem().dynamics();
                let there = dynamics.with_agent(at.unmarked(), place, heading)?;
                let stage = errand.watch().step(at.mark(), there);
                Some(dynamics.quotient(there).marked(stage))
            }
        }
    }
}

impl Mdp for Undertaking {
    type State = Packed;
    type Action = Action;

    fn initial(&self) -> Packed {
        match self {
            Undertaking::Goal(task) => task.initial(),
            Undertaking::Course(errand) => {
                let (state, stage) = errand.initial();
                state.marked(stage)
            }
        }
    }

    fn actions(&self) -> &[Action] {
        match self {
            Undertaking::Goal(task) => task.actions(),
            Undertaking::Course(errand) => errand.actions(),
        }
    }

    fn successors(&self, state: Packed, action: Action, out: &mut Vec<(Packed, f64)>) {
        match self {
            Undertaking::Goal(task) => task.successors(state, action, out),
            Undertaking::Course(errand) => {
                let mut ends = Vec::new();
                errand.successors((state.unmarked(), state.mark()), action, &mut ends);
                out.extend(ends.into_iter().map(|((next, stage), p)| (next.marked(stage), p)));
            }
        }
    }

    fn is_terminal(&self, state: Packed) -> bool {
        match self {
            Undertaking::Goal(task) => task.is_terminal(state),
            Undertaking::Course(errand) => errand.watch().is_satisfied(state.mark()),
        }
    }

    fn heuristic(&self, state: Packed) -> Option<u32> {
        match self {
            Undertaking::Goal(task) => task.heuristic(state),
            Undertaking::Course(errand) => errand.watch().least(state.mark(), state.unmarked()),
        }
    }

    fn most(&self, state: Packed, discount: f64) -> f64 {
        match self {
            Undertaking::Goal(task) => task.most(state, discount),
            Undertaking::Course(errand) => errand.most((state.unmarked(), state.mark()), discount),
        }
    }

    fn estimate(&self, state: Packed) -> Option<u32> {
        match self {
            Undertaking::Goal(task) => task.estimate(state),
            Undertaking::Course(_) => self.heuristic(state),
        }
    }

    fn n_parts(&self) -> usize {
        match self {
            Undertaking::Goal(task) => task.n_parts(),
            Undertaking::Course(_) => 0,
        }
    }

    fn part(&self, index: usize, state: Packed) -> Option<u32> {
        match self {
            Undertaking::Goal(task) => task.part(index, state),
            Undertaking::Course(_) => self.heuristic(state),
        }
    }

    fn parts(&self, state: Packed) -> Vec<(u32, usize)> {
        match self {
            Undertaking::Goal(task) => task.parts(state),
            Undertaking::Course(_) => Vec::new(),
        }
    }

    fn sharpen(&self) -> Sharpened {
        match self {
            Undertaking::Goal(task) => task.sharpen(),
            Undertaking::Course(_) => Sharpened::Whole,
        }
    }

    fn leaps(&self, state: Packed, out: &mut Leaps<Packed>) {
        match self {
            Undertaking::Goal(task) => task.leaps(state, out),
            Undertaking::Course(errand) => {
                if !errand.watch().leaps(state, out) {
                    each_action(self, state, out);
                }
            }
        }
    }

    fn way(&self, from: Packed, number: u16, out: &mut Vec<Action>) {
        match self {
            Undertaking::Goal(task) => task.way(from, number, out),
            Undertaking::Course(errand) => {
                if !errand.watch().way(from, number, out) {
                    out.extend(self.actions().get(usize::from(number)));
                }
            }
        }
    }
}

/// An undertaking in which every state is told from every other; see [`Undertaking::world`].
#[derive(Clone, Copy, Debug)]
pub struct Around<'a>(&'a Undertaking);

impl Mdp for Around<'_> {
    type State = Packed;
    type Action = Action;

    fn initial(&self) -> Packed {
        match self.0 {
            Undertaking::Goal(task) => task.world().initial(),
            Undertaking::Course(errand) => {
                let start = errand.problem().start();
                start.marked(errand.watch().begin(start))
            }
        }
    }

    fn actions(&self) -> &[Action] {
        self.0.actions()
    }

    fn successors(&self, state: Packed, action: Action, out: &mut Vec<(Packed, f64)>) {
        match self.0 {
            Undertaking::Goal(task) => task.world().successors(state, action, out),
            Undertaking::Course(errand) => {
                let from = out.len();
                errand.problem().dynamics().outcomes(state.unmarked(), action, out);
                for (next, _) in &mut out[from..] {
                    *next = next.marked(errand.watch().step(state.mark(), *next));
                }
            }
        }
    }

    fn is_terminal(&self, state: Packed) -> bool {
        self.0.is_terminal(state)
    }
}
