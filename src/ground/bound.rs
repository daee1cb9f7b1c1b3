//! Lower bounds on the way to a goal: an atom's is exact in an empty world (`distance`), a disjunction's the smallest
//! of its parts, a conjunction's the largest, or what its objects add up to if that is more: an action moves one object
//! by one cell, so moves of distinct objects add up; the robot's steps do not, but for those to the first object
//! that must move (a cost partition: Katz and Domshlak 2010).
//! Doors that turned out to be locked count: there are tables for every set of such doors, of the few that matter most,
//! and for each other door alone; a way behind many is at least as long as behind each of them.
//! Where chance plays a part, values are bounded too: see [`BoundOf::most`].
//! Invariant: bounds are admissible and consistent; locks only make a way longer.

use super::distance::{Ground, Moves, Steps, Table};
use super::wish::{Atom, Load, Node, Wishes, place};
use crate::domain::layout::Place;
use crate::domain::{Direction, Dynamics, Lock, Packed};
use crate::logic::order;
use crate::mdp::power;
use std::cmp::Reverse;

/// Most entries of all tables; above it the locks of fewer doors count.
const MAX_ENTRIES: usize = 16_000_000;
/// Most entries of tables for sets of doors, and most doors that are in them.
const MAX_SET_ENTRIES: usize = 6_000_000;
const MAX_SETS: usize = 5;
/// More actions than any way has.
const NEVER: u32 = u32::MAX;
/// Most loads of which all orders are tried.
const MOST_ORDERED: usize = 5;

/// The bounds of a goal.
#[derive(Clone, Debug)]
pub(super) struct BoundOf {
    /// For each set of `doors` being locked, as a binary number; the other doors are as at the outset.
    tables: Vec<Tables>,
    /// Doors that nobody tried, those that matter most first.
    doors: Vec<usize>,
    /// Others, each with the tables if it alone is locked.
    others: Vec<(usize, Tables)>,
}

#[derive(Clone, Debug)]
struct Tables {
    by_wish: Vec<Table>,
    /// By wish, the moves of its object when there is only one.
    moves: Vec<Option<Moves>>,
    /// Known when they are wanted.
    steps: Steps,
}

impl BoundOf {
    /// The tables of these wishes in the world as it is in `initial`.
    pub(super) fn new(
        wishes: &Wishes,
        (root, atoms): (&Node, &[Atom]),
        dynamics: &Dynamics,
        initial: Packed,
    ) -> Self {
        let of = |packed: Packed| {
            let ground = Ground::new(dynamics, packed, wishes.are_together);
            let by_wish: Vec<Table> =
                wishes.all.iter().map(|wish| wish.table(dynamics, &ground)).collect();
            let two = |table: &Table| matches!(table, Table::Fetch { .. });
            let is_walked = wishes.are_together || by_wish.iter().any(two);
            Tables {
                moves: wishes.all.iter().map(|wish| wish.moves(dynamics, &ground)).collect(),
                steps: if is_walked { ground.steps() } else { Steps::default() },
                by_wish,
            }
        };
        let first = of(initial);
        let entries = first.len().max(1);
        let untried = (0..dynamics.n_doors())
            .filter(|&door| dynamics.lock(initial, door) == Some(Lock::Unknown))
            .take((MAX_ENTRIES / entries).saturating_sub(1));
        let lock = |packed, door| dynamics.with_lock(packed, door, Lock::Locked);
        let mut others: Vec<(usize, Tables)> =
            untried.map(|door| (door, of(lock(initial, door)))).collect();
        // Those without which the way is longest; the first of equals.
        order::sort_by_key(&mut others, |(_, tables)| {
            let without = At { tables, atoms, dynamics, packed: initial }.node(root);
            Reverse(without.unwrap_or(u32::MAX))
        });
        let fits = |k: &usize| entries << k <= MAX_SET_ENTRIES;
        let most = (0..=MAX_SETS.min(others.len())).rev().find(fits).unwrap_or(0);
        let mut tables = vec![first];
        let mut doors = Vec::new();
        for (door, alone) in others.drain(..most) {
            let with: Vec<usize> = (1..tables.len()).collect();
            tables.push(alone);
            for set in with {
                let locked = doors.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1);
                let locked = locked.fold(initial, |packed, (_, &door)| lock(packed, door));
                tables.push(of(lock(locked, door)));
            }
            doors.push(door);
        }
        Self { tables, doors, others }
    }

    /// A lower bound on the actions from a state to the goal at `root`; `None` when no number suffices.
    pub(super) fn least(
        &self,
        root: &Node,
        atoms: &[Atom],
        dynamics: &Dynamics,
        packed: Packed,
    ) -> Option<u32> {
        let least = |tables| At { tables, atoms, dynamics, packed }.node(root);
        let is_locked = |door: usize| dynamics.lock(packed, door) == Some(Lock::Locked);
        let others = self.others.iter().filter(|(door, _)| is_locked(*door));
        let first = least(self.of(dynamics, packed))?;
        others.map(|(_, tables)| least(tables)).try_fold(first, |most, n| Some(most.max(n?)))
    }

    /// The tables for the doors that are locked in a state.
    fn of(&self, dynamics: &Dynamics, packed: Packed) -> &Tables {
        let is_locked = |door: usize| dynamics.lock(packed, door) == Some(Lock::Locked);
        let locked = self.doors.iter().enumerate().filter(|(_, door)| is_locked(**door));
        &self.tables[locked.fold(0, |set, (i, _)| set | 1 << i)]
    }

    /// A lower bound on the actions until all loads are where they should be, by their moves; what two need is known
    /// otherwise.
    pub(super) fn sum(
        &self,
        loads: &[Load],
        atoms: &[Atom],
        dynamics: &Dynamics,
        packed: Packed,
    ) -> Option<u32> {
        if loads.len() < 3 {
            return Some(0);
        }
        At { tables: self.of(dynamics, packed), atoms, dynamics, packed }.together(loads)
    }

    /// A lower bound on the actions until a load is where it should be.
    pub(super) fn part(
        &self,
        load: &Load,
        atoms: &[Atom],
        dynamics: &Dynamics,
        packed: Packed,
    ) -> Option<u32> {
        let at = At { tables: self.of(dynamics, packed), atoms, dynamics, packed };
        at.rest(load).map(|rest| if rest == 0 { 0 } else { at.brought(at.robot(), load).0.max(1) })
    }

    /// The loads that are not where they should be, each with the guess if it is brought first; the least first.
    pub(super) fn parts(
        &self,
        loads: &[Load],
        atoms: &[Atom],
        dynamics: &Dynamics,
        packed: Packed,
    ) -> Vec<(u32, usize)> {
        let at = At { tables: self.of(dynamics, packed), atoms, dynamics, packed };
        let left = |load: &usize| at.rest(&loads[*load]) != Some(0);
        let indices: Vec<usize> = (0..loads.len().min(64)).filter(left).collect();
        let wanted: Vec<&Load> = indices.iter().map(|&load| &loads[load]).collect();
        let mut parts: Vec<(u32, usize)> =
            at.tours(at.robot(), &wanted).into_iter().zip(indices).collect();
        order::sort_by_key(&mut parts, |&part| part);
        parts
    }

    /// A guess at the actions from a state to the goal at `root`, no less than the bound: what it takes to bring its
    /// objects one after the other in the best order, as if none were in the way of another.
    pub(super) fn guess(
        &self,
        root: &Node,
        atoms: &[Atom],
        dynamics: &Dynamics,
        packed: Packed,
    ) -> Option<u32> {
        At { tables: self.of(dynamics, packed), atoms, dynamics, packed }.in_turn(root)
    }

    /// An upper bound on the discounted value of a state: what a robot would earn that knew beforehand which doors will
    /// turn out to be locked (so it is a sum over sets of doors), in a world where nothing is in the way; every action
    /// that slips, and every move of an object that is lost, is tried until it succeeds.
    pub(super) fn most(
        &self,
        root: &Node,
        atoms: &[Atom],
        dynamics: &Dynamics,
        packed: Packed,
        discount: f64,
    ) -> f64 {
        let chances = dynamics.rules().chances;
        let tried = |chance: f64| (1.0 - chance) / (1.0 - discount * chance);
        let (action, moved) = (tried(chances.slip()), tried(chances.loss()));
        let worth = |n: u32, moves| {
            power(discount, n.saturating_sub(1)) * power(action, n) * power(moved, moves)
        };
        let at = |tables| At { tables, atoms, dynamics, packed };
        let lock = chances.lock();
        // What the other doors leave at least, if they are known to be locked; and if they turn out to be.
        let mut known = 0;
        let mut open = Vec::with_capacity(self.others.len());
        for (door, tables) in &self.others {
            let n = || at(tables).node(root).unwrap_or(NEVER);
            match dynamics.lock(packed, *door) {
                Some(Lock::Unknown) => open.push(n()),
                Some(Lock::Locked) => known = known.max(n()),
                _ => {}
            }
        }
        order::sort_by_key(&mut open, |&n| Reverse(n));
        let by = |tables| {
            let (Some(n), Some(moves)) = (at(tables).node(root), at(tables).moves(root)) else {
                return 0.0;
            };
            let n = n.max(known);
            // By the first of them that is locked: those after it leave less.
            let (mut sum, mut left) = (0.0, 1.0);
            for &longer in open.iter().take_while(|&&longer| longer > n) {
                sum += if longer == NEVER { 0.0 } else { left * lock * worth(longer, moves) };
                left *= 1.0 - lock;
            }
            sum + if n == NEVER { 0.0 } else { left * worth(n, moves) }
        };
        let mut sum = 0.0;
        for (set, tables) in self.tables.iter().enumerate() {
            let mut chance = 1.0;
            for (i, &door) in self.doors.iter().enumerate() {
                let wanted = set >> i & 1 == 1;
                chance *= match dynamics.lock(packed, door) {
                    Some(Lock::Unknown) if wanted => lock,
                    Some(Lock::Unknown) => 1.0 - lock,
                    found => f64::from(u8::from((found == Some(Lock::Locked)) == wanted)),
                };
            }
            if chance > 0.0 {
                sum += chance * by(tables);
            }
        }
        sum
    }
}

impl Tables {
    /// How many entries they have.
    fn len(&self) -> usize {
        self.by_wish.iter().map(Table::len).sum::<usize>() + self.steps.len()
    }
}

/// A state, and the tables that are right for it.
struct At<'a> {
    tables: &'a Tables,
    atoms: &'a [Atom],
    dynamics: &'a Dynamics,
    packed: Packed,
}

impl At<'_> {
    /// A lower bound on the actions that a part of the goal needs.
    fn node(&self, node: &Node) -> Option<u32> {
        match node {
            Node::All(all) => largest(all, |n| self.node(n)),
            Node::Together(all, loads) => {
                let most = largest(all, |n| self.node(n))?;
                Some(self.together(loads)?.max(most))
            }
            Node::Any(any) => any.iter().filter_map(|n| self.node(n)).min(),
            Node::Atom(index) => {
                let Tables { by_wish, steps, .. } = self.tables;
                by_wish[self.atoms[*index].wish].bound(steps, self.robot(), self.places(*index))
            }
        }
    }

    /// A lower bound on the moves of objects that a part of the goal needs.
    fn moves(&self, node: &Node) -> Option<u32> {
        match node {
            Node::All(all) => largest(all, |n| self.moves(n)),
            Node::Together(all, loads) => {
                let most = largest(all, |n| self.moves(n))?;
                let sum = loads.iter().map(|load| self.rest(load)).sum::<Option<u32>>()?;
                Some(sum.max(most))
            }
            Node::Any(any) => any.iter().filter_map(|n| self.moves(n)).min(),
            Node::Atom(index) => self.moves_of(*index),
        }
    }

    /// A lower bound on the moves of objects that an atom needs.
    fn moves_of(&self, index: usize) -> Option<u32> {
        let wish = self.atoms[index].wish;
        let (first, second) = self.places(index);
        match &self.tables.moves[wish] {
            Some(moves) => moves.from(first),
            None => self.tables.by_wish[wish].moves(first, second),
        }
    }

    /// The moves that a load needs.
    fn rest(&self, load: &Load) -> Option<u32> {
        match load {
            Load::One { object, wishes } => {
                let at = self.dynamics.object(self.packed, *object);
                let moves = |&wish: &usize| self.tables.moves[wish].as_ref();
                largest(wishes, |wish| moves(wish).map_or(Some(0), |moves| moves.from(at)))
            }
            Load::Two(index) => self.moves_of(*index),
        }
    }

    /// The moves of all loads, of which an action makes at most one, and the way to the first of them. To begin with
    /// a load that is where it should be costs a move away from there and one back: so one action never takes more
    /// than one from the sum.
    fn together(&self, loads: &[Load]) -> Option<u32> {
        let robot = self.dynamics.agent(self.packed);
        let (mut sum, mut walk) = (0, u32::MAX);
        for load in loads {
            let rest = self.rest(load)?;
            let (first, second) = match load {
                Load::One { object, .. } => {
                    let at = self.dynamics.object(self.packed, *object);
                    (at, at)
                }
                Load::Two(index) => self.places(*index),
            };
            let steps = &self.tables.steps;
            let ways = [steps.between(robot, first), steps.between(robot, second)];
            sum += rest;
            match ways.into_iter().flatten().min() {
                Some(way) => walk = walk.min(if rest > 0 { way } else { way + 2 }),
                None if rest > 0 => return None,
                None => {}
            }
        }
        Some(if sum == 0 { 0 } else { sum + walk.saturating_sub(1) })
    }

    /// What a part of the goal needs when its objects are brought one after the other.
    fn in_turn(&self, node: &Node) -> Option<u32> {
        let least = self.node(node)?;
        let guess = match node {
            Node::All(all) => largest(all, |n| self.in_turn(n))?,
            Node::Together(_, loads) => {
                let left: Vec<&Load> =
                    loads.iter().filter(|load| self.rest(load) != Some(0)).collect();
                self.tours(self.robot(), &left).into_iter().min().unwrap_or(0)
            }
            Node::Any(any) => any.iter().filter_map(|n| self.in_turn(n)).min()?,
            Node::Atom(_) => least,
        };
        Some(guess.max(least))
    }

    /// For each load, the actions to bring all of them one after the other beginning with it, in the best order; of many
    /// the next one is always that which is nearest. Where the robot ends does not depend on where it came from.
    fn tours(&self, robot: (Place, Direction), loads: &[&Load]) -> Vec<u32> {
        let n = loads.len();
        let first: Vec<_> = loads.iter().map(|load| self.brought(robot, load)).collect();
        let then = |i: usize, j: usize| self.brought(first[i].1, loads[j]).0;
        let costs: Vec<u32> = (0..n * n).map(|at| then(at / n, at % n)).collect();
        if n > MOST_ORDERED {
            let tour = |begin: usize| {
                let (mut at, mut sum, mut left) = (begin, first[begin].0, (1_u64 << n) - 1);
                loop {
                    left &= !(1 << at);
                    let others = (0..n).filter(|j| left >> j & 1 == 1);
                    let Some(next) = others.min_by_key(|j| costs[at * n + j]) else { break sum };
                    sum += costs[at * n + next];
                    at = next;
                }
            };
            return (0..n).map(tour).collect();
        }
        // By the set of loads that are left and the last one brought (Held and Karp 1962).
        let mut rest = vec![0_u32; n << n];
        for set in 1..1_usize << n {
            for last in (0..n).filter(|last| set >> last & 1 == 0) {
                let next = (0..n).filter(|j| set >> j & 1 == 1);
                let best = next.map(|j| costs[last * n + j] + rest[(set & !(1 << j)) * n + j]);
                rest[set * n + last] = best.min().unwrap_or(0);
            }
        }
        let all = (1 << n) - 1;
        (0..n).map(|i| first[i].0 + rest[(all & !(1 << i)) * n + i]).collect()
    }

    /// The actions to bring a load, and the robot's pose then.
    fn brought(&self, robot: (Place, Direction), load: &Load) -> (u32, (Place, Direction)) {
        let Tables { by_wish, steps, .. } = self.tables;
        match load {
            Load::One { object, wishes } => {
                let at = self.dynamics.object(self.packed, *object);
                let fetched = wishes.iter().filter_map(|&wish| by_wish[wish].fetched(robot, at));
                fetched.max_by_key(|fetched| fetched.0).unwrap_or((0, robot))
            }
            Load::Two(index) => {
                let places = self.places(*index);
                let table = &by_wish[self.atoms[*index].wish];
                (table.bound(steps, robot, places).unwrap_or(0), (places.0, robot.1))
            }
        }
    }

    /// Where the robot is, and which way it looks.
    fn robot(&self) -> (Place, Direction) {
        (self.dynamics.agent(self.packed), self.dynamics.heading(self.packed))
    }

    /// Where the things of an atom are.
    fn places(&self, index: usize) -> (Place, Place) {
        let atom = &self.atoms[index];
        let at = |body| place(body, self.dynamics, self.packed);
        (at(atom.first), at(atom.second))
    }
}

/// The largest of numbers, 0 of none; `None` when one is.
fn largest<T>(all: &[T], of: impl Fn(&T) -> Option<u32>) -> Option<u32> {
    all.iter().try_fold(0, |most, one| of(one).map(|number| number.max(most)))
}
