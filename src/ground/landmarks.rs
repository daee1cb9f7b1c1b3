//! What a command says to move, read off its goal: with landmarks that stay where they are, a robot told to walk to
//! the right of the block walks, and does not push the block to its left (Williams et al., Section VII).

use super::goal::{Formula, Goal};
use super::predicate::Relation;
use super::thing::{Entity, Thing};
use crate::domain::{Movable, State};

impl Goal {
    /// The objects of the initial state that the goal says to move: the first arguments of its relations that
    /// stand outside any negation; below `exists`, what its variable ranges over by its properties. All others
    /// are landmarks: put this into [`Rules::movable`](crate::domain::Rules::movable) to have them stay.
    #[must_use]
    pub fn movable(&self, initial: &State) -> Movable {
        let mut reader = Reader { things: Thing::all(initial), initial, movable: Movable::NONE };
        reader.read(self.formula());
        reader.movable
    }
}

struct Reader<'s> {
    things: Vec<Thing<'s>>,
    initial: &'s State,
    movable: Movable,
}

impl Reader<'_> {
    fn read(&mut self, formula: &Formula) {
        if !self.can_hold(formula) {
            return;
        }
        match formula {
            Formula::And(parts) | Formula::Or(parts) => parts.iter().for_each(|p| self.read(p)),
            Formula::Exists { known, .. } => known.iter().for_each(|k| self.read(&k.1)),
            Formula::Relation(relation, Entity::Object(name), _) if *relation != Relation::Eq => {
                if let Some(index) = self.initial.objects.iter().position(|o| o.name == *name) {
                    self.movable = self.movable.with(index);
                }
            }
            Formula::Relation(..) | Formula::Property(..) | Formula::Not(_) => {}
        }
    }

    /// Whether properties, which nothing changes, leave it a chance to hold somewhere.
    fn can_hold(&self, formula: &Formula) -> bool {
        match formula {
            Formula::And(parts) => parts.iter().all(|p| self.can_hold(p)),
            Formula::Or(parts) => parts.iter().any(|p| self.can_hold(p)),
            Formula::Exists { known, .. } => known.iter().any(|k| self.can_hold(&k.1)),
            Formula::Not(part) => !self.must_hold(part),
            Formula::Property(..) => self.must_hold(formula),
            Formula::Relation(Relation::Eq, a, b) => a == b,
            Formula::Relation(_, a, b) => a != b,
        }
    }

    /// Whether properties alone make it hold everywhere.
    fn must_hold(&self, formula: &Formula) -> bool {
        match formula {
            Formula::And(parts) => parts.iter().all(|p| self.must_hold(p)),
            Formula::Or(parts) => parts.iter().any(|p| self.must_hold(p)),
            Formula::Exists { known, .. } => known.iter().any(|k| self.must_hold(&k.1)),
            Formula::Not(part) => !self.can_hold(part),
            Formula::Property(property, of) => {
                self.things.iter().any(|t| t.is(of) && property.holds(*t))
            }
            Formula::Relation(Relation::Eq, a, b) => a == b,
            Formula::Relation(..) => false,
        }
    }
}
