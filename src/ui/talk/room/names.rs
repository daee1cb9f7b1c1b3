//! What rooms are called, on their walls: each name on the wall above its room, or below it, where no door is.

use crate::domain::{Bounds, Cell, State, cell_at};
use crate::ui::page::grammar::Phrases;

/// A letter's width, in cells.
const LETTER: f32 = 0.18;

/// A name on a wall.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The column where it begins, between cells.
    pub x: f32,
    /// The row of the wall.
    pub y: i32,
    /// The name, as much of it as there is room for.
    pub text: String,
}

/// The names of a world's rooms.
pub fn names(world: &State, phrases: &dyn Phrases) -> Vec<Name> {
    let mut taken: Vec<(i32, i32)> = Vec::new();
    let names = world.rooms.iter().filter_map(|room| {
        let color = phrases.color(room.color);
        let letter = color.get(..1).unwrap_or_default().to_ascii_uppercase();
        [phrases.room(room.color), color.to_owned(), letter].into_iter().find_map(|text| {
            let cells = (text.chars().count() as f32 * LETTER).ceil() as i32;
            let (x, y) = free(world, room.bounds, cells, &taken)?;
            taken.extend((x..x + cells).map(|x| (x, y)));
            Some(Name { x: x as f32 - 0.42, y, text })
        })
    });
    names.collect()
}

/// Where so many cells of wall are free above a room, or below it.
fn free(world: &State, bounds: Bounds, cells: i32, taken: &[(i32, i32)]) -> Option<(i32, i32)> {
    let is_free = |x: i32, y: i32| {
        cell_at(&world.rooms, &world.doors, x, y) == Cell::Wall && !taken.contains(&(x, y))
    };
    let Bounds { left, bottom, right, top } = bounds;
    [top, bottom].into_iter().find_map(|y| {
        let starts = left + 1..=right - cells;
        starts.map(|x| (x, y)).find(|&(x, y)| (x..x + cells).all(|x| is_free(x, y)))
    })
}
