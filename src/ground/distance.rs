//! Lower bounds on the way to an atomic goal, exact in a world with nothing in it but the things the atom
//! speaks of and what never moves (a projection, so admissible and consistent: Edelkamp 2001); where the robot
//! faces counts in the robot form, and not in compass form. Found once by breadth-first search backwards from
//! the places that fulfil the atom. Units: actions. A door that is locked is wall; one that nobody tried opens.
//! Slips, doors that lock and losses only make the way longer.

use crate::domain::layout::{NOWHERE, Place};
use crate::domain::{Direction, Dynamics, Form, Packed};
use std::collections::VecDeque;

/// Out of reach.
const NEVER: u16 = u16::MAX;

/// Most entries of a table; above it bounds are weaker.
const MAX_ENTRIES: usize = 4_000_000;

/// The places of a world at the outset and how one moves between them. A pose is a place of the robot, in the
/// robot form times its heading.
pub(super) struct Ground<'a> {
    dynamics: &'a Dynamics,
    pull: bool,
    /// 4 in the robot form, 1 in compass form, where the heading does not count.
    headings: usize,
    /// Whether a place can be entered.
    opens: Vec<bool>,
    /// Whether tables tell where the robot ends.
    wants_ends: bool,
}

/// Actions still needed, by pose or places.
#[derive(Clone, Debug)]
pub(super) enum Table {
    /// By the robot's pose.
    Robot { headings: usize, rest: Vec<u16> },
    /// By an object's place, times the number of poses, and the robot's pose, for it walks more often than it carries.
    /// `ends` has the pose that the robot ends in then, if it was wanted.
    Carry { headings: usize, poses: usize, rest: Vec<u16>, ends: Vec<u16> },
    /// Moves of either of two objects by their places.
    Fetch { n: usize, moves: Vec<u16> },
    /// Nothing is known but whether it is fulfilled.
    Unknown,
}

impl Table {
    /// The bound for the robot with an object, or with two, at these places; `None` for never.
    #[inline]
    pub(super) fn bound(
        &self,
        steps: &Steps,
        robot: (Place, Direction),
        (one, other): (Place, Place),
    ) -> Option<u32> {
        let (first, second) = (usize::from(one), usize::from(other));
        match self {
            Self::Robot { headings, rest } => finite(rest[pose(*headings, robot)]),
            Self::Carry { headings, poses, rest, .. } => {
                finite(rest[second * poses + pose(*headings, robot)])
            }
            Self::Fetch { n, moves } => match finite(moves[second * n + first])? {
                0 => Some(0),
                moves => {
                    let walk = steps.between(robot.0, one).into_iter();
                    Some(moves + walk.chain(steps.between(robot.0, other)).min()?.saturating_sub(1))
                }
            },
            Self::Unknown => Some(0),
        }
    }

    /// The actions for the robot with an object at these places, and the place and heading that it ends in; `None` where
    /// these are not known.
    #[inline]
    pub(super) fn fetched(
        &self,
        robot: (Place, Direction),
        object: Place,
    ) -> Option<(u32, (Place, Direction))> {
        let Self::Carry { headings, poses, rest, ends } = self else { return None };
        let at = usize::from(object) * poses + pose(*headings, robot);
        let end = usize::from(*ends.get(at)?);
        let heading = if *headings == 1 { robot.1 } else { Direction::ALL[end % headings] };
        Some((finite(rest[at])?, (Place::try_from(end / headings).ok()?, heading)))
    }

    /// How many entries it has.
    pub(super) const fn len(&self) -> usize {
        match self {
            Self::Robot { rest, .. } | Self::Carry { rest, .. } => rest.len(),
            Self::Fetch { moves, .. } => moves.len(),
            Self::Unknown => 0,
        }
    }

    /// The moves that two objects need at these places, 0 when that is not known; `None` for never.
    #[inline]
    pub(super) fn moves(&self, first: Place, second: Place) -> Option<u32> {
        match self {
            Self::Fetch { n, moves } => finite(moves[usize::from(second) * n + usize::from(first)]),
            Self::Robot { .. } | Self::Carry { .. } | Self::Unknown => Some(0),
        }
    }
}

#[inline]
fn pose(headings: usize, (place, heading): (Place, Direction)) -> usize {
    usize::from(place) * headings + heading as usize % headings
}

/// A number of actions, unless it is never.
#[inline]
fn finite(actions: u16) -> Option<u32> {
    (actions != NEVER).then_some(u32::from(actions))
}

/// Steps of a robot up to a thing, by their places.
#[derive(Clone, Debug, Default)]
pub(super) struct Steps {
    n: usize,
    /// Empty in a world that is too large for it.
    steps: Vec<u16>,
}

impl Steps {
    /// How many entries there are.
    pub(super) const fn len(&self) -> usize {
        self.steps.len()
    }

    /// The steps, at least 1; `None` when no number suffices. 1 when nothing is known.
    #[inline]
    pub(super) fn between(&self, robot: Place, thing: Place) -> Option<u32> {
        let known = self.steps.get(usize::from(robot) * self.n + usize::from(thing));
        known.map_or(Some(1), |&steps| finite(steps))
    }
}

/// Moves of one object until it is where a goal wants it, by its place.
#[derive(Clone, Debug)]
pub(super) struct Moves(Vec<u16>);

impl Moves {
    /// The moves from a place; `None` when no number suffices.
    #[inline]
    pub(super) fn from(&self, place: Place) -> Option<u32> {
        finite(self.0[usize::from(place)])
    }
}

impl<'a> Ground<'a> {
    pub(super) fn new(dynamics: &'a Dynamics, initial: Packed, wants_ends: bool) -> Self {
        let layout = dynamics.layout();
        let mut opens: Vec<bool> = layout.places().map(|p| dynamics.opens(initial, p)).collect();
        for object in (0..dynamics.n_objects()).filter(|&o| !dynamics.can_move(o)) {
            opens[usize::from(dynamics.object(initial, object))] = false;
        }
        let headings = match dynamics.rules().form {
            Form::Compass => 1,
            Form::Robot => 4,
        };
        Self { dynamics, pull: dynamics.rules().pull, headings, opens, wants_ends }
    }

    /// By place, whether it can be entered.
    pub(super) fn opens(&self) -> &[bool] {
        &self.opens
    }

    /// How many places there are.
    fn len(&self) -> usize {
        self.opens.len()
    }

    /// Actions of the robot to a place that fulfils `goal`.
    pub(super) fn robot(&self, goal: impl Fn(Place) -> bool) -> Table {
        let goals = self.places().filter(|&p| goal(p)).map(|p| (p, 0));
        let mut search = Search::new(self, self.headings, 1, goals);
        while let Some((agent, heading, _)) = search.next() {
            for &direction in self.arrivals(heading) {
                let before = self.next(agent, direction.opposite());
                if before != NOWHERE && self.is_open(agent) {
                    search.reach((before, direction), 0);
                }
            }
            search.turn(agent, heading, 0);
        }
        Table::Robot { headings: self.headings, rest: search.rest }
    }

    /// Actions of the robot (first) with one object (second) until both are where `goal` wants them.
    pub(super) fn carry(&self, goal: impl Fn(Place, Place) -> bool) -> Table {
        if !self.has_room(self.headings) {
            return Table::Unknown;
        }
        let n = self.len();
        let mut search = Search::new(self, self.headings, n, std::iter::empty());
        if self.wants_ends && self.len() * self.headings < usize::from(u16::MAX) {
            search.ends.resize(search.rest.len(), 0);
        }
        search.begin(self.pairs(goal));
        while let Some((agent, heading, object)) = search.next() {
            let enters = self.is_open(agent);
            let swaps = self.pull && enters && self.is_open(object);
            for &direction in self.arrivals(heading) {
                let before = self.next(agent, direction.opposite());
                let faces = self.next(agent, direction) == object;
                if enters && before != NOWHERE {
                    if before != object {
                        search.reach((before, direction), object);
                    }
                    if faces && self.is_open(object) {
                        search.reach((before, direction), agent);
                    }
                }
                if swaps && faces {
                    search.reach((object, direction.opposite()), agent);
                }
            }
            search.turn(agent, heading, object);
        }
        let (headings, poses) = (self.headings, search.poses);
        Table::Carry { headings, poses, rest: search.rest, ends: search.ends }
    }

    /// Moves of two objects, one cell a move, until `goal` holds of them; and the robot's way to one.
    pub(super) fn two_objects(&self, goal: impl Fn(Place, Place) -> bool) -> Table {
        if !self.has_room(1) {
            return Table::Unknown;
        }
        let n = self.len();
        let mut search = Search::new(self, 1, n, self.pairs(goal));
        while let Some((first, _, second)) = search.next() {
            for &direction in Direction::ALL {
                if let Some(before) = self.moved_from(first, direction, second) {
                    search.reach((before, direction), second);
                }
                if let Some(before) = self.moved_from(second, direction, first) {
                    search.reach((first, direction), before);
                }
            }
        }
        Table::Fetch { n, moves: search.rest }
    }

    /// Moves of one object until `goal` holds of it.
    pub(super) fn moves(&self, goal: impl Fn(Place) -> bool) -> Moves {
        let goals = self.places().filter(|&p| goal(p)).map(|p| (p, 0));
        let mut search = Search::new(self, 1, 1, goals);
        while let Some((object, ..)) = search.next() {
            for &direction in Direction::ALL {
                if let Some(before) = self.moved_from(object, direction, NOWHERE) {
                    search.reach((before, direction), 0);
                }
            }
        }
        Moves(search.rest)
    }

    /// The place on this side that an object may have been moved here from; not that of another thing.
    fn moved_from(&self, object: Place, direction: Direction, other: Place) -> Option<Place> {
        let before = self.next(object, direction);
        let can_move = before != NOWHERE
            && before != other
            && self.is_open(object)
            // To push it from there, the robot must stand behind it.
            && (self.pull || self.next(before, direction) != NOWHERE);
        can_move.then_some(before)
    }

    /// Steps of the robot, from everywhere to everywhere.
    pub(super) fn steps(&self) -> Steps {
        let n = self.len();
        let mut steps = Vec::new();
        if self.has_room(1) {
            steps.resize(n * n, NEVER);
            for to in self.places() {
                for (from, &d) in self.steps_to(to).iter().enumerate() {
                    steps[from * n + usize::from(to)] = d;
                }
            }
        }
        Steps { n, steps }
    }

    /// Steps of the robot to a place, wherever it faces.
    fn steps_to(&self, to: Place) -> Vec<u16> {
        let mut search = Search::new(self, 1, 1, std::iter::once((to, 0)));
        while let Some((place, ..)) = search.next() {
            for &direction in Direction::ALL {
                let before = self.next(place, direction);
                if before != NOWHERE && self.is_open(place) {
                    search.reach((before, direction), 0);
                }
            }
        }
        search.rest
    }

    fn places(&self) -> impl Iterator<Item = Place> + use<> {
        self.dynamics.layout().places()
    }

    /// The places of two things that fulfil a goal.
    fn pairs(&self, goal: impl Fn(Place, Place) -> bool) -> impl Iterator<Item = (Place, Place)> {
        let all = self.places().flat_map(|a| self.places().map(move |b| (a, b)));
        all.filter(move |&(a, b)| a != b && goal(a, b))
    }

    fn has_room(&self, headings: usize) -> bool {
        self.len().saturating_mul(self.len()).saturating_mul(headings) <= MAX_ENTRIES
    }

    /// The directions in which a robot that looks this way may have come.
    fn arrivals(&self, heading: usize) -> &'static [Direction] {
        if self.headings == 1 { Direction::ALL } else { &Direction::ALL[heading..=heading] }
    }

    fn next(&self, place: Place, direction: Direction) -> Place {
        self.dynamics.layout().neighbour(place, direction)
    }

    fn is_open(&self, place: Place) -> bool {
        self.opens[usize::from(place)]
    }
}

/// A breadth-first search over a robot's poses and a thing's places, backwards from those that fulfil a goal.
struct Search {
    headings: usize,
    poses: usize,
    /// By the thing's place and the robot's pose.
    rest: Vec<u16>,
    /// The pose at the end; empty if it is not wanted.
    ends: Vec<u16>,
    queue: VecDeque<(u32, Place)>,
    depth: u16,
    end: Option<u16>,
}

impl Search {
    /// From the goal's places, with any heading; the thing has `n` places.
    fn new(
        ground: &Ground<'_>,
        headings: usize,
        n: usize,
        goals: impl Iterator<Item = (Place, Place)>,
    ) -> Self {
        let poses = ground.len() * headings;
        let rest = vec![NEVER; n * poses];
        let (ends, queue) = (Vec::new(), VecDeque::new());
        let mut search = Self { headings, poses, rest, ends, queue, depth: 0, end: None };
        search.begin(goals);
        search
    }

    fn begin(&mut self, goals: impl Iterator<Item = (Place, Place)>) {
        for (agent, thing) in goals {
            for &heading in &Direction::ALL[..self.headings] {
                self.reach((agent, heading), thing);
            }
        }
    }

    /// The next place and heading of the robot, and place of the thing.
    fn next(&mut self) -> Option<(Place, usize, Place)> {
        let (pose, thing) = self.queue.pop_front()?;
        let pose = pose as usize;
        let at = usize::from(thing) * self.poses + pose;
        self.depth = (self.rest[at] + 1).min(NEVER - 1);
        self.end = self.ends.get(at).copied();
        // A pose is made from a place, times at most four.
        let place = Place::try_from(pose / self.headings).unwrap_or(NOWHERE);
        Some((place, pose % self.headings, thing))
    }

    fn reach(&mut self, robot: (Place, Direction), thing: Place) {
        let pose = pose(self.headings, robot);
        let at = usize::from(thing) * self.poses + pose;
        if self.rest[at] == NEVER {
            self.rest[at] = self.depth;
            if let Some(end) = self.ends.get_mut(at) {
                *end = self.end.unwrap_or(pose as u16);
            }
            self.queue.push_back((pose as u32, thing));
        }
    }

    /// Reaches what lies a quarter turn before.
    fn turn(&mut self, agent: Place, heading: usize, thing: Place) {
        if self.headings > 1 {
            let left = Direction::ALL[heading].left();
            self.reach((agent, left), thing);
            self.reach((agent, left.opposite()), thing);
        }
    }
}
