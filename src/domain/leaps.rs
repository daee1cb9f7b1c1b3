//! What a robot can do next in compass form: walk somewhere and move an object by one cell, or try a door. Walks alone
//! lead nowhere that such a leap does not leave from, but where a goal speaks of the robot. One breadth-first search over
//! the free cells finds the shortest of all of them. Walks go through no door that nobody tried where it may be locked.

use super::dynamics::Dynamics;
use super::layout::{NOWHERE, Place};
use super::object::Direction;
use super::packing::Packed;
use super::rules::Action;

/// Not reached, or nothing in the way.
const NONE: u16 = u16::MAX;
/// In the way of everything: a door that is closed.
const CLOSED: u16 = NONE - 1;
/// In the way of walks: a door that nobody tried.
const UNTRIED: u16 = NONE - 2;

/// What the robot can walk to from a state, kept for the next state.
#[derive(Clone, Debug, Default)]
pub struct Walks {
    /// Steps to each place, or [`NONE`].
    steps: Vec<u16>,
    /// The places reached, nearest first, and the first step to each.
    reached: Vec<Place>,
    first: Vec<Direction>,
    /// The object at each place, [`CLOSED`], [`UNTRIED`] or [`NONE`].
    objects: Vec<u16>,
    /// The places of doors.
    doors: Vec<Place>,
    /// Where the robot stands, which way, before an object or a door that nobody tried.
    contacts: Vec<(Place, Direction, u16)>,
}

/// A walk that ends in moving an object or in trying a door.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Carry {
    /// Where that leads when all goes well, as the [`Dynamics::quotient`].
    pub state: Packed,
    /// Actions in all.
    pub cost: u32,
    /// The last of them.
    pub action: Action,
    /// Where the robot stands at the end of the walk, and on which side the object or the door is.
    stand: (Place, Direction),
}

impl Walks {
    /// Finds what can be walked to.
    pub fn explore(&mut self, dynamics: &Dynamics, state: Packed) {
        let layout = dynamics.layout();
        if self.steps.len() != layout.len() {
            self.doors = layout.places().filter(|&place| layout.door(place).is_some()).collect();
        }
        self.steps.clear();
        self.steps.resize(layout.len(), NONE);
        self.objects.clear();
        self.objects.resize(layout.len(), NONE);
        for &place in &self.doors {
            if !dynamics.opens(state, place) {
                self.objects[usize::from(place)] = CLOSED;
            } else if dynamics.untried(state, place).is_some() {
                self.objects[usize::from(place)] = UNTRIED;
            }
        }
        for object in 0..dynamics.n_objects() {
            self.objects[usize::from(dynamics.object(state, object))] = object as u16;
        }
        self.reached.clear();
        self.first.resize(layout.len(), Direction::North);
        self.contacts.clear();
        let start = dynamics.agent(state);
        self.steps[usize::from(start)] = 0;
        self.reached.push(start);
        let mut at = 0;
        while let Some(&place) = self.reached.get(at) {
            at += 1;
            let next_steps = self.steps[usize::from(place)] + 1;
            for (next, &direction) in layout.neighbours(place).into_iter().zip(Direction::ALL) {
                if next == NOWHERE {
                    continue;
                }
                let i = usize::from(next);
                match self.objects[i] {
                    NONE if self.steps[i] == NONE => {
                        self.steps[i] = next_steps;
                        let is_first = next_steps == 1;
                        let first =
                            if is_first { direction } else { self.first[usize::from(place)] };
                        self.first[i] = first;
                        self.reached.push(next);
                    }
                    NONE | CLOSED => {}
                    object => self.contacts.push((place, direction, object)),
                }
            }
        }
    }

    /// The places that can be walked to, nearest first, each with the steps; the robot's own comes first.
    pub fn reached(&self) -> impl Iterator<Item = (Place, u32)> + '_ {
        self.reached.iter().map(|&place| (place, u32::from(self.steps[usize::from(place)])))
    }

    /// All ways to move an object or to try a door next, after [`Walks::explore`] of the same state.
    pub fn carries<'a>(
        &'a self,
        dynamics: &'a Dynamics,
        state: Packed,
    ) -> impl Iterator<Item = Carry> + 'a {
        self.contacts.iter().flat_map(move |&contact| self.at(dynamics, state, contact)).flatten()
    }

    /// To push what is there, and to pull it; or to step through the door.
    fn at(
        &self,
        dynamics: &Dynamics,
        state: Packed,
        (place, side, object): (Place, Direction, u16),
    ) -> [Option<Carry>; 2] {
        let layout = dynamics.layout();
        let ahead = layout.neighbour(place, side);
        let steps = u32::from(self.steps[usize::from(place)]);
        let stand = (place, side);
        if object == UNTRIED {
            let state = dynamics.quotient(dynamics.through(state, ahead, side));
            return [Some(Carry { state, cost: steps + 1, stand, action: step(side) }), None];
        }
        let object = usize::from(object);
        if !dynamics.can_move(object) || !dynamics.opens(state, ahead) {
            return [None, None];
        }
        let beyond = layout.neighbour(ahead, side);
        let is_free = beyond != NOWHERE
            && matches!(self.objects[usize::from(beyond)], NONE | UNTRIED)
            && dynamics.opens(state, beyond);
        let push = is_free.then(|| Carry {
            state: dynamics.moved(state, object, [ahead, beyond], side),
            cost: steps + 1,
            stand,
            action: step(side),
        });
        let may_pull = dynamics.rules().pull && dynamics.opens(state, place);
        let faced = self.facing(dynamics, state, stand, is_free).filter(|_| may_pull);
        let pull = faced.map(|n| Carry {
            state: dynamics.moved(state, object, [ahead, place], side.opposite()),
            cost: n + 1,
            stand,
            action: Action::Pull,
        });
        [push, pull]
    }

    /// The actions to stand at a place and face what is on a side of it: by arriving that way, or by running into it when
    /// it does not give way.
    fn facing(
        &self,
        dynamics: &Dynamics,
        state: Packed,
        (place, side): (Place, Direction),
        gives_way: bool,
    ) -> Option<u32> {
        let steps = u32::from(self.steps[usize::from(place)]);
        if steps == 0 && dynamics.heading(state) == side {
            return Some(0);
        }
        let turned = (!gives_way).then_some(steps + 1);
        let came = self.behind(dynamics, (place, side)).map(|(_, steps)| steps + 1);
        turned.into_iter().chain(came).min()
    }

    /// The place from which one arrives at another facing this side, if it can be walked to, and the steps there.
    fn behind(
        &self,
        dynamics: &Dynamics,
        (place, side): (Place, Direction),
    ) -> Option<(Place, u32)> {
        let back = dynamics.layout().neighbour(place, side.opposite());
        if back == NOWHERE || self.objects[usize::from(place)] != NONE {
            return None;
        }
        let steps = self.steps[usize::from(back)];
        (steps != NONE).then_some((back, u32::from(steps)))
    }

    /// Where the walk of a carry ends that must first turn to what it pulls: one step back, or right before it.
    fn turns_at(&self, dynamics: &Dynamics, carry: Carry) -> Option<Place> {
        if carry.action != Action::Pull || carry.cost == 1 {
            return None;
        }
        let back = self.behind(dynamics, carry.stand);
        let arrives = back.filter(|(_, steps)| steps + 2 == carry.cost);
        Some(arrives.map_or(carry.stand.0, |(back, _)| back))
    }

    /// The first action of a carry.
    #[must_use]
    pub fn first(&self, dynamics: &Dynamics, carry: Carry) -> Action {
        let (place, side) = carry.stand;
        let turn = self.turns_at(dynamics, carry);
        let end = usize::from(turn.unwrap_or(place));
        match (self.steps[end], turn) {
            (0, None) => carry.action,
            (0, Some(_)) => step(side),
            _ => step(self.first[end]),
        }
    }

    /// The state in which the last action of a carry is taken, as far as it matters to that.
    #[must_use]
    pub fn stand(&self, dynamics: &Dynamics, state: Packed, carry: Carry) -> Packed {
        let (place, side) = carry.stand;
        if carry.cost == 1 {
            return state;
        }
        let heading = if carry.action == Action::Pull { side } else { side.opposite() };
        dynamics.with_agent(state, place, heading).unwrap_or(state)
    }

    /// The first step of the walk to a place that was reached.
    #[must_use]
    pub fn toward(&self, place: Place) -> Action {
        step(self.first[usize::from(place)])
    }

    /// Appends the actions of a walk to a place that was reached.
    pub fn walk(&self, dynamics: &Dynamics, to: Place, out: &mut Vec<Action>) {
        let layout = dynamics.layout();
        let from = out.len();
        let mut place = to;
        while self.steps[usize::from(place)] > 0 {
            let nearer = |side: &&Direction| {
                let next = layout.neighbour(place, **side);
                next != NOWHERE && self.steps[usize::from(next)] < self.steps[usize::from(place)]
            };
            let Some(&side) = Direction::ALL.iter().find(nearer) else { break };
            out.push(step(side.opposite()));
            place = layout.neighbour(place, side);
        }
        out[from..].reverse();
    }

    /// Appends the actions of a carry.
    pub fn carry(&self, dynamics: &Dynamics, carry: Carry, out: &mut Vec<Action>) {
        let turn = self.turns_at(dynamics, carry);
        self.walk(dynamics, turn.unwrap_or(carry.stand.0), out);
        if turn.is_some() {
            out.push(step(carry.stand.1));
        }
        out.push(carry.action);
    }
}

const fn step(side: Direction) -> Action {
    match side {
        Direction::North => Action::North,
        Direction::South => Action::South,
        Direction::East => Action::East,
        Direction::West => Action::West,
    }
}
