//! What one would do who knows only where a run ends: the shortest way to the same rooms, by breadth-first search. It
//! tells apart from the run what the way there is to be like.

use super::cell::{Cell, cell_at};
use super::dynamics::Dynamics;
use super::packing::Packed;
use super::rules::{Action, Movable, Rules};
use super::state::State;
use super::way::Way;
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// States that are looked at.
const MOST_STATES: usize = 20_000;

/// The shortest way to the rooms where a run ends, if it leads through others than the run does; nothing where it does
/// not, where the run ends in the rooms that it began in, or where looking for it would take long.
pub fn straight(start: &State, actions: &[Action]) -> Option<Box<[Action]>> {
    let run = walked(start, actions)?;
    let last = run.last()?;
    let is_moved = |&at: &usize| {
        let place = |state: &State| state.objects.get(at).map(|object| (object.x, object.y));
        place(start) != place(last)
    };
    let moved: Vec<usize> = (0..start.objects.len()).filter(is_moved).collect();
    let movable = moved.iter().fold(Movable::NONE, |all, &at| all.with(at));
    let dynamics = Dynamics::new(start, Rules { movable, ..Rules::default() }).ok()?;
    let regions: Vec<Region> =
        dynamics.layout().places().map(|at| region(start, dynamics.layout().cell(at))).collect();
    let ends = |packed: Packed| {
        let places = moved.iter().map(|&at| dynamics.object(packed, at));
        let places = std::iter::once(dynamics.agent(packed)).chain(places);
        places.map(|place| regions[usize::from(place)]).collect::<Vec<_>>()
    };
    let wanted = ends(dynamics.pack(last).ok()?);
    let found = search(&dynamics, dynamics.pack(start).ok()?, |packed| ends(packed) == wanted)?;
    let other = walked(start, &found)?;
    let differs = passed(&run, None) != passed(&other, None)
        || moved.iter().any(|&at| passed(&run, Some(at)) != passed(&other, Some(at)));
    (differs && !found.is_empty()).then_some(found)
}

/// The rooms that the robot, or an object, is in one after the other, by their places in the state.
pub fn passed(states: &[State], object: Option<usize>) -> Vec<usize> {
    let room = |state: &State| {
        let cell = match object {
            None => (state.agent.x, state.agent.y),
            Some(at) => state.objects.get(at).map(|object| (object.x, object.y))?,
        };
        match region(state, cell) {
            Region::Room(room) => Some(room),
            _ => None,
        }
    };
    let mut rooms: Vec<usize> = states.iter().filter_map(room).collect();
    rooms.dedup();
    rooms
}

/// After how many actions all that is moved on a way has come to the room, or the door, that it stays in.
pub fn arrived(states: &[State]) -> usize {
    let places = |state: &State| {
        let agent = region(state, (state.agent.x, state.agent.y));
        let objects = state.objects.iter().map(|object| region(state, (object.x, object.y)));
        std::iter::once(agent).chain(objects).collect::<Vec<_>>()
    };
    let last = states.last().map(places);
    states.iter().rposition(|state| Some(places(state)) != last).map_or(0, |at| at + 1)
}

/// What a cell belongs to, by its place in the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// A room.
    Room(usize),
    /// A door.
    Door(usize),
    /// Neither.
    Wall,
}

/// What a cell belongs to.
pub fn region(state: &State, (x, y): (i32, i32)) -> Region {
    match cell_at(&state.rooms, &state.doors, x, y) {
        Cell::Door(door) => Region::Door(door),
        _ => {
            let mut rooms = state.rooms.iter();
            rooms
                .position(|room| room.bounds.strictly_inside(x, y))
                .map_or(Region::Wall, Region::Room)
        }
    }
}

/// The states of a way, its start among them.
fn walked(start: &State, actions: &[Action]) -> Option<Vec<State>> {
    let way = Way { actions: actions.into(), ..Way::default() };
    way.states(start).ok()?.into_iter().next()
}

fn search(
    dynamics: &Dynamics,
    start: Packed,
    is_end: impl Fn(Packed) -> bool,
) -> Option<Box<[Action]>> {
    // Each state with the place of the one before it, and the action from there.
    let mut seen: IndexMap<Packed, (usize, Action), FxBuildHasher> = IndexMap::default();
    let start = dynamics.quotient(start);
    seen.insert(start, (0, Action::North));
    let mut at = 0;
    while let Some((&packed, _)) = seen.get_index(at) {
        if is_end(packed) {
            let mut actions = Vec::new();
            while at > 0 {
                let (_, &(before, action)) = seen.get_index(at)?;
                actions.push(action);
                at = before;
            }
            actions.reverse();
            return Some(actions.into());
        }
        for &action in dynamics.actions() {
            let next = dynamics.quotient(dynamics.step(packed, action));
            if seen.len() < MOST_STATES {
                seen.entry(next).or_insert((at, action));
            }
        }
        at += 1;
    }
    None
}
