//! Places in a world: a cell by column and row, what stands on it, and which are to be seen.

use crate::domain::State;
use crate::render::{Extent, Thing};

/// Column and row.
pub type Place = (i32, i32);

/// What stands on a cell.
pub fn item_at(state: &State, (x, y): Place) -> Option<Thing> {
    if (state.agent.x, state.agent.y) == (x, y) {
        return Some(Thing::Robot);
    }
    state.objects.iter().position(|o| (o.x, o.y) == (x, y)).map(Thing::Object)
}

/// The nearest cell that a world's picture shows.
pub fn inside(state: &State, (x, y): Place) -> Place {
    let Extent { left, bottom, columns, rows } = Extent::of(state);
    let last = |first: i32, n: u32| first.saturating_add_unsigned(n.saturating_sub(1));
    (x.clamp(left, last(left, columns)), y.clamp(bottom, last(bottom, rows)))
}
