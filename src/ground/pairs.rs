//! Bounds for conjunctions that price the walks between objects and what stands in the way: for every two objects that
//! a goal wants moved, the actions of a robot that brings both, exact in a world with nothing else in it (pattern
//! databases: Culberson and Schaeffer 1998, Edelkamp 2001). In compass form, without headings. Found by breadth-first
//! search backwards, in parts; the largest of all pairs counts, so the bound is admissible and consistent.
//! Objects that are wanted alike share a table.

use super::distance::Ground;
use crate::domain::layout::{NOWHERE, Place};
use crate::domain::{Dynamics, Packed};
use crate::logic::order;

/// Most entries of all tables together, a byte each.
const MOST_ENTRIES: usize = 12_000_000;
/// Never; what takes longer than a byte holds counts as little less.
const NEVER: u8 = u8::MAX;

/// Tables that are being made.
#[derive(Clone, Debug)]
pub(super) struct Pairs {
    /// The places that may be entered, and the neighbours of each place.
    opens: Vec<bool>,
    next: Vec<[Place; 4]>,
    pull: bool,
    /// What is wanted of objects: the places that will do, each once.
    wants: Vec<Vec<bool>>,
    /// The objects, each with the index of what is wanted of it.
    loads: Vec<(usize, usize)>,
    /// By what is wanted of the first and of the second, in this order.
    tables: Vec<((usize, usize), Vec<u8>)>,
    /// Entries of the last table in the order found, and how many of them were looked at.
    queue: Vec<u32>,
    at: usize,
}

impl Pairs {
    /// Nothing made yet, for objects that must come to one of these places each; `None` when there is nothing to be had.
    pub(super) fn new(
        dynamics: &Dynamics,
        ground: &Ground<'_>,
        loads: &[(usize, Vec<bool>)],
    ) -> Option<Self> {
        let layout = dynamics.layout();
        let mut pairs = Self {
            opens: ground.opens().to_vec(),
            next: layout.places().map(|place| layout.neighbours(place)).collect(),
            pull: dynamics.rules().pull,
            wants: Vec::new(),
            loads: Vec::new(),
            tables: Vec::new(),
            queue: Vec::new(),
            at: 0,
        };
        for (object, want) in loads {
            let known = pairs.wants.iter().position(|known| known == want);
            let index = known.unwrap_or_else(|| {
                pairs.wants.push(want.clone());
                pairs.wants.len() - 1
            });
            pairs.loads.push((*object, index));
        }
        let n = pairs.next.len();
        let fits = n <= usize::from(u8::MAX) && pairs.kinds().len() * n * n * n <= MOST_ENTRIES;
        (fits && pairs.loads.len() > 1).then_some(pairs)
    }

    /// What is wanted of two objects, each such pair once.
    fn kinds(&self) -> Vec<(usize, usize)> {
        let mut kinds = Vec::new();
        for (i, &(_, one)) in self.loads.iter().enumerate() {
            for &(_, other) in &self.loads[..i] {
                kinds.push((one.min(other), one.max(other)));
            }
        }
        order::sort_by_key(&mut kinds, |&kind| kind);
        kinds.dedup();
        kinds
    }

    /// Looks at no more than `n` entries, of one table; whether all tables are made.
    pub(super) fn step(&mut self, n: usize) -> bool {
        if self.at == self.queue.len() {
            let kinds = self.kinds();
            let Some(&kind) = kinds.get(self.tables.len()) else {
                self.queue = Vec::new();
                self.at = 0;
                return true;
            };
            self.begin(kind);
        }
        for _ in 0..n {
            let Some(&entry) = self.queue.get(self.at) else { break };
            self.look(entry);
            self.at += 1;
        }
        false
    }

    /// Begins a table with all places that will do, and the robot anywhere else.
    fn begin(&mut self, kind: (usize, usize)) {
        let n = self.next.len();
        let mut rest = vec![NEVER; n * n * n];
        self.queue.clear();
        self.at = 0;
        let places = |of: usize| -> Vec<usize> { (0..n).filter(|&p| self.wants[of][p]).collect() };
        let (first, second) = (places(kind.0), places(kind.1));
        for &a in &first {
            for &b in second.iter().filter(|&&b| b != a) {
                for robot in (0..n).filter(|&robot| robot != a && robot != b) {
                    rest[(a * n + b) * n + robot] = 0;
                    self.queue.push((a << 16 | b << 8 | robot) as u32);
                }
            }
        }
        self.tables.push((kind, rest));
    }

    /// Reaches all states from which one action leads to this one.
    fn look(&mut self, entry: u32) {
        let n = self.next.len();
        let Some((_, rest)) = self.tables.last_mut() else { return };
        let [a, b, robot] = [16, 8, 0].map(|shift| (entry >> shift) as usize & 0xff);
        let depth = (rest[(a * n + b) * n + robot] + 1).min(NEVER - 1);
        let queue = &mut self.queue;
        let mut reach = |a: usize, b: usize, robot: usize| {
            let known = &mut rest[(a * n + b) * n + robot];
            if *known == NEVER {
                *known = depth;
                queue.push((a << 16 | b << 8 | robot) as u32);
            }
        };
        if !self.opens[robot] {
            return;
        }
        for direction in 0..4 {
            // Directions come in opposites: north, south, east, west.
            let (ahead, before) = (self.next[robot][direction], self.next[robot][direction ^ 1]);
            let (ahead, before) = (usize::from(ahead), usize::from(before));
            let is_carried = (ahead == a || ahead == b) && self.opens[ahead];
            if before != usize::from(NOWHERE) && before != a && before != b {
                reach(a, b, before);
                if is_carried && ahead == a {
                    reach(robot, b, before);
                } else if is_carried {
                    reach(a, robot, before);
                }
            }
            if self.pull && is_carried {
                if ahead == a {
                    reach(robot, b, a);
                } else {
                    reach(a, robot, b);
                }
            }
        }
    }

    /// The largest bound of all pairs, once all tables are made; `None` for never.
    #[inline]
    pub(super) fn bound(&self, dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        let n = self.next.len();
        let robot = usize::from(dynamics.agent(packed));
        let place = |object: usize| usize::from(dynamics.object(packed, object));
        let mut most = 0;
        for (i, &(object, one)) in self.loads.iter().enumerate() {
            for &(before, other) in &self.loads[..i] {
                let (mut a, mut b) = (place(object), place(before));
                if one > other {
                    (a, b) = (b, a);
                }
                let kind = (one.min(other), one.max(other));
                let table = self.tables.iter().find(|table| table.0 == kind);
                let Some((_, rest)) = table else { continue };
                match rest[(a * n + b) * n + robot] {
                    NEVER => return None,
                    bound => most = most.max(u32::from(bound)),
                }
            }
        }
        Some(most)
    }
}
