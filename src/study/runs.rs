//! Runs for a task over time: a shortest plan for it, and as contrasts the shortest plans for what asks for less, where
//! these do not do the whole.

use crate::corpus::{Pair, run};
use crate::domain::{Action, Rules, State, Way};
use crate::ground::{Course, errand};
use crate::logic::{TermId, Terms};
use crate::mdp::{Mdp, Outcome, Settings, Solver};
use crate::plan::AStar;

/// The run that a plan for a task is, or what is wrong with this world. `lesser` are the tasks that ask for less.
pub(super) fn draw(
    terms: &Terms,
    (task, lesser): (TermId, &[TermId]),
    pre: State,
    settings: Settings,
    actions: &std::ops::RangeInclusive<usize>,
) -> Result<Pair, &'static str> {
    let bind = |task| Course::new(terms, task, &pre).map_err(|_| "a form is too large");
    let course = bind(task)?;
    if course.guards().iter().any(|guard| !guard.failures().is_empty()) {
        return Err("a phrase of its goal does not refer");
    }
    let rules = Rules { movable: course.movable(&pre), ..Rules::default() };
    let plan = plan(&course, &pre, rules, settings).ok_or("no plan reaches its goal")?;
    if plan.is_empty() {
        return Err("its goal holds already");
    }
    if !actions.contains(&plan.len()) {
        return Err("its goal is too near or too far");
    }
    let mut contrasts: Vec<Box<[Action]>> = Vec::new();
    for &task in lesser {
        let less = self::plan(&bind(task)?, &pre, rules, settings);
        let less = less.filter(|less| !less.is_empty() && !contrasts.contains(less));
        let Some(less) = less else { continue };
        let alone = Way { actions: less.clone(), contrasts: Box::default() };
        let states = alone.states(&pre).map_err(|_| "it is too large to be planned in")?;
        if states.iter().all(|states| course.beginnings(states).first().is_none()) {
            contrasts.push(less);
        }
    }
    let way = Way { actions: plan, contrasts: contrasts.into() };
    run::pair(pre, way).map_err(|_| "it is too large to be planned in")
}

/// The actions of a shortest plan.
fn plan(course: &Course, pre: &State, rules: Rules, settings: Settings) -> Option<Box<[Action]>> {
    let problem = errand(course, pre, rules).ok()?;
    if problem.watch().has_failed(problem.initial().1) {
        return None;
    }
    let mut search = AStar::new(&problem, settings);
    let outcome = search.run();
    let plan = search.plan().filter(|_| outcome == Outcome::Solved)?;
    Some(plan.actions.clone().into())
}
