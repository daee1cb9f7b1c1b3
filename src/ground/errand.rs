//! A task over time in a world as a problem for a planner: the world's moves without a goal of their own, watched by the
//! task's monitor. Guards are compiled to tests on packed states like goals are; their bounds price the way to the next
//! step, and from that to the one after it.

use super::compile::Compiled;
use super::course::Course;
use super::itinerary::Itinerary;
use super::monitor::{Monitor, Residual, TooMany};
use super::outline::{Part, Valuation};
use super::strides::{Stages, Strides};
use super::task::{TaskError, merged};
use crate::domain::layout::Place;
use crate::domain::{Action, Direction, Dynamics, Packed, Rules, State};
use crate::mdp::{Leaps, Mdp, Watch, Watched};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// A task over time to be done from an initial state, under the rules of a world.
pub type Errand = Watched<Moves, Watcher>;

/// The moves of a world, towards nothing.
#[derive(Clone, Debug)]
pub struct Moves {
    dynamics: Rc<Dynamics>,
    start: Packed,
}

/// The monitor of a task over packed states.
#[derive(Clone, Debug)]
pub struct Watcher {
    dynamics: Rc<Dynamics>,
    guards: Vec<Compiled>,
    /// The guards that are about nothing but where the robot is, as bits, and which of them hold at each place.
    of_robot: Valuation,
    at_place: Vec<Valuation>,
    /// Whether one is about where the robot is and about others, too.
    is_mixed: bool,
    monitor: RefCell<Monitor>,
    /// The bound of a task that is about nothing else.
    itinerary: Option<Itinerary>,
    /// By two guards, a lower bound on the actions from where the first holds to where the second does.
    legs: Vec<Vec<Option<u32>>>,
    /// What plans are made of, where they are made of more than actions.
    strides: RefCell<Option<Strides>>,
    /// Whether the task came to more stages than are kept: what was said since then is no proof.
    is_over: Cell<bool>,
}

/// The stage of what is left unsaid: none of a monitor's own.
const LOST: u8 = u8::MAX;

/// Compiles a task that was bound to `initial`.
///
/// # Errors
/// When the state is illegal, or too large to be planned in.
pub fn errand(course: &Course, initial: &State, rules: Rules) -> Result<Errand, ErrandError> {
    initial.check().map_err(TaskError::from)?;
    let dynamics = Dynamics::new(initial, rules).map_err(TaskError::from)?;
    let start = dynamics.pack(initial).map_err(TaskError::from)?;
    let quotient = dynamics.quotient(start);
    let guards = course.guards().iter();
    let guards: Vec<Compiled> =
        guards.map(|goal| Compiled::new(goal, &dynamics, initial, quotient)).collect();
    let legs = guards
        .iter()
        .map(|from| guards.iter().map(|to| leg(from, to, &dynamics, quotient)).collect());
    let legs = legs.collect();
    let is_of_robot = |(at, guard): (usize, &Compiled)| u64::from(guard.is_of_robot()) << at;
    let of_robot = guards.iter().enumerate().map(is_of_robot).sum();
    let layout = dynamics.layout();
    let heading = dynamics.heading(start);
    let holds = |place| {
        let there = dynamics.posed(quotient, place, heading);
        of_robot & valuation(&guards, of_robot, &dynamics, there)
    };
    let at_place: Vec<Valuation> = layout.places().map(holds).collect();
    let mut monitor = Monitor::new(course.outline())?;
    let is_alone = of_robot.count_ones() as usize == guards.len();
    let itinerary = is_alone.then(|| {
        let mut all = monitor.clone();
        let opens = |place| dynamics.opens(start, place);
        let from = (dynamics.agent(start), &at_place[..]);
        let found = Itinerary::new(layout, opens, from, &mut all).ok()?;
        monitor = all;
        Some(found)
    });
    let is_mixed = guards.iter().any(|guard| guard.speaks_of_robot() && !guard.is_of_robot());
    let strides = Strides::of(&dynamics, start);
    let dynamics = Rc::new(dynamics);
    let watcher = Watcher {
        dynamics: dynamics.clone(),
        guards,
        of_robot,
        at_place,
        is_mixed,
        itinerary: itinerary.flatten(),
        monitor: RefCell::new(monitor),
        legs,
        strides: RefCell::new(strides),
        is_over: Cell::new(false),
    };
    Ok(Watched::new(Moves { dynamics, start }, watcher))
}

/// Which of some guards hold in a state.
fn valuation(guards: &[Compiled], asked: Valuation, dynamics: &Dynamics, at: Packed) -> Valuation {
    let asked = guards.iter().enumerate().filter(|(guard, _)| asked >> guard & 1 == 1);
    asked.fold(0, |bits, (guard, of)| bits | u64::from(of.holds(dynamics, at)) << guard)
}

/// Why there is no errand.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ErrandError {
    /// There is no such task in this world.
    #[error(transparent)]
    Task(#[from] TaskError),
    /// It has too many stages.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// The least number of actions from where one guard holds to where another does, as far as both speak of the robot alone.
fn leg(from: &Compiled, to: &Compiled, dynamics: &Dynamics, initial: Packed) -> Option<u32> {
    if !from.is_of_robot() || !to.is_of_robot() {
        return Some(0);
    }
    let headings = |place| Direction::ALL.iter().map(move |&heading| (place, heading));
    let poses = dynamics.layout().places().flat_map(headings);
    let poses = poses.map(|(place, heading)| dynamics.posed(initial, place, heading));
    let there = poses.filter(|&pose| from.holds(dynamics, pose));
    there.filter_map(|pose| to.bound(dynamics, pose)).min()
}

impl Moves {
    /// The world's moves.
    pub fn dynamics(&self) -> &Dynamics {
        &self.dynamics
    }

    /// The first state, told from every other.
    pub fn start(&self) -> Packed {
        self.start
    }

    /// Whether nothing is left to chance: every action has one outcome in every state.
    pub fn is_deterministic(&self) -> bool {
        self.dynamics.is_deterministic(self.start)
    }
}

impl Watcher {
    /// Whether the task came to more stages than are kept: that there is no way is then not proved.
    pub fn is_over(&self) -> bool {
        self.is_over.get()
    }

    /// Whether a run that has come to a stage can never satisfy the task.
    pub fn has_failed(&self, stage: u8) -> bool {
        self.monitor.borrow().fails(Residual::at(stage))
    }

    /// Appends the leaps from a state that bears its stage; whether there are such.
    pub(super) fn leaps(&self, state: Packed, out: &mut Leaps<Packed>) -> bool {
        let mut strides = self.strides.borrow_mut();
        strides.as_mut().is_some_and(|own| own.leaps(&self.dynamics, self, state, out))
    }

    /// Appends the actions of the leap of this number; whether there are leaps.
    pub(super) fn way(&self, from: Packed, number: u16, out: &mut Vec<Action>) -> bool {
        let mut strides = self.strides.borrow_mut();
        strides.as_mut().is_some_and(|own| own.way(&self.dynamics, self, (from, number), out))
    }

    fn see(&self, from: Residual, state: Packed) -> u8 {
        let at_place = self.at_place[usize::from(self.dynamics.agent(state))];
        let others = valuation(&self.guards, !self.of_robot, &self.dynamics, state);
        self.progress(from, at_place | others)
    }

    fn progress(&self, from: Residual, holds: Valuation) -> u8 {
        self.monitor.borrow_mut().step(from, holds).map_or_else(
            |TooMany| {
                self.is_over.set(true);
                LOST
            },
            |residual| residual.index() as u8,
        )
    }

    /// A lower bound on the actions until a part is satisfied.
    fn bound(&self, monitor: &Monitor, part: usize, state: Packed) -> Option<u32> {
        match monitor.part_at(part)? {
            Part::Done | Part::Always(_) => Some(0),
            Part::Failed => None,
            Part::Until { reach, then, .. } => {
                let there = self.guards[*reach].bound(&self.dynamics, state)?;
                let onwards = there + self.onwards(monitor, *reach, *then)?;
                Some(onwards.max(self.bound(monitor, *then, state)?).max(1))
            }
            Part::All(parts) => parts
                .iter()
                .try_fold(0, |most, &part| Some(most.max(self.bound(monitor, part, state)?))),
            Part::Any(parts) => {
                parts.iter().filter_map(|&part| self.bound(monitor, part, state)).min()
            }
        }
    }

    /// A lower bound on the actions from where a guard holds until a part is satisfied.
    fn onwards(&self, monitor: &Monitor, from: usize, part: usize) -> Option<u32> {
        match monitor.part_at(part)? {
            Part::Done | Part::Always(_) => Some(0),
            Part::Failed => None,
            Part::Until { reach, then, .. } => {
                Some(self.legs[from][*reach]? + self.onwards(monitor, *reach, *then)?)
            }
            Part::All(parts) => parts
                .iter()
                .try_fold(0, |most, &part| Some(most.max(self.onwards(monitor, from, part)?))),
            Part::Any(parts) => {
                parts.iter().filter_map(|&part| self.onwards(monitor, from, part)).min()
            }
        }
    }
}

impl Stages for Watcher {
    fn seen(&self, stage: u8, state: Packed) -> u8 {
        self.step(stage, state)
    }

    fn of_others(&self, state: Packed) -> Option<Valuation> {
        let others = valuation(&self.guards, !self.of_robot, &self.dynamics, state);
        (!self.is_mixed).then_some(others)
    }

    fn seen_at(&self, stage: u8, place: Place, others: Valuation) -> u8 {
        if stage == LOST {
            return LOST;
        }
        self.progress(Residual::at(stage), self.at_place[usize::from(place)] | others)
    }
}

impl Watch<Packed> for Watcher {
    fn begin(&self, state: Packed) -> u8 {
        self.see(Monitor::START, state)
    }

    fn step(&self, stage: u8, state: Packed) -> u8 {
        if stage == LOST { LOST } else { self.see(Residual::at(stage), state) }
    }

    fn is_satisfied(&self, stage: u8) -> bool {
        stage != LOST && self.monitor.borrow().satisfies(Residual::at(stage))
    }

    fn least(&self, stage: u8, state: Packed) -> Option<u32> {
        let monitor = self.monitor.borrow();
        let part = monitor.part_of(Residual::at(stage)).filter(|_| stage != LOST)?;
        let bound = self.bound(&monitor, part, state)?;
        let Some(itinerary) = &self.itinerary else { return Some(bound) };
        Some(bound.max(itinerary.least(self.dynamics.agent(state), usize::from(stage))?))
    }
}

impl Mdp for Moves {
    type State = Packed;
    type Action = Action;

    fn initial(&self) -> Packed {
        self.dynamics.quotient(self.start)
    }

    fn actions(&self) -> &[Action] {
        self.dynamics.actions()
    }

    fn successors(&self, state: Packed, action: Action, out: &mut Vec<(Packed, f64)>) {
        merged(&self.dynamics, state, action, out);
    }

    fn is_terminal(&self, _: Packed) -> bool {
        false
    }
}
