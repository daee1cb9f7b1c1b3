//! How Cleanup World moves (Williams et al., Section III), on packed states: agent, objects and tried doors
//! in two machine words, no allocation in a step. One object is pushed at a time; `pull` swaps.
//! Invariant: `unpack` after `pack` is the identity, and a step from a legal state ends in a legal state.

use super::layout::{Layout, NOWHERE, Place};
use super::name::named;
use super::object::{Direction, Lock};
use super::state::State;

/// What the robot can do: turn to a side and step, pushing what is in the way; or pull what it faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Action {
    North,
    South,
    East,
    West,
    Pull,
}

named!(
    Action, "action",
    North "north" 'n', South "south" 's', East "east" 'e', West "west" 'w', Pull "pull" 'p',
);

/// The rules that can differ between worlds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rules {
    /// Whether there is the action `pull`.
    pub pull: bool,
}

/// A state in two machine words; only the [`Dynamics`] that packed it can read it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Packed(u128);

/// Why a state cannot be packed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PackError {
    /// The fields need more bits than there are.
    #[error(
        "{objects} objects in {cells} cells need {bits} bits, more than {}: use fewer objects or a smaller world",
        u128::BITS
    )]
    TooLarge {
        /// How many objects there are.
        objects: usize,
        /// How many cells are no wall.
        cells: usize,
        /// How many bits all fields need.
        bits: usize,
    },
    /// Something stands in a wall.
    #[error("`{0}` stands in a wall")]
    InWall(String),
}

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
}

#[derive(Clone, Copy, Debug)]
enum DoorLock {
    /// It is so for ever.
    Fixed { opens: bool },
    /// It is in the two bits from here.
    Field { shift: u32 },
}

/// Bits of a direction, and of a lock.
const SMALL: u32 = 2;

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
        Ok(Self { layout, rules, origin: state.clone(), width, doors })
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

    /// The actions of this world, in the order of ties.
    #[must_use]
    pub fn actions(&self) -> &'static [Action] {
        let all = Action::ALL;
        if self.rules.pull { all } else { &all[..all.len() - 1] }
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
        let mut packed = with(0, 0, SMALL, state.agent.direction as u128);
        packed = with(packed, SMALL, self.width, u128::from(agent));
        for (i, o) in state.objects.iter().enumerate().take(self.n_objects()) {
            let here = u128::from(place(&o.name, o.x, o.y)?);
            packed = with(packed, self.object_shift(i), self.width, here);
        }
        for (door, lock) in state.doors.iter().zip(&self.doors) {
            if let DoorLock::Field { shift } = *lock {
                packed = with(packed, shift, SMALL, door.lock as u128);
            }
        }
        Ok(Packed(packed))
    }

    /// The state that was packed, with the names and looks of this world.
    #[must_use]
    pub fn unpack(&self, packed: Packed) -> State {
        let mut state = self.origin.clone();
        (state.agent.x, state.agent.y) = self.layout.cell(self.agent(packed));
        state.agent.direction = direction(packed);
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

    /// Where the agent is.
    #[inline]
    #[must_use]
    pub fn agent(&self, packed: Packed) -> Place {
        field(packed, SMALL, self.width)
    }

    /// Where the object with this index is.
    #[inline]
    #[must_use]
    pub fn object(&self, packed: Packed, index: usize) -> Place {
        field(packed, self.object_shift(index), self.width)
    }

    /// The lock of the door with this index, if it can change in this world.
    #[must_use]
    pub fn lock(&self, packed: Packed, door: usize) -> Option<Lock> {
        match *self.doors.get(door)? {
            DoorLock::Fixed { .. } => None,
            DoorLock::Field { shift } => {
                Lock::ALL.get(usize::from(field(packed, shift, SMALL))).copied()
            }
        }
    }

    /// Whether a place can be entered at some time: no locked door. Locks are those of `packed`.
    #[inline]
    #[must_use]
    pub fn opens(&self, packed: Packed, place: Place) -> bool {
        let Some(door) = self.layout.door(place) else { return true };
        match self.doors[door] {
            DoorLock::Fixed { opens } => opens,
            DoorLock::Field { shift } => field(packed, shift, SMALL) != Lock::Locked as Place,
        }
    }

    /// What `action` does in the deterministic world, where a door that is `unknown` opens.
    #[must_use]
    pub fn step(&self, packed: Packed, action: Action) -> Packed {
        match action {
            Action::North => self.go(packed, Direction::North),
            Action::South => self.go(packed, Direction::South),
            Action::East => self.go(packed, Direction::East),
            Action::West => self.go(packed, Direction::West),
            Action::Pull => self.pull(packed),
        }
    }

    /// One state for all that neither goals nor actions can tell apart from this one: which way the robot
    /// faces matters only to `pull` and only in front of an object, and a door that opens is open.
    #[must_use]
    pub fn quotient(&self, packed: Packed) -> Packed {
        let mut result = packed;
        for lock in &self.doors {
            if let DoorLock::Field { shift } = *lock
                && field(packed, shift, SMALL) == Lock::Unknown as Place
            {
                result = Packed(with(result.0, shift, SMALL, Lock::Unlocked as u128));
            }
        }
        let agent = self.agent(packed);
        let idle = |d| self.object_at(packed, self.layout.neighbour(agent, d)).is_none();
        if !self.rules.pull {
            return facing(result, Direction::North);
        }
        if idle(direction(packed))
            && let Some(&first) = Direction::ALL.iter().find(|d| idle(**d))
        {
            result = facing(result, first);
        }
        result
    }

    /// Turns, then steps if that can be, pushing what is in the way.
    fn go(&self, packed: Packed, direction: Direction) -> Packed {
        let turned = facing(packed, direction);
        let ahead = self.layout.neighbour(self.agent(packed), direction);
        if ahead == NOWHERE || !self.opens(packed, ahead) {
            return turned;
        }
        let Some(object) = self.object_at(packed, ahead) else {
            return self.agent_to(turned, ahead);
        };
        let beyond = self.layout.neighbour(ahead, direction);
        if beyond == NOWHERE
            || !self.opens(packed, beyond)
            || self.object_at(packed, beyond).is_some()
        {
            return turned;
        }
        self.agent_to(self.object_to(turned, object, beyond), ahead)
    }

    /// Swaps the robot with the object in the faced cell, then faces it.
    fn pull(&self, packed: Packed) -> Packed {
        let direction = direction(packed);
        let here = self.agent(packed);
        let ahead = self.layout.neighbour(here, direction);
        let Some(object) = self.object_at(packed, ahead) else { return packed };
        if !self.rules.pull || !self.opens(packed, ahead) || !self.opens(packed, here) {
            return packed;
        }
        let swapped = self.agent_to(self.object_to(packed, object, here), ahead);
        facing(swapped, direction.opposite())
    }

    /// The index of the object at a place.
    #[inline]
    fn object_at(&self, packed: Packed, place: Place) -> Option<usize> {
        (0..self.n_objects()).find(|&i| self.object(packed, i) == place)
    }

    fn agent_to(&self, packed: Packed, place: Place) -> Packed {
        Packed(with(self.enter(packed, place).0, SMALL, self.width, u128::from(place)))
    }

    fn object_to(&self, packed: Packed, object: usize, place: Place) -> Packed {
        let shift = self.object_shift(object);
        Packed(with(self.enter(packed, place).0, shift, self.width, u128::from(place)))
    }

    /// Notes that a door was tried, if the place belongs to one, and found open.
    #[inline]
    fn enter(&self, packed: Packed, place: Place) -> Packed {
        match self.layout.door(place).map(|d| self.doors[d]) {
            Some(DoorLock::Field { shift }) => {
                Packed(with(packed.0, shift, SMALL, Lock::Unlocked as u128))
            }
            _ => packed,
        }
    }

    #[inline]
    const fn object_shift(&self, index: usize) -> u32 {
        SMALL + self.width * (1 + index as u32)
    }
}

fn direction(packed: Packed) -> Direction {
    Direction::ALL[usize::from(field(packed, 0, SMALL))]
}

#[inline]
fn facing(packed: Packed, direction: Direction) -> Packed {
    Packed(with(packed.0, 0, SMALL, direction as u128))
}

#[inline]
fn field(packed: Packed, shift: u32, width: u32) -> Place {
    let mask = (1 << width) - 1;
    ((packed.0 >> shift) & mask) as Place
}

/// `word` with `value` in the `width` bits from `shift`.
#[inline]
const fn with(word: u128, shift: u32, width: u32, value: u128) -> u128 {
    let mask = ((1 << width) - 1) << shift;
    (word & !mask) | (value << shift)
}
