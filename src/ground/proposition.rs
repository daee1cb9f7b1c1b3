//! Guards as propositions over few atoms, for asking what runs there can be: before a world is known, every closed
//! atom is independent of the others; in a world, phrases are resolved and a body is in one place at a time.

use super::class::Class;
use super::goal::{Formula, Goal, GoalError};
use super::outline::Outline;
use super::predicate::Relation;
use super::thing::{Entity, Thing};
use crate::domain::State;
use crate::logic::{Node, TermId, Terms, print};

/// What may be so in a state.
#[derive(Clone, Debug, PartialEq)]
enum Atom {
    /// A closed term, whatever it says.
    Said(TermId),
    /// A body is in a region.
    Within(Entity, Entity),
    /// Anything else about a world's entities.
    Other(Formula),
}

/// What is asked of a state.
#[derive(Clone, Debug)]
enum Proposition {
    Atom(usize),
    Not(Box<Proposition>),
    And(Vec<Proposition>),
    Or(Vec<Proposition>),
}

/// Propositions over the same atoms.
#[derive(Clone, Debug, Default)]
pub(super) struct Propositions {
    atoms: Vec<Atom>,
    /// What each atom is called.
    names: Vec<String>,
}

/// The guards of a task as propositions.
pub(super) struct Guards(Vec<Proposition>);

impl Propositions {
    /// The guards of a task where no world is known.
    pub(super) fn said(&mut self, terms: &Terms, outline: &Outline) -> Guards {
        Guards(outline.guards().iter().map(|&guard| self.of_term(terms, guard)).collect())
    }

    /// The guards of a task in a world.
    pub(super) fn bound(
        &mut self,
        terms: &Terms,
        outline: &Outline,
        world: &State,
    ) -> Result<Guards, GoalError> {
        let things = Thing::all(world);
        let goals = outline.guards().iter().map(|&guard| Goal::new(terms, guard, world));
        let guards = goals.map(|goal| Ok(self.of_formula(goal?.formula(), &things)));
        Ok(Guards(guards.collect::<Result<_, GoalError>>()?))
    }

    /// What may be so in a state, an atom a bit: every combination, but that a body is in two places.
    /// `None` when these are more than `most`.
    pub(super) fn worlds(&self, most: usize) -> Option<Vec<u64>> {
        let mut worlds = vec![0_u64];
        let mut done = vec![false; self.atoms.len()];
        for at in 0..self.atoms.len() {
            if done[at] {
                continue;
            }
            let is_along = |other: usize| match (&self.atoms[at], &self.atoms[other]) {
                (Atom::Within(body, _), Atom::Within(same, _)) => body == same,
                _ => other == at,
            };
            let group: Vec<usize> =
                (at..self.atoms.len()).filter(|&other| is_along(other)).collect();
            let mut more = worlds.clone();
            for &atom in &group {
                done[atom] = true;
                more.extend(
                    worlds.iter().map(|world| world | 1_u64.checked_shl(atom as u32).unwrap_or(0)),
                );
            }
            if more.len() > most || self.atoms.len() > 64 {
                return None;
            }
            worlds = more;
        }
        Some(worlds)
    }

    /// What is so, in words.
    pub(super) fn names(&self, world: u64) -> Vec<String> {
        let so = self.names.iter().enumerate().filter(|(at, _)| world >> at & 1 == 1);
        so.map(|(_, name)| name.clone()).collect()
    }

    fn atom(&mut self, atom: Atom, name: impl FnOnce() -> String) -> Proposition {
        let known = self.atoms.iter().position(|known| *known == atom);
        Proposition::Atom(known.unwrap_or_else(|| {
            self.atoms.push(atom);
            self.names.push(name());
            self.atoms.len() - 1
        }))
    }

    fn of_term(&mut self, terms: &Terms, term: TermId) -> Proposition {
        let (head, args) = match terms.node(term) {
            Node::Apply { head, args } => (head, args),
            _ => (term, &[][..]),
        };
        let name = match terms.node(head) {
            Node::Constant(constant) => terms.name(constant),
            _ => "",
        };
        match (name, args) {
            ("true", []) => Proposition::And(Vec::new()),
            ("false", []) => Proposition::Or(Vec::new()),
            ("not", &[denied]) => Proposition::Not(Box::new(self.of_term(terms, denied))),
            ("and", all) => {
                Proposition::And(all.iter().map(|&part| self.of_term(terms, part)).collect())
            }
            ("or", any) => {
                Proposition::Or(any.iter().map(|&part| self.of_term(terms, part)).collect())
            }
            _ => self.atom(Atom::Said(term), || print(terms, term)),
        }
    }

    fn of_formula(&mut self, formula: &Formula, things: &[Thing<'_>]) -> Proposition {
        let certain = |value: bool| {
            if value { Proposition::And(Vec::new()) } else { Proposition::Or(Vec::new()) }
        };
        let find = |entity: &Entity| things.iter().find(|thing| thing.is(entity)).copied();
        match formula {
            Formula::And(all) => {
                Proposition::And(all.iter().map(|part| self.of_formula(part, things)).collect())
            }
            Formula::Or(any) => {
                Proposition::Or(any.iter().map(|part| self.of_formula(part, things)).collect())
            }
            Formula::Not(part) => Proposition::Not(Box::new(self.of_formula(part, things))),
            // What a thing is like does not change.
            Formula::Property(property, of) => {
                certain(find(of).is_some_and(|thing| property.holds(thing)))
            }
            Formula::Relation(Relation::Eq, a, b) => certain(a == b),
            Formula::Relation(relation, a, b) => match (find(a), find(b)) {
                (Some(one), Some(other)) if can_be(*relation, one, other) => {
                    let name = || {
                        format!("({} {} {})", relation_name(*relation), called(one), called(other))
                    };
                    let atom = match relation {
                        Relation::In => Atom::Within(a.clone(), b.clone()),
                        _ => Atom::Other(formula.clone()),
                    };
                    self.atom(atom, name)
                }
                _ => certain(false),
            },
            Formula::Exists { .. } => {
                let number = self.atoms.len();
                self.atom(Atom::Other(formula.clone()), || format!("(exists {number})"))
            }
        }
    }
}

impl Guards {
    /// Which guards hold where these atoms do.
    pub(super) fn valuation(&self, world: u64) -> u64 {
        let holds = self.0.iter().map(|guard| guard.holds(world));
        holds.enumerate().fold(0, |bits, (at, holds)| bits | u64::from(holds) << at)
    }
}

impl Proposition {
    fn holds(&self, world: u64) -> bool {
        match self {
            Proposition::Atom(at) => world >> at & 1 == 1,
            Proposition::Not(part) => !part.holds(world),
            Proposition::And(all) => all.iter().all(|part| part.holds(world)),
            Proposition::Or(any) => any.iter().any(|part| part.holds(world)),
        }
    }
}

/// Whether two things can ever stand in a relation.
fn can_be(relation: Relation, a: Thing<'_>, b: Thing<'_>) -> bool {
    match relation {
        Relation::In => a.cell().is_some() && b.bounds().is_some(),
        _ => a.cell().is_some() && b.cell().is_some() && a.entity() != b.entity(),
    }
}

fn relation_name(relation: Relation) -> &'static str {
    match relation {
        Relation::In => "in",
        Relation::Near => "near",
        Relation::Left => "left",
        Relation::Right => "right",
        Relation::Eq => "eq",
    }
}

fn called(thing: Thing<'_>) -> &str {
    match thing {
        Thing::Agent { .. } => Class::Agent.name(),
        Thing::Room(room) => &room.name,
        Thing::Door(door) => &door.name,
        Thing::Object(object) => &object.name,
    }
}
