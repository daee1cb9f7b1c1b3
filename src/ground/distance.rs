//! Lower bounds on the way to an atomic goal, exact in a world with nothing in it but the things the atom
//! speaks of, and without regard to where the robot faces (a projection, so admissible and consistent:
//! Edelkamp 2001). Found once by breadth-first search backwards from the places that fulfil the atom.
//! Units: actions. A door that is locked is wall; one that nobody tried opens.

use crate::domain::layout::{NOWHERE, Place};
use crate::domain::{Direction, Dynamics, Packed};
use std::collections::VecDeque;

/// Out of reach.
const NEVER: u16 = u16::MAX;

/// Most pairs of places that a table holds; above it bounds are weaker.
const MAX_PAIRS: usize = 4_000_000;

/// The places of a world at the outset and how one moves between them.
pub(super) struct Ground<'a> {
    dynamics: &'a Dynamics,
    pull: bool,
    /// Whether a place can be entered.
    opens: Vec<bool>,
}

/// Actions still needed, by place or by pair of places.
#[derive(Clone, Debug)]
pub(super) enum Table {
    /// By the place of one thing.
    Single(Vec<u16>),
    /// By the places of two things, the first times the number of places.
    Pair { n: usize, rest: Vec<u16> },
    /// Moves of either of two things by their places, and the steps of a robot up to a thing by theirs.
    Fetch { n: usize, moves: Vec<u16>, steps: Vec<u16> },
    /// Nothing is known but whether it is fulfilled.
    Unknown,
}

impl Table {
    /// The bound for the thing, or for two things with the robot, at these places; `None` for never.
    #[inline]
    pub(super) fn bound(&self, agent: Place, first: Place, second: Place) -> Option<u32> {
        let finite = |d: u16| (d != NEVER).then_some(u32::from(d));
        let (agent, first, second) = (usize::from(agent), usize::from(first), usize::from(second));
        match self {
            Self::Single(rest) => finite(rest[first]),
            Self::Pair { n, rest } => finite(rest[first * n + second]),
            Self::Fetch { n, moves, steps } => match finite(moves[first * n + second])? {
                0 => Some(0),
                moves => {
                    let walk = steps[agent * n + first].min(steps[agent * n + second]);
                    Some(moves + finite(walk)?.saturating_sub(1))
                }
            },
            Self::Unknown => Some(0),
        }
    }
}

impl<'a> Ground<'a> {
    pub(super) fn new(dynamics: &'a Dynamics, initial: Packed) -> Self {
        let opens = dynamics.layout().places().map(|p| dynamics.opens(initial, p)).collect();
        Self { dynamics, pull: dynamics.rules().pull, opens }
    }

    /// How many places there are.
    pub(super) fn len(&self) -> usize {
        self.opens.len()
    }

    /// Steps of one thing, moved by itself, to a place that fulfils `goal`.
    pub(super) fn single(&self, goal: impl Fn(Place) -> bool) -> Table {
        Table::Single(self.steps_to(goal))
    }

    /// Actions of the robot (first) with one object (second) until both are where `goal` wants them.
    pub(super) fn with_object(&self, goal: impl Fn(Place, Place) -> bool) -> Table {
        if !self.has_room() {
            return Table::Unknown;
        }
        let mut search = Search::new(self, goal);
        while let Some((agent, object)) = search.next() {
            for &direction in Direction::ALL {
                let before = self.next(agent, direction.opposite());
                if before == NOWHERE || !self.is_open(agent) {
                    continue;
                }
                if before != object {
                    search.reach(before, object);
                }
                if self.next(agent, direction) == object && self.is_open(object) {
                    search.reach(before, agent);
                }
            }
            let swaps = self.pull && self.is_open(agent) && self.is_open(object);
            if swaps && Direction::ALL.iter().any(|&d| self.next(agent, d) == object) {
                search.reach(object, agent);
            }
        }
        Table::Pair { n: self.len(), rest: search.rest }
    }

    /// Moves of two objects, one cell a move, until `goal` holds of them; and the robot's way to one.
    pub(super) fn two_objects(&self, goal: impl Fn(Place, Place) -> bool) -> Table {
        if !self.has_room() {
            return Table::Unknown;
        }
        let mut search = Search::new(self, goal);
        while let Some((first, second)) = search.next() {
            for &direction in Direction::ALL {
                for (moved, other, is_first) in [(first, second, true), (second, first, false)] {
                    let before = self.next(moved, direction);
                    // To push it from there, the robot must stand behind it.
                    let can_move =
                        before != NOWHERE && (self.pull || self.next(before, direction) != NOWHERE);
                    if can_move && before != other && self.is_open(moved) {
                        let (a, b) = if is_first { (before, other) } else { (other, before) };
                        search.reach(a, b);
                    }
                }
            }
        }
        let n = self.len();
        let mut steps = vec![NEVER; n * n];
        for to in self.dynamics.layout().places() {
            for (from, &d) in self.steps_to(|p| p == to).iter().enumerate() {
                steps[from * n + usize::from(to)] = d;
            }
        }
        Table::Fetch { n, moves: search.rest, steps }
    }

    fn steps_to(&self, goal: impl Fn(Place) -> bool) -> Vec<u16> {
        let mut rest = vec![NEVER; self.len()];
        let mut queue: VecDeque<Place> =
            self.dynamics.layout().places().filter(|&p| goal(p)).collect();
        for &place in &queue {
            rest[usize::from(place)] = 0;
        }
        while let Some(place) = queue.pop_front() {
            if !self.is_open(place) {
                continue;
            }
            for &direction in Direction::ALL {
                let before = self.next(place, direction);
                if before != NOWHERE && rest[usize::from(before)] == NEVER {
                    rest[usize::from(before)] = (rest[usize::from(place)] + 1).min(NEVER - 1);
                    queue.push_back(before);
                }
            }
        }
        rest
    }

    fn has_room(&self) -> bool {
        self.len().saturating_mul(self.len()) <= MAX_PAIRS
    }

    fn next(&self, place: Place, direction: Direction) -> Place {
        self.dynamics.layout().neighbour(place, direction)
    }

    fn is_open(&self, place: Place) -> bool {
        self.opens[usize::from(place)]
    }
}

/// A breadth-first search over pairs of places, backwards from those that fulfil a goal.
struct Search {
    n: usize,
    rest: Vec<u16>,
    queue: VecDeque<(Place, Place)>,
    depth: u16,
}

impl Search {
    fn new(ground: &Ground<'_>, goal: impl Fn(Place, Place) -> bool) -> Self {
        let n = ground.len();
        let mut search = Self { n, rest: vec![NEVER; n * n], queue: VecDeque::new(), depth: NEVER };
        for first in ground.dynamics.layout().places() {
            for second in ground.dynamics.layout().places() {
                if first != second && goal(first, second) {
                    search.rest[usize::from(first) * n + usize::from(second)] = 0;
                    search.queue.push_back((first, second));
                }
            }
        }
        search
    }

    fn next(&mut self) -> Option<(Place, Place)> {
        let (first, second) = self.queue.pop_front()?;
        let depth = self.rest[usize::from(first) * self.n + usize::from(second)];
        self.depth = (depth + 1).min(NEVER - 1);
        Some((first, second))
    }

    fn reach(&mut self, first: Place, second: Place) {
        let rest = &mut self.rest[usize::from(first) * self.n + usize::from(second)];
        if *rest == NEVER {
            *rest = self.depth;
            self.queue.push_back((first, second));
        }
    }
}
