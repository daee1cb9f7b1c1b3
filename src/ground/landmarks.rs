//! What a command says to move, read off its goal: with landmarks that stay where they are, a robot told to walk to
//! the right of the block walks, and does not push the block to its left (Williams et al., Section VII).

use super::goal::{Formula, Goal};
use super::predicate::Relation;
use super::thing::{Entity, Thing};
use crate::domain::{Movable, State};

impl Goal {
    /// The objects of the initial state that the goal says to move: the first arguments of its relations that
    /// stand outside any negation, and of those that it denies though they are so; below `exists`, what its variable
    /// ranges over by its properties. All others are landmarks: put this into [`Rules::movable`](crate::domain::Rules::movable) to have them stay.
    #[must_use]
    pub fn movable(&self, initial: &State) -> Movable {
        let reader = Reader::of(self, initial);
        let object = |name: &str| initial.objects.iter().position(|o| o.name == name);
        let moved = reader.asked.iter().chain(&reader.undone);
        let objects = moved.filter_map(|entity| match entity {
            Entity::Object(name) => object(name),
            _ => None,
        });
        objects.fold(Movable::NONE, Movable::with)
    }

    /// The one thing that the goal says to move: an object as in [`Goal::movable`], or the robot; where it only says
    /// what shall not be, the one thing of which it says so. `None` when there are several, or there is none.
    #[must_use]
    pub fn mover(&self, initial: &State) -> Option<Entity> {
        let Reader { asked, denied, .. } = Reader::of(self, initial);
        match if asked.is_empty() { &denied[..] } else { &asked[..] } {
            [only] => Some((*only).clone()),
            _ => None,
        }
    }
}

struct Reader<'s, 'f> {
    things: Vec<Thing<'s>>,
    /// What comes first in relations that shall be, and in those that shall not: the robot and objects, each once.
    asked: Vec<&'f Entity>,
    denied: Vec<&'f Entity>,
    /// What comes first in relations that shall not be, but are.
    undone: Vec<&'f Entity>,
}

impl<'s, 'f> Reader<'s, 'f> {
    fn of(goal: &'f Goal, initial: &'s State) -> Self {
        let things = Thing::all(initial);
        let mut reader =
            Reader { things, asked: Vec::new(), denied: Vec::new(), undone: Vec::new() };
        reader.read(goal.formula(), true);
        reader
    }

    fn read(&mut self, formula: &'f Formula, positive: bool) {
        if if positive { !self.can_hold(formula) } else { self.must_hold(formula) } {
            return;
        }
        match formula {
            Formula::And(parts) | Formula::Or(parts) => {
                parts.iter().for_each(|part| self.read(part, positive));
            }
            Formula::Exists { known, .. } => known.iter().for_each(|k| self.read(&k.1, positive)),
            Formula::Not(part) => self.read(part, !positive),
            Formula::Relation(relation, first @ (Entity::Agent | Entity::Object(_)), second)
                if *relation != Relation::Eq =>
            {
                if !positive && self.is_so(*relation, first, second) {
                    self.undone.push(first);
                }
                let list = if positive { &mut self.asked } else { &mut self.denied };
                if !list.contains(&first) {
                    list.push(first);
                }
            }
            Formula::Relation(..) | Formula::Property(..) => {}
        }
    }

    /// Whether a relation holds at the outset.
    fn is_so(&self, relation: Relation, a: &Entity, b: &Entity) -> bool {
        let find = |entity: &Entity| self.things.iter().find(|thing| thing.is(entity));
        find(a).zip(find(b)).is_some_and(|(a, b)| relation.holds(*a, *b))
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
