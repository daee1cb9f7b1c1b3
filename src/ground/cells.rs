//! Where the thing that a goal speaks of moving could stand for the goal to hold, all else as it is: what the goal
//! comes to, as cells to point at.

use super::goal::{Formula, Goal};
use super::thing::Entity;
use crate::domain::{Layout, Lock, State};

/// The most cells that are tried.
const MAX_CELLS: usize = 32 * 32;
/// The most parts of formulas that are looked at.
const MAX_WORK: usize = 2_000_000;

impl Goal {
    /// The free cells, column and row, on which the [`Goal::mover`] could stand for the goal to hold; a doorway that
    /// is locked is not free. Empty where there is no such thing, or too much to look through.
    #[must_use]
    pub fn cells(&self, state: &State) -> Vec<(i32, i32)> {
        let Some(mover) = self.mover(state).filter(|_| state.check().is_ok()) else {
            return Vec::new();
        };
        let layout = Layout::new(state);
        let others = |x: i32, y: i32| {
            let robot = mover != Entity::Agent && (state.agent.x, state.agent.y) == (x, y);
            let is_mover = |name: &str| matches!(&mover, Entity::Object(own) if own == name);
            robot || state.objects.iter().any(|o| (o.x, o.y) == (x, y) && !is_mover(&o.name))
        };
        let locked = |x: i32, y: i32| {
            state.doors.iter().any(|d| d.lock == Lock::Locked && d.bounds.contains(x, y))
        };
        let free: Vec<(i32, i32)> = layout
            .places()
            .map(|place| layout.cell(place))
            .filter(|&(x, y)| !others(x, y) && !locked(x, y))
            .collect();
        if free.len() > MAX_CELLS || free.len().saturating_mul(size(self.formula())) > MAX_WORK {
            return Vec::new();
        }
        let mut moved = state.clone();
        let holds = |&(x, y): &(i32, i32)| {
            match &mover {
                Entity::Object(name) => {
                    let object = moved.objects.iter_mut().find(|object| object.name == *name);
                    object.into_iter().for_each(|object| (object.x, object.y) = (x, y));
                }
                _ => (moved.agent.x, moved.agent.y) = (x, y),
            }
            self.holds(&moved)
        };
        free.into_iter().filter(holds).collect()
    }
}

fn size(formula: &Formula) -> usize {
    match formula {
        Formula::And(parts) | Formula::Or(parts) => parts.iter().map(size).sum::<usize>() + 1,
        Formula::Not(part) => size(part) + 1,
        Formula::Exists { known, stranger, .. } => {
            known.iter().map(|(_, part)| size(part)).sum::<usize>() + size(stranger) + 1
        }
        Formula::Relation(..) | Formula::Property(..) => 1,
    }
}
