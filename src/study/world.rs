//! The worlds that a task is shown in: rooms like those of the corpora, or more of them, with the colours and the
//! things that it asks for. Invariant: a pure function of the task and the state of the generator.

use super::tasks::{Paint, StudyTask};
use crate::domain::layout::{NOWHERE, Place};
use crate::domain::{
    Blueprint, Color, Direction, Layout, Lock, Object, Plan, State, Style, generate,
};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

/// Cells of a side of a world of more than three rooms: fewest and most.
const SIDE: std::ops::RangeInclusive<u32> = 11..=14;

/// A world, or why this draw is none for the task.
pub(super) fn world(task: &StudyTask, rng: &mut Pcg64Mcg) -> Result<State, &'static str> {
    let mut state = rooms(task, rng)?;
    let mut sizes: Vec<i64> = state.rooms.iter().map(|r| r.bounds.area()).collect();
    sizes.sort_unstable();
    let is_apart = |pair: &[i64]| pair[1] * 4 >= pair[0] * 5;
    if task.apart && !sizes.windows(2).all(is_apart) {
        return Err("its rooms are too much of one size");
    }
    let layout = Layout::new(&state);
    let stands = layout.place(state.agent.x, state.agent.y);
    let is_free =
        |&p: &Place| layout.door(p).is_none() && stands != Some(p) && !is_corner(&layout, p);
    let mut floor: Vec<Place> = layout.places().filter(is_free).collect();
    for (number, look) in task.things.iter().enumerate() {
        let alike = task.things.iter().filter(|t| t.shape == look.shape).map(|t| t.paint);
        let color =
            color(look.paint, &named(alike), rng).ok_or("every colour of a shape is named")?;
        if floor.is_empty() {
            return Err("its floor is too small for its things");
        }
        let (x, y) = layout.cell(floor.swap_remove(below(floor.len(), rng)));
        let (name, shape) = (format!("object{number}"), look.shape);
        state.objects.push(Object { name, shape, color, size: look.size, x, y });
    }
    state.doors.iter_mut().for_each(|door| door.lock = Lock::Unlocked);
    if task.doorway && !state.doors.is_empty() && rng.random_bool(0.5) {
        let door = &state.doors[below(state.doors.len(), rng)].bounds;
        (state.agent.x, state.agent.y) = (door.left, door.bottom);
    }
    Ok(state)
}

/// The rooms in their colours, with the robot and no things.
fn rooms(task: &StudyTask, rng: &mut Pcg64Mcg) -> Result<State, &'static str> {
    let mut state = if task.rooms.len() == 3 {
        generate(&Plan { objects: (0, 0), ..Plan::default() }, rng.random())
    } else {
        let blueprint = Blueprint {
            style: if rng.random_bool(0.5) { Style::Cuts } else { Style::Hall },
            rooms: u32::try_from(task.rooms.len()).unwrap_or(u32::MAX),
            columns: rng.random_range(SIDE),
            rows: rng.random_range(SIDE),
            objects: 0,
            ..Blueprint::default()
        };
        blueprint.build(rng.random()).map_err(|_| "its rooms do not fit")?
    };
    let mut paints = task.rooms.clone();
    let mut named = named(task.rooms.iter().copied());
    for room in &mut state.rooms {
        let paint = paints.swap_remove(below(paints.len(), rng));
        room.color = color(paint, &named, rng).ok_or("every colour is named for a room")?;
        named.push(room.color);
    }
    Ok(state)
}

/// The colours that are named.
fn named(paints: impl Iterator<Item = Paint>) -> Vec<Color> {
    paints.filter_map(|p| if let Paint::Is(color) = p { Some(color) } else { None }).collect()
}

/// A colour that is meant by a paint where these are named; `None` when there is none.
fn color(paint: Paint, named: &[Color], rng: &mut Pcg64Mcg) -> Option<Color> {
    let among = |colors: &[Color], rng: &mut Pcg64Mcg| colors[below(colors.len(), rng)];
    match paint {
        Paint::Is(color) => Some(color),
        Paint::Any => Some(among(Color::ALL, rng)),
        Paint::Other => {
            let others: Vec<Color> =
                Color::ALL.iter().copied().filter(|c| !named.contains(c)).collect();
            (!others.is_empty()).then(|| among(&others, rng))
        }
    }
}

/// Whether there is wall on two sides that meet: nothing is pushed out of there.
fn is_corner(layout: &Layout, place: Place) -> bool {
    let wall = |d| layout.neighbour(place, d) == NOWHERE;
    (wall(Direction::North) || wall(Direction::South))
        && (wall(Direction::East) || wall(Direction::West))
}

/// An index below `len`, which is not 0; drawn as u32, so that it is the same on every target.
fn below(len: usize, rng: &mut Pcg64Mcg) -> usize {
    rng.random_range(0..u32::try_from(len).unwrap_or(u32::MAX)) as usize
}
