//! What a compiled goal is made of: a tree of atoms over packed states, each a wish about the places of its things.

use super::distance::{Ground, Moves, Table};
use super::predicate::Relation;
use crate::domain::layout::Place;
use crate::domain::{Bounds, Dynamics, Packed};

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Node {
    All(Vec<Node>),
    /// All of these atoms, which want something of two objects or more; the moves of different objects add up.
    Together(Vec<Node>, Vec<Load>),
    Any(Vec<Node>),
    /// By index.
    Atom(usize),
}

/// What a conjunction wants of one object, or of two that it wants nothing else of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Load {
    /// By their indices: wishes of which the one that needs most moves counts.
    One { object: usize, wishes: Vec<usize> },
    /// An atom about two objects.
    Two(usize),
}

/// What stands in one cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Body {
    Agent,
    Object(usize),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Atom {
    pub(super) first: Body,
    /// The second thing of a relation between two; of what is said of one thing, the first once more.
    pub(super) second: Body,
    /// Its wish, by index.
    pub(super) wish: usize,
}

/// What an atom wants of the places of its things, whichever these are; the key of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    Inside {
        region: Bounds,
        robot: bool,
        wanted: bool,
    },
    /// The thing stands in a relation to whatever is in a cell.
    Next {
        relation: Relation,
        cell: (i32, i32),
        robot: bool,
        wanted: bool,
    },
    Beside {
        relation: Relation,
        robot: bool,
        wanted: bool,
    },
}

impl Wish {
    /// Whether things in these two cells (the same twice for what is said of one) are as wished.
    #[inline]
    pub(super) fn holds(self, first: (i32, i32), second: (i32, i32)) -> bool {
        match self {
            Self::Inside { region, wanted, .. } => {
                region.strictly_inside(first.0, first.1) == wanted
            }
            Self::Next { relation, cell, wanted, .. } => stand(relation, first, cell) == wanted,
            Self::Beside { relation, wanted, .. } => stand(relation, first, second) == wanted,
        }
    }

    /// The bounds that it gives.
    pub(super) fn table(self, dynamics: &Dynamics, ground: &Ground<'_>) -> Table {
        let cell = |p: Place| dynamics.layout().cell(p);
        let holds = |a: Place, b: Place| self.holds(cell(a), cell(b));
        match self {
            Self::Inside { robot: true, .. } | Self::Next { robot: true, .. } => {
                ground.robot(|p| holds(p, p))
            }
            Self::Inside { .. } | Self::Next { .. } => {
                let ends: Vec<bool> = dynamics.layout().places().map(|p| holds(p, p)).collect();
                ground.carry(|_, object| ends[usize::from(object)])
            }
            Self::Beside { robot: true, .. } => ground.carry(holds),
            Self::Beside { robot: false, .. } => ground.two_objects(holds),
        }
    }

    /// The moves of an object that it needs, when it is about one object alone.
    pub(super) fn moves(self, dynamics: &Dynamics, ground: &Ground<'_>) -> Option<Moves> {
        let cell = |p: Place| dynamics.layout().cell(p);
        match self {
            Self::Inside { robot: false, .. } | Self::Next { robot: false, .. } => {
                Some(ground.moves(|p| self.holds(cell(p), cell(p))))
            }
            _ => None,
        }
    }
}

/// Whether things in two cells stand in a relation.
#[inline]
fn stand(relation: Relation, first: (i32, i32), second: (i32, i32)) -> bool {
    let (dx, dy) = (second.0 - first.0, second.1 - first.1);
    match relation {
        Relation::Left => (dx, dy) == (1, 0),
        Relation::Right => (dx, dy) == (-1, 0),
        Relation::Near => dx.abs().max(dy.abs()) == 1,
        Relation::In | Relation::Eq => false,
    }
}

/// What atoms wish, each once.
#[derive(Debug, Default)]
pub(super) struct Wishes {
    pub(super) all: Vec<Wish>,
    /// Whether some conjunction wants something of several objects.
    pub(super) are_together: bool,
}

impl Wishes {
    /// The index of a wish, which is added if it is not there.
    pub(super) fn index_of(&mut self, wish: Wish) -> usize {
        self.all.iter().position(|known| *known == wish).unwrap_or_else(|| {
            self.all.push(wish);
            self.all.len() - 1
        })
    }

    /// Finds the conjunctions in which the moves of several objects add up.
    pub(super) fn load(&mut self, node: &mut Node, atoms: &[Atom]) {
        let (Node::All(parts) | Node::Any(parts)) = node else { return };
        parts.iter_mut().for_each(|part| self.load(part, atoms));
        let Node::All(parts) = node else { return };
        let indices: Vec<usize> = parts
            .iter()
            .filter_map(|n| if let Node::Atom(index) = n { Some(*index) } else { None })
            .collect();
        let mut loads: Vec<Load> = Vec::new();
        let mut loaded: Vec<Body> = Vec::new();
        for &index in &indices {
            let Atom { first, second, wish } = atoms[index];
            let Body::Object(object) = first else { continue };
            if first != second {
                continue;
            }
            loaded.push(first);
            let known = loads.iter_mut().find_map(|load| match load {
                Load::One { object: o, wishes } if *o == object => Some(wishes),
                _ => None,
            });
            match known {
                Some(all) => all.push(wish),
                None => loads.push(Load::One { object, wishes: vec![wish] }),
            }
        }
        for &index in &indices {
            let Atom { first, second, .. } = atoms[index];
            let both = [first, second];
            if first != second && !both.iter().any(|b| *b == Body::Agent || loaded.contains(b)) {
                loaded.extend(both);
                loads.push(Load::Two(index));
            }
        }
        if loads.len() > 1 {
            self.are_together = true;
            *node = Node::Together(std::mem::take(parts), loads);
        }
    }
}

/// Where a body is.
#[inline]
pub(super) fn place(body: Body, dynamics: &Dynamics, packed: Packed) -> Place {
    match body {
        Body::Agent => dynamics.agent(packed),
        Body::Object(index) => dynamics.object(packed, index),
    }
}
