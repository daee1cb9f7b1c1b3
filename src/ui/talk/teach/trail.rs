//! Ways that the robot is driven, as actions: drawn by a hand that takes it along, and through the states of a plan.

use crate::domain::{Direction, State as World, Way, letters};
use crate::render::Thing;
use crate::ui::page::place::Place;
use crate::ui::talk::room::edit;

/// A way as it is drawn while a hand takes the robot along.
#[derive(Clone, Debug, PartialEq)]
pub struct Trail {
    /// The world as it is at its end.
    pub world: World,
    /// The actions so far.
    pub steps: String,
}

impl Trail {
    /// A way that begins where the robot stands.
    pub fn new(world: &World) -> Trail {
        Trail { world: world.clone(), steps: String::new() }
    }

    /// The way on to a cell, the longer side first, then the other way round; one over a cell that cannot be stood on goes
    /// on from the next. Nothing where a wall or a thing stands between.
    #[must_use]
    pub fn to(self, (x, y): Place) -> Option<Trail> {
        if edit::put(&self.world, Thing::Robot, (x, y)).is_err() {
            return Some(self);
        }
        let (dx, dy) = (x - self.world.agent.x, y - self.world.agent.y);
        let across = if dx > 0 { Direction::East } else { Direction::West };
        let along = if dy > 0 { Direction::North } else { Direction::South };
        let (across, along) = ((across, dx.unsigned_abs()), (along, dy.unsigned_abs()));
        let legs = if across.1 >= along.1 { [across, along] } else { [along, across] };
        let go = |legs: [(Direction, u32); 2]| {
            let mut trail = self.clone();
            for (direction, count) in legs {
                for _ in 0..count {
                    trail.step(direction)?;
                }
            }
            Some(trail)
        };
        go(legs).or_else(|| go([legs[1], legs[0]]))
    }

    /// Whether it leads anywhere, and there.
    pub fn leads_to(&self, cell: Place) -> bool {
        !self.steps.is_empty() && (self.world.agent.x, self.world.agent.y) == cell
    }

    /// A step that pushes nothing.
    fn step(&mut self, direction: Direction) -> Option<()> {
        let next = edit::drive(&self.world, direction).ok()?;
        let at = (next.agent.x, next.agent.y) != (self.world.agent.x, self.world.agent.y);
        if !at || next.objects != self.world.objects {
            return None;
        }
        self.steps.push(edit::action(direction).letter());
        self.world = next;
        Some(())
    }
}

/// Actions that lead the robot through states, where there are such: turning is no step of a way.
pub fn driving(states: &[World]) -> Option<String> {
    let step = |pair: &[World]| {
        let [from, to] = pair else { return None };
        let step = (to.agent.x - from.agent.x, to.agent.y - from.agent.y);
        Direction::ALL.iter().copied().find(|direction| direction.step() == step)
    };
    let steps = states.windows(2).filter_map(step).map(edit::action);
    let way = Way { actions: steps.collect(), ..Way::default() };
    let (first, last) = (states.first()?, states.last()?);
    let end = way.states(first).ok()?.into_iter().next()?.pop()?;
    let is_there = end.objects == last.objects
        && (end.agent.x, end.agent.y) == (last.agent.x, last.agent.y)
        && !way.actions.is_empty();
    is_there.then(|| letters(&way.actions))
}
