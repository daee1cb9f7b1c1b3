//! Bounds for conjunctions that price the walks between objects and what stands in the way: for every two objects that
//! a goal wants moved, the actions of a robot that brings both, exact in a world with nothing else in it (pattern
//! databases: Culberson and Schaeffer 1998, Edelkamp 2001). In compass form, without headings. Found by breadth-first
//! search backwards, in parts; the largest of all pairs counts, so the bound is admissible and consistent.
//! Objects that are wanted alike share a table.

use super::distance::Ground;
use super::grid::Grid;
use crate::domain::layout::{NOWHERE, Place};
use crate::domain::{Dynamics, Packed};
use crate::logic::order;
use crate::mdp::Sharpened;
use std::cmp::Reverse;

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
    /// By what is wanted of the first and of the second, in this order: those first of which most is to be hoped for.
    kinds: Vec<(usize, usize)>,
    /// Two objects each, in the order of their kind, with the place of that.
    pairs: Vec<((usize, usize), usize)>,
    /// The tables of the first kinds; all are made, but for the last while robots are coming.
    tables: Vec<Vec<u8>>,
    wave: Wave,
}

/// An object that is wanted elsewhere.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    pub(super) object: usize,
    /// The places that will do.
    pub(super) places: Vec<bool>,
    /// How far it is at least.
    pub(super) least: u32,
}

/// The robots that the last table is being made from, a set for each two places of objects.
#[derive(Clone, Debug)]
struct Wave {
    grid: Grid,
    /// The places that may be entered, and those next to each place.
    open: Vec<u64>,
    beside: Vec<u64>,
    /// Those in the table, walls and the objects' places among them; those that came to it last; those that come next.
    seen: Vec<u64>,
    last: Vec<u64>,
    next: Vec<u64>,
    /// The places of objects with robots that came last, how many of these were looked at, and those with robots that
    /// come next.
    queue: Vec<(u8, u8)>,
    at: usize,
    later: Vec<(u8, u8)>,
    is_later: Vec<bool>,
    /// How far it is from what comes next.
    depth: u8,
    /// The set that is looked at.
    here: Vec<u64>,
}

impl Pairs {
    /// Nothing made yet, for objects that must come to one of their places each; `None` when there is nothing to be had.
    pub(super) fn new(dynamics: &Dynamics, ground: &Ground<'_>, wanted: &[Wanted]) -> Option<Self> {
        let layout = dynamics.layout();
        let mut wants: Vec<Vec<bool>> = Vec::new();
        let mut index = Vec::new();
        for Wanted { places, .. } in wanted {
            let known = wants.iter().position(|known| known == places);
            index.push(known.unwrap_or_else(|| {
                wants.push(places.clone());
                wants.len() - 1
            }));
        }
        // Two objects in the order of what is wanted of them; how far both are.
        let mut found = Vec::new();
        for i in 0..wanted.len() {
            for j in 0..i {
                let (one, other) = if index[i] <= index[j] { (i, j) } else { (j, i) };
                let far = wanted[i].least.saturating_add(wanted[j].least);
                let objects = (wanted[one].object, wanted[other].object);
                found.push((Reverse(far), (index[one], index[other]), objects));
            }
        }
        order::sort_by_key(&mut found, |&pair| pair);
        let mut kinds: Vec<(usize, usize)> = Vec::new();
        for &(_, kind, _) in &found {
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
        }
        let place = |kind| kinds.iter().position(|&known| known == kind).unwrap_or_default();
        let mut pairs: Vec<_> =
            found.into_iter().map(|(_, kind, objects)| (objects, place(kind))).collect();
        order::sort_by_key(&mut pairs, |&(_, kind)| kind);
        let next: Vec<_> = layout.places().map(|place| layout.neighbours(place)).collect();
        let n = next.len();
        let fits = n <= usize::from(u8::MAX) && kinds.len() * n * n * n <= MOST_ENTRIES;
        (fits && !pairs.is_empty()).then(|| Self {
            opens: ground.opens().to_vec(),
            next,
            pull: dynamics.rules().pull,
            wants,
            kinds,
            pairs,
            tables: Vec::new(),
            wave: Wave::new(Grid::new(layout), ground.opens()),
        })
    }

    /// Looks at no more than `n` sets of robots, for one table.
    pub(super) fn step(&mut self, n: usize) -> Sharpened {
        if self.wave.is_over() {
            let Some(&kind) = self.kinds.get(self.tables.len()) else { return Sharpened::Whole };
            self.begin(kind);
        }
        for _ in 0..n {
            let Some(pair) = self.wave.turn() else { break };
            self.look(pair);
        }
        if self.wave.is_over() { Sharpened::More } else { Sharpened::Not }
    }

    /// Whether all tables are made.
    pub(super) fn is_whole(&self) -> bool {
        self.n_made() == self.kinds.len()
    }

    /// How many tables are made.
    fn n_made(&self) -> usize {
        self.tables.len() - usize::from(!self.wave.is_over())
    }

    /// Begins a table with all places that will do, and the robot anywhere else.
    fn begin(&mut self, kind: (usize, usize)) {
        let n = self.next.len();
        let mut rest = vec![NEVER; n * n * n];
        self.wave.clear(n);
        let places = |of: usize| -> Vec<usize> { (0..n).filter(|&p| self.wants[of][p]).collect() };
        let (first, second) = (places(kind.0), places(kind.1));
        for &a in &first {
            for &b in second.iter().filter(|&&b| b != a) {
                for robot in (0..n).filter(|&robot| robot != a && robot != b) {
                    self.wave.reach(&mut rest, n, (a, b), robot);
                }
            }
        }
        self.tables.push(rest);
    }

    /// Reaches all states from which one action leads to where the robot came last, with objects at two places.
    fn look(&mut self, (a, b): (usize, usize)) {
        let n = self.next.len();
        let Self { opens, next, pull, tables, wave, .. } = self;
        let Some(rest) = tables.last_mut() else { return };
        wave.walk(rest, n, (a, b));
        for (object, is_first) in [(a, true), (b, false)] {
            if !opens[object] || !wave.is_beside(object) {
                continue;
            }
            let moved = |to: usize| if is_first { (to, b) } else { (a, to) };
            // Directions come in opposites: north, south, east, west.
            for (back, robot) in next[object].into_iter().enumerate() {
                if robot == NOWHERE || !wave.is_here(usize::from(robot)) {
                    continue;
                }
                let (robot, before) = (usize::from(robot), next[usize::from(robot)][back]);
                if before != NOWHERE {
                    wave.reach(rest, n, moved(robot), usize::from(before));
                }
                if *pull {
                    wave.reach(rest, n, moved(robot), object);
                }
            }
        }
    }

    /// The largest bound of all pairs whose tables are made; `None` for never.
    #[inline]
    pub(super) fn bound(&self, dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        let n = self.next.len();
        let robot = usize::from(dynamics.agent(packed));
        let place = |object: usize| usize::from(dynamics.object(packed, object));
        let made = self.n_made();
        let mut most = 0;
        for &((one, other), kind) in &self.pairs {
            if kind >= made {
                break;
            }
            match self.tables[kind][(place(one) * n + place(other)) * n + robot] {
                NEVER => return None,
                bound => most = most.max(u32::from(bound)),
            }
        }
        Some(most)
    }
}

impl Wave {
    fn new(grid: Grid, opens: &[bool]) -> Self {
        let mut open = vec![0; grid.size()];
        for (place, _) in opens.iter().enumerate().filter(|(_, opens)| **opens) {
            let (word, bit) = grid.bit(place);
            open[word] |= bit;
        }
        let mut beside = Vec::with_capacity(opens.len() * grid.size());
        for place in 0..opens.len() {
            let (word, bit) = grid.bit(place);
            let mut alone = vec![0; grid.size()];
            alone[word] = bit;
            beside.extend((0..grid.size()).map(|w| match grid.words().contains(&w) {
                true => grid.around(&alone, w),
                false => 0,
            }));
        }
        Self {
            here: vec![0; grid.size()],
            grid,
            open,
            beside,
            seen: Vec::new(),
            last: Vec::new(),
            next: Vec::new(),
            queue: Vec::new(),
            at: 0,
            later: Vec::new(),
            is_later: Vec::new(),
            depth: 0,
        }
    }

    /// Begins anew, with so many places.
    fn clear(&mut self, n: usize) {
        let size = self.grid.size();
        let mut wall = vec![u64::MAX; size];
        for place in 0..n {
            let (word, bit) = self.grid.bit(place);
            wall[word] &= !bit;
        }
        self.seen = wall.repeat(n * n);
        for pair in 0..n * n {
            for place in [pair / n, pair % n] {
                let (word, bit) = self.grid.bit(place);
                self.seen[pair * size + word] |= bit;
            }
        }
        for set in [&mut self.last, &mut self.next] {
            set.clear();
            set.resize(n * n * size, 0);
        }
        self.is_later = vec![false; n * n];
        self.queue.clear();
        (self.at, self.depth) = (0, 0);
    }

    /// Whether nothing comes any more.
    fn is_over(&self) -> bool {
        self.at == self.queue.len() && self.later.is_empty()
    }

    /// The places of the objects that are to be looked at next; one further away when none is left.
    fn turn(&mut self) -> Option<(usize, usize)> {
        if self.at == self.queue.len() {
            std::mem::swap(&mut self.queue, &mut self.later);
            std::mem::swap(&mut self.last, &mut self.next);
            self.later.clear();
            self.is_later.fill(false);
            (self.at, self.depth) = (0, (self.depth + 1).min(NEVER - 1));
        }
        let &(a, b) = self.queue.get(self.at)?;
        self.at += 1;
        Some((usize::from(a), usize::from(b)))
    }

    /// Takes the robots that came last with objects at these places, and reaches those that walk there.
    fn walk(&mut self, rest: &mut [u8], n: usize, (a, b): (usize, usize)) {
        let (pair, size) = (a * n + b, self.grid.size());
        let sets = pair * size..(pair + 1) * size;
        for (here, (last, open)) in
            self.here.iter_mut().zip(self.last[sets.clone()].iter_mut().zip(&self.open))
        {
            *here = std::mem::take(last) & open;
        }
        let Self { grid, here, seen, next, depth, .. } = self;
        let (seen, next) = (&mut seen[sets.clone()], &mut next[sets]);
        let row = &mut rest[pair * n..(pair + 1) * n];
        let mut any = 0;
        for w in grid.words() {
            let new = grid.around(here, w) & !seen[w];
            seen[w] |= new;
            next[w] |= new;
            any |= new;
            grid.each(w, new, |robot| row[robot] = *depth);
        }
        if any != 0 {
            self.note(pair, (a, b));
        }
    }

    /// Whether a robot is among those that are looked at.
    fn is_here(&self, robot: usize) -> bool {
        let (word, bit) = self.grid.bit(robot);
        self.here[word] & bit != 0
    }

    /// Whether any of these stands next to a place.
    fn is_beside(&self, place: usize) -> bool {
        let size = self.grid.size();
        let beside = &self.beside[place * size..(place + 1) * size];
        beside.iter().zip(&self.here).any(|(beside, here)| beside & here != 0)
    }

    /// Reaches one robot.
    fn reach(&mut self, rest: &mut [u8], n: usize, (a, b): (usize, usize), robot: usize) {
        let (pair, size) = (a * n + b, self.grid.size());
        let (word, bit) = self.grid.bit(robot);
        if self.seen[pair * size + word] & bit == 0 {
            self.seen[pair * size + word] |= bit;
            self.next[pair * size + word] |= bit;
            rest[pair * n + robot] = self.depth;
            self.note(pair, (a, b));
        }
    }

    /// Notes that robots come next with objects at these places; there are at most 255 places.
    fn note(&mut self, pair: usize, (a, b): (usize, usize)) {
        if !std::mem::replace(&mut self.is_later[pair], true) {
            self.later.push((a as u8, b as u8));
        }
    }
}
