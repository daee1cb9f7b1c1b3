//! How Cleanup World moves (Williams et al., Section III), on packed states: agent, objects and tried doors
//! in two machine words, no allocation in a step. One object is pushed at a time; `pull` swaps. What may go
//! wrong on the way is in `outcomes`.
//! Invariant: `unpack` after `pack` is the identity, and a step from a legal state ends in a legal state.

use super::layout::{Layout, NOWHERE, Place};
use super::object::{Direction, Lock};
use super::packing::{PackError, Packed};
use super::rules::{Action, Form, Rules};
use super::state::State;

/// Rooms and doors compiled to a step function. Fields of a packed state from the low end: the direction
/// (2 bits), the agent's place, each object's place, and 2 bits for each door that began `unknown`.
#[derive(Clone, Debug)]
pub struct Dynamics {
    layout: Layout,
    rules: Rules,
    origin: State,
    /// Bits of a place.
    width: u32,
    /// Which field of a packed state holds a door's lock, if it can change; otherwise whether it opens.
    doors: Vec<DoorLock>,
    /// Bits of a state.
    bits: usize,
}

#[derive(Clone, Copy, Debug)]
enum DoorLock {
    /// It is so for ever.
    Fixed { opens: bool },
    /// It is in the two bits from here.
    Field { shift: u32 },
}

/// Bits of a direction, and of a lock.
pub(super) const SMALL: u32 = 2;

impl Dynamics {
    /// Compiles the rooms and doors of a legal state and makes room for its objects.
    ///
    /// # Errors
    /// When the state does not fit in two words.
    pub fn new(state: &State, rules: Rules) -> Result<Self, PackError> {
        let layout = Layout::new(state);
        let width = usize::BITS - layout.len().leading_zeros();
        let places = 1 + state.objects.len();
        let mut bits = SMALL as usize + places * width as usize;
        let mut doors = Vec::with_capacity(state.doors.len());
        for door in &state.doors {
            doors.push(if door.lock == Lock::Unknown {
                let shift = u32::try_from(bits).unwrap_or(u32::MAX);
                bits += SMALL as usize;
                DoorLock::Field { shift }
            } else {
                DoorLock::Fixed { opens: door.lock == Lock::Unlocked }
            });
        }
        if bits > u128::BITS as usize {
            let (objects, cells) = (state.objects.len(), layout.len());
            return Err(PackError::TooLarge { objects, cells, bits });
        }
        Ok(Self { layout, rules, origin: state.clone(), width, doors, bits })
    }

    /// That its states leave room for a mark ([`Packed::marked`]).
    ///
    /// # Errors
    /// When they do not.
    pub fn bears_mark(&self) -> Result<(), PackError> {
        let (objects, cells, bits) = (self.n_objects(), self.layout.len(), self.bits);
        match bits > Packed::MARKABLE {
            true => Err(PackError::TooLarge { objects, cells, bits }),
            false => Ok(()),
        }
    }

    /// The cells of this world.
    #[must_use]
    pub const fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Its rules.
    #[must_use]
    pub const fn rules(&self) -> Rules {
        self.rules
    }

    /// How many objects there are.
    #[must_use]
    pub const fn n_objects(&self) -> usize {
        self.origin.objects.len()
    }

    /// Whether the object with this index can ever be moved: it may be, and is not lost each time.
    #[must_use]
    pub fn can_move(&self, object: usize) -> bool {
        self.rules.movable.allows(object) && self.rules.chances.loss() < 1.0
    }

    /// The actions of this world, in the order of ties.
    #[must_use]
    pub fn actions(&self) -> &'static [Action] {
        self.rules.actions()
    }

    /// Packs a state with the rooms, doors and objects of this world, wherever its things are.
    ///
    /// # Errors
    /// When something stands in a wall.
    pub fn pack(&self, state: &State) -> Result<Packed, PackError> {
        let place = |name: &str, x, y| {
            self.layout.place(x, y).ok_or_else(|| PackError::InWall(name.to_owned()))
        };
        let agent = place("agent", state.agent.x, state.agent.y)?;
        let mut packed = Packed(0).with(0, SMALL, state.agent.direction as u64);
        packed = packed.with(SMALL, self.width, u64::from(agent));
        for (i, o) in state.objects.iter().enumerate().take(self.n_objects()) {
            let here = u64::from(place(&o.name, o.x, o.y)?);
            packed = packed.with(self.object_shift(i), self.width, here);
        }
        for (door, lock) in state.doors.iter().zip(&self.doors) {
            if let DoorLock::Field { shift } = *lock {
                packed = packed.with(shift, SMALL, door.lock as u64);
            }
        }
        Ok(packed)
    }

    /// The state that was packed, with the names and looks of this world.
    #[must_use]
    pub fn unpack(&self, packed: Packed) -> State {
        let mut state = self.origin.clone();
        (state.agent.x, state.agent.y) = self.layout.cell(self.agent(packed));
        state.agent.direction = self.heading(packed);
        for (i, object) in state.objects.iter_mut().enumerate() {
            (object.x, object.y) = self.layout.cell(self.object(packed, i));
        }
        for (i, door) in state.doors.iter_mut().enumerate() {
            if let Some(lock) = self.lock(packed, i) {
                door.lock = lock;
            }
        }
        state
    }

    /// The direction that the agent faces.
    #[inline]
    #[must_use]
    pub fn heading(&self, packed: Packed) -> Direction {
        Direction::ALL[usize::from(packed.field(0, SMALL))]
    }

    /// Where the agent is.
    #[inline]
    #[must_use]
    pub fn agent(&self, packed: Packed) -> Place {
        packed.field(SMALL, self.width)
    }

    /// The same state with the robot at another place of this layout, facing `heading`; `None` where an object
    /// stands. For showing what every cell is worth.
    #[must_use]
    pub fn with_agent(&self, packed: Packed, place: Place, heading: Direction) -> Option<Packed> {
        let is_free = self.object_at(packed, place).is_none();
        is_free.then(|| self.posed(packed, place, heading))
    }

    /// The same with the robot even where an object stands, as one sees it who sees the robot alone.
    #[must_use]
    pub fn posed(&self, packed: Packed, place: Place, heading: Direction) -> Packed {
        facing(packed.with(SMALL, self.width, u64::from(place)), heading)
    }

    /// Where the object with this index is.
    #[inline]
    #[must_use]
    pub fn object(&self, packed: Packed, index: usize) -> Place {
        packed.field(self.object_shift(index), self.width)
    }

    /// The lock of the door with this index, if it can change in this world.
    #[must_use]
    pub fn lock(&self, packed: Packed, door: usize) -> Option<Lock> {
        match *self.doors.get(door)? {
            DoorLock::Fixed { .. } => None,
            DoorLock::Field { shift } => {
                Lock::ALL.get(usize::from(packed.field(shift, SMALL))).copied()
            }
        }
    }

    /// How many doors there are.
    #[must_use]
    pub const fn n_doors(&self) -> usize {
        self.doors.len()
    }

    /// The same state with another lock on the door with this index, if it can change in this world.
    #[must_use]
    pub fn with_lock(&self, packed: Packed, door: usize, lock: Lock) -> Packed {
        match self.doors.get(door) {
            Some(&DoorLock::Field { shift }) => packed.with(shift, SMALL, lock as u64),
            _ => packed,
        }
    }

    /// Whether a place can be entered at some time: no locked door. Locks are those of `packed`.
    #[inline]
    #[must_use]
    pub fn opens(&self, packed: Packed, place: Place) -> bool {
        let Some(door) = self.layout.door(place) else { return true };
        match self.doors[door] {
            DoorLock::Fixed { opens } => opens,
            DoorLock::Field { shift } => packed.field(shift, SMALL) != Lock::Locked as Place,
        }
    }

    /// What `action` does when nothing goes wrong: no slip, no loss, and a door that is `unknown` opens.
    /// An action that this world lacks does nothing.
    #[must_use]
    pub fn step(&self, packed: Packed, action: Action) -> Packed {
        self.attempt(packed, action).moved
    }

    /// One state for all that neither goals nor actions can tell apart from this one: in compass form, which
    /// way the robot faces matters only to `pull` and only in front of what may be moved; a door that nobody
    /// tried is open when doors never lock, and locked when they always do.
    #[must_use]
    pub fn quotient(&self, packed: Packed) -> Packed {
        let mut result = packed;
        let lock = self.rules.chances.lock();
        if lock == 0.0 || lock == 1.0 {
            let found = if lock == 0.0 { Lock::Unlocked } else { Lock::Locked };
            for door in &self.doors {
                if let DoorLock::Field { shift } = *door
                    && is_unknown(packed, shift)
                {
                    result = result.with(shift, SMALL, found as u64);
                }
            }
        }
        match (self.rules.form, self.rules.pull) {
            (Form::Robot, _) => result,
            (Form::Compass, false) => facing(result, Direction::North),
            (Form::Compass, true) => {
                let agent = self.agent(packed);
                let idle = |d| {
                    let object = self.object_at(packed, self.layout.neighbour(agent, d));
                    object.is_none_or(|o| !self.rules.movable.allows(o))
                };
                match Direction::ALL.iter().find(|d| idle(**d)) {
                    Some(&first) if idle(self.heading(packed)) => facing(result, first),
                    _ => result,
                }
            }
        }
    }

    /// The state with the robot and an object moved to these places, in compass form, as the [`Dynamics::quotient`] of
    /// where the robot faces that object.
    #[inline]
    pub(super) fn moved(
        &self,
        packed: Packed,
        object: usize,
        [agent, to]: [Place; 2],
        heading: Direction,
    ) -> Packed {
        let heading = if self.rules.pull { heading } else { Direction::North };
        let moved = packed.with(SMALL, self.width, u64::from(agent));
        facing(moved.with(self.object_shift(object), self.width, u64::from(to)), heading)
    }

    /// The state with the robot in a door that it found open, in compass form.
    pub(super) fn through(&self, packed: Packed, door: Place, heading: Direction) -> Packed {
        facing(self.agent_to(packed, door), heading)
    }

    /// What an action tries, before anything goes wrong.
    pub(super) fn attempt(&self, packed: Packed, action: Action) -> Attempt {
        let heading = self.heading(packed);
        match (self.rules.step(action, heading), self.rules.form, action) {
            (Some(side), ..) => self.go(packed, side),
            (None, _, Action::Pull) if self.rules.pull => self.pull(packed, heading),
            (None, Form::Robot, Action::TurnLeft) => Attempt::still(facing(packed, heading.left())),
            (None, Form::Robot, Action::TurnRight) => {
                Attempt::still(facing(packed, heading.left().opposite()))
            }
            _ => Attempt::still(packed),
        }
    }

    /// Turns, then steps if that can be, pushing what is in the way.
    fn go(&self, packed: Packed, direction: Direction) -> Attempt {
        let still = facing(packed, direction);
        let ahead = self.layout.neighbour(self.agent(packed), direction);
        if ahead == NOWHERE || !self.opens(packed, ahead) {
            return Attempt::still(still);
        }
        let Some(object) = self.object_at(packed, ahead) else {
            let moved = self.agent_to(still, ahead);
            return Attempt { still, moved, entered: [ahead, NOWHERE], carries: false };
        };
        let beyond = self.layout.neighbour(ahead, direction);
        if beyond == NOWHERE
            || !self.rules.movable.allows(object)
            || !self.opens(packed, beyond)
            || self.object_at(packed, beyond).is_some()
        {
            return Attempt::still(still);
        }
        let moved = self.agent_to(self.object_to(still, object, beyond), ahead);
        Attempt { still, moved, entered: [ahead, beyond], carries: true }
    }

    /// Swaps the robot with the object in the faced cell, then faces it.
    fn pull(&self, packed: Packed, heading: Direction) -> Attempt {
        let here = self.agent(packed);
        let ahead = self.layout.neighbour(here, heading);
        match self.object_at(packed, ahead) {
            Some(object)
                if self.rules.movable.allows(object)
                    && self.opens(packed, ahead)
                    && self.opens(packed, here) =>
            {
                let swapped = self.agent_to(self.object_to(packed, object, here), ahead);
                let moved = facing(swapped, heading.opposite());
                Attempt { still: packed, moved, entered: [ahead, here], carries: true }
            }
            _ => Attempt::still(packed),
        }
    }

    /// The index of the object at a place.
    #[inline]
    fn object_at(&self, packed: Packed, place: Place) -> Option<usize> {
        (0..self.n_objects()).find(|&i| self.object(packed, i) == place)
    }

    fn agent_to(&self, packed: Packed, place: Place) -> Packed {
        self.enter(packed, place).with(SMALL, self.width, u64::from(place))
    }

    fn object_to(&self, packed: Packed, object: usize, place: Place) -> Packed {
        self.enter(packed, place).with(self.object_shift(object), self.width, u64::from(place))
    }

    /// Notes that a door was tried, if the place belongs to one, and found open.
    #[inline]
    fn enter(&self, packed: Packed, place: Place) -> Packed {
        match self.layout.door(place).map(|d| self.doors[d]) {
            Some(DoorLock::Field { shift }) => packed.with(shift, SMALL, Lock::Unlocked as u64),
            _ => packed,
        }
    }

    /// Where the lock of the door is that a place belongs to, if nobody tried that door.
    #[inline]
    pub(super) fn untried(&self, packed: Packed, place: Place) -> Option<u32> {
        if place == NOWHERE {
            return None;
        }
        match self.doors[self.layout.door(place)?] {
            DoorLock::Field { shift } if is_unknown(packed, shift) => Some(shift),
            _ => None,
        }
    }

    /// Whether nothing is left to chance from a state on.
    #[must_use]
    pub fn is_deterministic(&self, packed: Packed) -> bool {
        let chances = self.rules.chances;
        let sure = |p: f64| p == 0.0 || p == 1.0;
        let untried = |door: &DoorLock| match *door {
            DoorLock::Field { shift } => is_unknown(packed, shift),
            DoorLock::Fixed { .. } => false,
        };
        sure(chances.slip())
            && (sure(chances.lock()) || !self.doors.iter().any(untried))
            && (sure(chances.loss())
                || !(0..self.n_objects()).any(|o| self.rules.movable.allows(o)))
    }

    #[inline]
    const fn object_shift(&self, index: usize) -> u32 {
        SMALL + self.width * (1 + index as u32)
    }
}

/// What an action tries in a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attempt {
    /// Where it ends when nothing moves; the robot may have turned.
    pub(super) still: Packed,
    /// Where it ends when all goes well, with the doors on the way open.
    pub(super) moved: Packed,
    /// The places that the robot and the object move to, or [`NOWHERE`].
    pub(super) entered: [Place; 2],
    /// Whether an object moves.
    pub(super) carries: bool,
}

impl Attempt {
    /// An action that moves nothing.
    const fn still(still: Packed) -> Self {
        Self { still, moved: still, entered: [NOWHERE; 2], carries: false }
    }
}

#[inline]
const fn facing(packed: Packed, direction: Direction) -> Packed {
    packed.with(0, SMALL, direction as u64)
}

#[inline]
const fn is_unknown(packed: Packed, shift: u32) -> bool {
    packed.field(shift, SMALL) == Lock::Unknown as Place
}
