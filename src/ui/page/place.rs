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

/// Whether the way is one that can be walked in a step: anything further is a jump.
pub fn one_step(before: &State, after: &State) -> bool {
    let (a, b) = (&before.agent, &after.agent);
    let near = |[ax, ay]: [i32; 2], [bx, by]: [i32; 2]| ax.abs_diff(bx) + ay.abs_diff(by) <= 1;
    let same = |name: &str| before.objects.iter().find(|o| o.name == name);
    before.rooms == after.rooms
        && after.objects.iter().all(|o| same(&o.name).is_none_or(|b| near([b.x, b.y], [o.x, o.y])))
        && near([a.x, a.y], [b.x, b.y])
}
