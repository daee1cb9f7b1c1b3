//! Seeded three-room worlds like those of the corpora: a rectangle cut in two by a wall, one half cut again,
//! with a door from the big room to each of the others and sometimes one between these.
//! Invariants: a pure function of plan and seed; the state is legal and connected; no object in a corner.

use super::layout::{Layout, NOWHERE, Place};
use super::object::{Agent, Bounds, Color, Direction, Door, Lock, Object, Room, Shape};
use super::state::State;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// What kind of world to make. The default is what the corpora hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Shortest and longest side of the world, in cells between the first and the last wall line; both are
    /// brought within 7 and 31.
    pub side: (u32, u32),
    /// Fewest and most objects; at most 8, and at most what finds room.
    pub objects: (u32, u32),
}

impl Default for Plan {
    fn default() -> Self {
        Self { side: (8, 12), objects: (1, 3) }
    }
}

/// The narrowest room, wall line to wall line: two cells of floor.
const NARROWEST: u32 = 3;

/// Makes the world that `seed` stands for under `plan`.
#[must_use]
pub fn generate(plan: &Plan, seed: u64) -> State {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let rooms = rooms(plan, &mut rng);
    let mut doors = Vec::new();
    for (first, second) in [(0, 1), (0, 2), (1, 2)] {
        if (first, second) != (1, 2) || rng.random_bool(0.5) {
            doors.extend(door(&rooms[first].bounds, &rooms[second].bounds, doors.len(), &mut rng));
        }
    }
    let agent = Agent { x: 0, y: 0, direction: pick(Direction::ALL, &mut rng) };
    let mut state = State { agent, rooms, doors, objects: Vec::new() };
    furnish(&mut state, between(plan.objects, (0, 8), &mut rng), &mut rng);
    state
}

/// Three rooms, the uncut half first.
fn rooms(plan: &Plan, rng: &mut Pcg64Mcg) -> Vec<Room> {
    let width = signed(between(plan.side, (7, 31), rng));
    let height = signed(between(plan.side, (7, 31), rng));
    let whole = Bounds { left: 0, bottom: 0, right: width, top: height };
    let upright = rng.random_bool(0.5);
    let (low, high) = cut(whole, upright, rng);
    let (big, rest) = if rng.random_bool(0.5) { (low, high) } else { (high, low) };
    let (second, third) = cut(rest, !upright, rng);
    let mut colors = vec![Color::Red, Color::Green, Color::Blue];
    [big, second, third]
        .into_iter()
        .enumerate()
        .map(|(i, bounds)| Room {
            name: format!("room{i}"),
            color: colors.swap_remove(index(colors.len(), rng)),
            bounds,
        })
        .collect()
}

/// Cuts a rectangle in two that share the wall line of the cut.
pub(super) fn cut(b: Bounds, upright: bool, rng: &mut Pcg64Mcg) -> (Bounds, Bounds) {
    let (from, to) = if upright { (b.left, b.right) } else { (b.bottom, b.top) };
    let narrowest = signed(NARROWEST);
    let at = rng.random_range(from + narrowest..=to - narrowest);
    if upright {
        (Bounds { right: at, ..b }, Bounds { left: at, ..b })
    } else {
        (Bounds { top: at, ..b }, Bounds { bottom: at, ..b })
    }
}

/// A door of one cell somewhere in the wall that two rooms share, with floor on both sides.
pub(super) fn door(a: &Bounds, b: &Bounds, number: usize, rng: &mut Pcg64Mcg) -> Option<Door> {
    let shared = Bounds {
        left: a.left.max(b.left),
        bottom: a.bottom.max(b.bottom),
        right: a.right.min(b.right),
        top: a.top.min(b.top),
    };
    let upright = shared.left == shared.right;
    let (from, to) =
        if upright { (shared.bottom, shared.top) } else { (shared.left, shared.right) };
    if !shared.is_ordered() || from + 1 > to - 1 {
        return None;
    }
    let at = rng.random_range(from + 1..=to - 1);
    let (x, y) = if upright { (shared.left, at) } else { (at, shared.bottom) };
    Some(Door {
        name: format!("door{number}"),
        bounds: Bounds { left: x, bottom: y, right: x, top: y },
        lock: Lock::Unlocked,
    })
}

/// Puts the agent and `count` objects of distinct looks on free floor, the objects out of corners.
pub(super) fn furnish(state: &mut State, count: u32, rng: &mut Pcg64Mcg) {
    let layout = Layout::new(state);
    let mut floor: Vec<Place> = layout.places().filter(|&p| layout.door(p).is_none()).collect();
    let mut looks: Vec<(Shape, Color)> =
        Shape::ALL.iter().flat_map(|&s| Color::ALL.iter().map(move |&c| (s, c))).collect();
    let agent = layout.cell(floor.swap_remove(index(floor.len(), rng)));
    (state.agent.x, state.agent.y) = agent;
    floor.retain(|&p| !is_corner(&layout, p));
    for number in 0..count {
        if floor.is_empty() {
            break;
        }
        let (x, y) = layout.cell(floor.swap_remove(index(floor.len(), rng)));
        let (shape, color) = looks.swap_remove(index(looks.len(), rng));
        state.objects.push(Object {
            name: format!("object{number}"),
            shape,
            color,
            size: None,
            x,
            y,
        });
    }
}

/// Whether there is wall on two sides that meet: nothing is pushed out of there.
fn is_corner(layout: &Layout, place: Place) -> bool {
    let wall = |d| layout.neighbour(place, d) == NOWHERE;
    (wall(Direction::North) || wall(Direction::South))
        && (wall(Direction::East) || wall(Direction::West))
}

/// A number between two bounds that are first brought in order and within limits.
fn between((from, to): (u32, u32), limits: (u32, u32), rng: &mut Pcg64Mcg) -> u32 {
    let (from, to) = (from.clamp(limits.0, limits.1), to.clamp(limits.0, limits.1));
    rng.random_range(from.min(to)..=from.max(to))
}

/// An index below `len`, which is not 0; drawn as u32, so that it is the same on every target.
pub(super) fn index(len: usize, rng: &mut impl Rng) -> usize {
    rng.random_range(0..u32::try_from(len).unwrap_or(u32::MAX)) as usize
}

pub(super) fn pick<T: Copy>(all: &[T], rng: &mut impl Rng) -> T {
    all[index(all.len(), rng)]
}

/// A length within the generator's limits.
pub(super) fn signed(n: u32) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}
