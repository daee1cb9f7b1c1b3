//! Who thinks for a robot in tests: a goal bound in the world that it was said in, of states or of runs, and plans for it
//! from wherever the robot's run has come to, in robot form.

use groundling::domain::{Action, Dynamics, Form, Movable, Packed, Rules, State};
use groundling::ground::{Course, Errand, Goal, Task, errand};
use groundling::logic::{Terms, read};
use groundling::mdp::{Mdp, Outcome, Policy, Settings, Solver, StartingAt, Watch};
use groundling::plan::Auto;

pub(crate) struct Brain {
    dynamics: Dynamics,
    what: What,
}

enum What {
    Goal(Box<Task>),
    Course(Box<Errand>, Box<Course>),
}

impl Brain {
    /// Binds a goal, which is a form of type t or p, in a world.
    pub(crate) fn new(form: &str, initial: &State) -> Brain {
        let mut terms = Terms::new();
        let term = read(&mut terms, form).unwrap();
        let rules = |movable| Rules { form: Form::Robot, movable, ..Rules::default() };
        let (rules, what) = match Goal::new(&terms, term, initial) {
            Ok(goal) => {
                let rules = rules(goal.movable(initial));
                (rules, What::Goal(Box::new(Task::new(&goal, initial, rules).unwrap())))
            }
            Err(_) => {
                let course = Course::new(&terms, term, initial).unwrap();
                let rules = rules(Movable::NONE);
                let task = errand(&course, initial, rules).unwrap();
                (rules, What::Course(Box::new(task), Box::new(course)))
            }
        };
        Brain { dynamics: Dynamics::new(initial, rules).unwrap(), what }
    }

    /// Whether a run does what was asked.
    pub(crate) fn is_done(&self, run: &[State]) -> bool {
        match &self.what {
            What::Goal(task) => {
                let last = self.dynamics.pack(run.last().unwrap()).unwrap();
                task.is_terminal(self.dynamics.quotient(last))
            }
            What::Course(_, course) => course.beginnings(run).first().is_some(),
        }
    }

    /// The states of a shortest way on from where a run has come to.
    pub(crate) fn plan(&self, run: &[State]) -> Option<Vec<State>> {
        let packed: Vec<Packed> =
            run.iter().map(|state| self.dynamics.pack(state).unwrap()).collect();
        let now = *packed.last()?;
        match &self.what {
            What::Goal(task) => self.follow(&**task, now, |packed| packed),
            What::Course(task, _) => {
                let watch = task.watch();
                let mut stage = watch.begin(packed[0]);
                for state in &packed[1..] {
                    stage = watch.step(stage, *state);
                }
                self.follow(&**task, (now, stage), |(packed, _)| packed)
            }
        }
    }

    fn follow<P>(
        &self,
        problem: &P,
        start: P::State,
        packed: impl Fn(P::State) -> Packed,
    ) -> Option<Vec<State>>
    where
        P: Mdp<Action = Action>,
    {
        let mut solver = Auto::new(StartingAt::new(problem, start), Settings::default());
        let (mut at, mut states) = (start, vec![self.dynamics.unpack(packed(start))]);
        if solver.run() != Outcome::Solved {
            return None;
        }
        while !problem.is_terminal(at) {
            let mut out = Vec::new();
            problem.successors(at, solver.action(at)?, &mut out);
            at = out.first()?.0;
            states.push(self.dynamics.unpack(packed(at)));
        }
        Some(states)
    }
}
