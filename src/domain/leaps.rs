//! What a robot can do next in compass form: walk somewhere and move an object by one cell, or try a door. Walks alone
//! lead nowhere that such a leap does not leave from, but where a goal speaks of the robot. One search over the free
//! cells finds the shortest of all of them. Walks go through no door that nobody tried where it may be locked.

use super::dynamics::Dynamics;
use super::flood::Flood;
use super::layout::{NOWHERE, Place};
use super::object::Direction;
use super::packing::Packed;
use super::rules::Action;

/// Nothing in the way.
const NONE: u16 = u16::MAX;
/// In the way of everything: a door that is closed.
const CLOSED: u16 = NONE - 1;
/// In the way of walks: a door that nobody tried.
const UNTRIED: u16 = NONE - 2;

/// What the robot can walk to from a state, kept for the next state.
#[derive(Clone, Debug)]
pub struct Walks {
    flood: Flood,
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

/// A walk into a place that others do not enter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The place.
    pub place: Place,
    /// Where the robot comes to face.
    pub side: Direction,
    /// Actions in all.
    pub cost: u32,
}

impl Walks {
    /// Walks in a world, none looked for yet.
    #[must_use]
    pub fn new(dynamics: &Dynamics) -> Self {
        let layout = dynamics.layout();
        Self {
            flood: Flood::new(layout),
            objects: vec![NONE; layout.len()],
            doors: layout.places().filter(|&place| layout.door(place).is_some()).collect(),
            contacts: Vec::new(),
        }
    }

    /// Finds the walks to what can be moved and tried in a state; or to everywhere.
    pub fn explore(&mut self, dynamics: &Dynamics, state: Packed, everywhere: bool) {
        self.explore_up_to(dynamics, state, &[], everywhere);
    }

    /// The same for walks that enter none of some places, but may end before one.
    pub fn explore_within(&mut self, dynamics: &Dynamics, state: Packed, bars: &[Place]) {
        self.explore_up_to(dynamics, state, bars, false);
    }

    fn explore_up_to(
        &mut self,
        dynamics: &Dynamics,
        state: Packed,
        bars: &[Place],
        everywhere: bool,
    ) {
        let Self { flood, objects, doors, contacts } = self;
        flood.clear();
        objects.fill(NONE);
        contacts.clear();
        for &place in doors.iter() {
            let is_open = dynamics.opens(state, place);
            if !is_open || dynamics.untried(state, place).is_some() {
                objects[usize::from(place)] = if is_open { UNTRIED } else { CLOSED };
                flood.block(place);
            }
        }
        for object in 0..dynamics.n_objects() {
            let place = dynamics.object(state, object);
            objects[usize::from(place)] = object as u16;
            flood.block(place);
        }
        bars.iter().for_each(|&bar| flood.block(bar));
        let layout = dynamics.layout();
        for &bar in bars {
            let beside = layout.neighbours(bar).into_iter().filter(|&to| to != NOWHERE);
            beside.for_each(|place| flood.want(place));
        }
        let mut meet = |place: Place, thing: u16, is_pulled: bool| {
            for (stand, side) in layout.neighbours(place).into_iter().zip(Direction::ALL) {
                if stand == NOWHERE {
                    continue;
                }
                flood.want(stand);
                contacts.push((stand, side.opposite(), thing));
                let back = layout.neighbour(stand, *side);
                if is_pulled && back != NOWHERE {
                    flood.want(back);
                }
            }
        };
        for object in (0..dynamics.n_objects()).filter(|&object| dynamics.can_move(object)) {
            meet(dynamics.object(state, object), object as u16, dynamics.rules().pull);
        }
        for &place in doors.iter().filter(|place| objects[usize::from(**place)] == UNTRIED) {
            meet(place, UNTRIED, false);
        }
        flood.run(dynamics.agent(state), everywhere);
        contacts.retain(|contact| flood.steps(contact.0).is_some());
    }

    /// The places that can be walked to, nearest first, each with the steps, after [`Walks::explore`] for everywhere; the
    /// robot's own comes first.
    pub fn reached(&self) -> impl Iterator<Item = (Place, u32)> + '_ {
        self.flood.reached()
    }

    /// The ways to enter one of the places that [`Walks::explore_within`] went up to, those of one place together.
    pub fn entries<'a>(
        &'a self,
        dynamics: &'a Dynamics,
        bars: &'a [Place],
    ) -> impl Iterator<Item = Entry> + 'a {
        let is_free = |bar: &&Place| self.objects[usize::from(**bar)] == NONE;
        bars.iter().filter(is_free).flat_map(move |&place| {
            Direction::ALL.iter().filter_map(move |&side| {
                let before = dynamics.layout().neighbour(place, side.opposite());
                let steps = if before == NOWHERE { None } else { self.flood.steps(before) };
                Some(Entry { place, side, cost: steps? + 1 })
            })
        })
    }

    /// Appends the actions of a walk into such a place.
    pub fn enter(&self, dynamics: &Dynamics, entry: Entry, out: &mut Vec<Action>) {
        self.walk(dynamics.layout().neighbour(entry.place, entry.side.opposite()), out);
        out.push(step(entry.side));
    }

    /// All ways to move an object or to try a door next, after [`Walks::explore`] of the same state; each with its number.
    pub fn carries<'a>(
        &'a self,
        dynamics: &'a Dynamics,
        state: Packed,
    ) -> impl Iterator<Item = (usize, Carry)> + 'a {
        self.contacts.iter().enumerate().flat_map(move |(i, &contact)| {
            let both = self.at(dynamics, state, contact).into_iter().enumerate();
            both.filter_map(move |(j, carry)| Some((2 * i + j, carry?)))
        })
    }

    /// The way of this number.
    #[must_use]
    pub fn numbered(&self, dynamics: &Dynamics, state: Packed, number: usize) -> Option<Carry> {
        self.at(dynamics, state, *self.contacts.get(number / 2)?)[number % 2]
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
        let Some(steps) = self.flood.steps(place) else { return [None, None] };
        let stand = (place, side);
        if object == UNTRIED {
            let state = dynamics.quotient(dynamics.through(state, ahead, side));
            return [Some(Carry { state, cost: steps + 1, stand, action: step(side) }), None];
        }
        let object = usize::from(object);
        if !dynamics.opens(state, ahead) {
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
        let faced = if may_pull { self.facing(dynamics, state, stand, is_free) } else { None };
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
        let steps = self.flood.steps(place)?;
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
        // The robot may stand in a door that it cannot enter again.
        if back == NOWHERE || self.objects[usize::from(place)] != NONE {
            return None;
        }
        Some((back, self.flood.steps(back)?))
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

    /// Whether a carry goes to or through a door that nobody tried.
    #[must_use]
    pub fn tries(&self, dynamics: &Dynamics, state: Packed, carry: Carry) -> bool {
        let layout = dynamics.layout();
        let (place, side) = carry.stand;
        let ahead = layout.neighbour(place, side);
        let other = match carry.action {
            Action::Pull => place,
            _ => layout.neighbour(ahead, side),
        };
        [ahead, other].into_iter().any(|place| dynamics.untried(state, place).is_some())
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

    /// Appends the actions of a walk to a place that was reached.
    pub fn walk(&self, to: Place, out: &mut Vec<Action>) {
        out.extend(self.flood.back(to).into_iter().rev().map(step));
    }

    /// Appends the actions of a carry.
    pub fn carry(&self, dynamics: &Dynamics, carry: Carry, out: &mut Vec<Action>) {
        let turn = self.turns_at(dynamics, carry);
        self.walk(turn.unwrap_or(carry.stand.0), out);
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
