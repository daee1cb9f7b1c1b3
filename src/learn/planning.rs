//! How learning asks whether a form explains a demonstration. The rule is the states' alone ([`Validator`]); for
//! Table III of Williams et al. there is the baseline that plans (after Artzi and Zettlemoyer 2013): a form is valid
//! when on each pair the goal is false before, a shortest plan of at most `horizon` actions exists in the
//! deterministic world without pull, and the goal holds in the plan's last state and after. Nothing else in
//! learning plans (invariant 5).

use crate::corpus::{Example, Pair};
use crate::domain::{Rules, State};
use crate::ground::{Goal, PairId, Side, Task, Validator};
use crate::logic::{TermId, Terms};
use crate::mdp::{Budget, Mdp, Outcome, Settings, Solver, StartingAt};
use crate::plan::AStar;
use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// States that one call of the planner may expand: more than a room with one object has, so that a search in vain
/// ends. A call that runs out of it finds no plan.
pub const CALL_BUDGET: u64 = 20_000;

/// The baseline that plans.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Planning {
    /// The most actions of a plan.
    pub horizon: u32,
    /// Whether answers are kept by form and pair.
    pub memo: bool,
    /// States that all calls of a run may expand; once they are spent no form is valid that was not before.
    pub budget: u64,
}

impl Default for Planning {
    /// The paper's longest horizon, as it is meant to be run.
    fn default() -> Self {
        Planning { horizon: 20, memo: true, budget: 2_000_000_000 }
    }
}

/// What planning cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PlannerCost {
    /// Calls of the planner.
    pub calls: u64,
    /// Calls that the memo saved.
    pub saved: u64,
    /// States expanded in all calls.
    pub expanded: u64,
    /// Calls that gave up: they ran out of [`CALL_BUDGET`], or of the budget of the run.
    pub given_up: u64,
}

/// What judges forms by demonstrations, for the terms of one arena.
#[derive(Debug, Default)]
pub struct Validation {
    validator: Validator,
    planner: Option<Planner>,
}

#[derive(Debug)]
struct Planner {
    planning: Planning,
    memo: FxHashMap<(TermId, PairId), bool>,
    cost: PlannerCost,
}

impl Validation {
    /// By states alone, or with a planner.
    pub fn new(planning: Option<Planning>) -> Self {
        let planner = planning.map(|planning| Planner {
            planning,
            memo: FxHashMap::default(),
            cost: PlannerCost::default(),
        });
        Validation { validator: Validator::new(), planner }
    }

    /// Compiles a pair of states, or finds it again.
    pub fn pair(&mut self, pre: &State, post: &State) -> PairId {
        self.validator.pair(pre, post)
    }

    /// Takes in the first so many demonstrations of an example, all where there is no limit, with or without the
    /// contrasts of runs.
    pub fn demonstrations(
        &mut self,
        example: &Example,
        most: Option<u32>,
        contrasts: bool,
    ) -> Vec<PairId> {
        let most = most.map_or(usize::MAX, |most| most as usize);
        let shown = |Pair { pre, post, way }: &Pair| match way {
            Some(way) if !contrasts => self.validator.shown(pre, post, Some(&way.alone())),
            way => self.validator.shown(pre, post, way.as_deref()),
        };
        example.pairs.iter().take(most).map(shown).collect()
    }

    /// Whether a demonstration is a run.
    pub fn is_run(&self, pair: PairId) -> bool {
        self.validator.is_run(pair)
    }

    /// Whether a form explains all of the pairs; without pairs nothing does.
    pub fn valid(&mut self, terms: &Terms, form: TermId, pairs: &[PairId]) -> bool {
        let Validation { validator, planner } = self;
        let Some(planner) = planner else { return validator.valid(terms, form, pairs) };
        !pairs.is_empty()
            && pairs.iter().all(|&pair| {
                validator.holds(terms, form, pair, Side::Pre) == Some(false)
                    && planner.reaches(validator, terms, form, pair)
                    && validator.holds(terms, form, pair, Side::Post) == Some(true)
            })
    }

    /// Whether a phrase can be part of what was meant: see [`Validator::denotes`].
    pub fn denotes(&mut self, terms: &Terms, term: TermId, pairs: &[PairId]) -> bool {
        self.validator.denotes(terms, term, pairs)
    }

    /// What planning cost so far; `None` when there is no planner.
    pub fn cost(&self) -> Option<PlannerCost> {
        self.planner.as_ref().map(|planner| planner.cost)
    }
}

impl Planner {
    /// Whether a plan within the horizon leads from the state before to where the goal holds.
    fn reaches(
        &mut self,
        validator: &Validator,
        terms: &Terms,
        form: TermId,
        pair: PairId,
    ) -> bool {
        if let Some(&known) = self.memo.get(&(form, pair)) {
            self.cost.saved += 1;
            return known;
        }
        let found = validator.pre(pair).is_some_and(|pre| self.plan(terms, form, pre));
        if self.planning.memo {
            self.memo.insert((form, pair), found);
        }
        found
    }

    fn plan(&mut self, terms: &Terms, form: TermId, pre: &State) -> bool {
        let Planning { horizon, budget, .. } = self.planning;
        self.cost.calls += 1;
        if self.cost.expanded >= budget {
            self.cost.given_up += 1;
            return false;
        }
        let task = Goal::new(terms, form, pre)
            .ok()
            .and_then(|goal| Some((Task::new(&goal, pre, Rules::default()).ok()?, goal)));
        let Some((task, goal)) = task else { return false };
        if task.is_impossible() {
            return false;
        }
        let budget = Budget { steps: CALL_BUDGET, ..Budget::default() };
        let call = Settings { budget, ..Settings::default() };
        // The problem has the type that the page plans with: its program holds the search once.
        let task = Rc::new(task);
        let problem = StartingAt::new(task.clone(), task.initial());
        let mut search = AStar::within(problem, call, horizon);
        let outcome = search.run();
        self.cost.expanded += search.expanded();
        self.cost.given_up += u64::from(outcome == Outcome::Budget);
        outcome == Outcome::Solved
            && search.plan().is_some_and(|plan| {
                task.replay(&plan.actions).last().is_some_and(|last| goal.holds(last))
            })
    }
}
