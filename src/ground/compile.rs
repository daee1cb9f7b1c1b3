//! A goal compiled to a test on packed states, with bounds on the way that is left (`bound`). Negations stand at the
//! atoms only, where they turn the places that fulfil it.
//! An object that never moves is a cell: what is said of it and a thing is said of that thing alone.

use super::bound::BoundOf;
use super::distance::{Ground, Moves, Table};
use super::goal::{Formula, Goal};
use super::predicate::Relation;
use super::thing::{Entity, Thing};
use crate::domain::layout::Place;
use crate::domain::{Bounds, Dynamics, Packed, State};

/// A goal over packed states of one [`Dynamics`].
#[derive(Clone, Debug)]
pub(super) struct Compiled {
    root: Node,
    atoms: Vec<Atom>,
    wishes: Vec<Wish>,
    bound: BoundOf,
}

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
    fn holds(self, first: (i32, i32), second: (i32, i32)) -> bool {
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
                ground.carry(|_, object| holds(object, object))
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

impl Compiled {
    /// Compiles a goal for the world of `dynamics` as it is in `state`, packed in `initial`.
    pub(super) fn new(goal: &Goal, dynamics: &Dynamics, state: &State, initial: Packed) -> Self {
        let things = Thing::all(state);
        let mut compiler = Compiler { things, dynamics, atoms: Vec::new() };
        let mut root = compiler.node(goal.formula(), true);
        let mut wishes = Wishes::default();
        let mut atoms = Vec::new();
        for (first, second, wish) in compiler.atoms {
            atoms.push(Atom { first, second, wish: index_of(&mut wishes.all, wish) });
        }
        wishes.load(&mut root, &atoms);
        let bound = BoundOf::new(&wishes, (&root, &atoms), dynamics, initial);
        Self { root, atoms, wishes: wishes.all, bound }
    }

    /// Whether no state whatever fulfils it: it asks for something of a thing that is not there.
    pub(super) fn is_impossible(&self) -> bool {
        self.root == Node::Any(Vec::new())
    }

    /// Whether it holds.
    pub(super) fn holds(&self, dynamics: &Dynamics, packed: Packed) -> bool {
        self.node_holds(&self.root, dynamics, packed)
    }

    /// A lower bound on the actions still needed; `None` when no number suffices.
    pub(super) fn bound(&self, dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        self.bound.least(&self.root, &self.atoms, dynamics, packed)
    }

    /// An upper bound on what a state is worth that is not terminal.
    pub(super) fn most(&self, dynamics: &Dynamics, packed: Packed, discount: f64) -> f64 {
        self.bound.most(&self.root, &self.atoms, dynamics, packed, discount)
    }

    fn node_holds(&self, node: &Node, dynamics: &Dynamics, packed: Packed) -> bool {
        match node {
            Node::All(all) | Node::Together(all, _) => {
                all.iter().all(|n| self.node_holds(n, dynamics, packed))
            }
            Node::Any(any) => any.iter().any(|n| self.node_holds(n, dynamics, packed)),
            Node::Atom(index) => {
                let atom = &self.atoms[*index];
                let cell = |body| dynamics.layout().cell(place(body, dynamics, packed));
                self.wishes[atom.wish].holds(cell(atom.first), cell(atom.second))
            }
        }
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
    /// Finds the conjunctions in which the moves of several objects add up.
    fn load(&mut self, node: &mut Node, atoms: &[Atom]) {
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

/// The index of a wish among others, to which it is added if it is not there.
fn index_of(wishes: &mut Vec<Wish>, wish: Wish) -> usize {
    wishes.iter().position(|known| *known == wish).unwrap_or_else(|| {
        wishes.push(wish);
        wishes.len() - 1
    })
}

#[inline]
pub(super) fn place(body: Body, dynamics: &Dynamics, packed: Packed) -> Place {
    match body {
        Body::Agent => dynamics.agent(packed),
        Body::Object(index) => dynamics.object(packed, index),
    }
}

struct Compiler<'s> {
    things: Vec<Thing<'s>>,
    dynamics: &'s Dynamics,
    atoms: Vec<(Body, Body, Wish)>,
}

impl Compiler<'_> {
    /// The formula, or its negation when it is not wanted.
    fn node(&mut self, formula: &Formula, wanted: bool) -> Node {
        match formula {
            Formula::And(parts) => self.join(parts.iter(), wanted, wanted),
            Formula::Or(parts) => self.join(parts.iter(), wanted, !wanted),
            Formula::Not(part) => self.node(part, !wanted),
            // Nothing comes into a world: the witnesses are those of the initial state.
            Formula::Exists { known, .. } => self.join(known.iter().map(|k| &k.1), wanted, !wanted),
            Formula::Property(property, of) => {
                let holds = self.find(of).is_some_and(|t| property.holds(self.things[t]));
                constant(holds == wanted)
            }
            Formula::Relation(relation, a, b) => self.relation(*relation, a, b, wanted),
        }
    }

    /// All parts, or any, each as wanted; constants are folded away.
    fn join<'f>(
        &mut self,
        parts: impl Iterator<Item = &'f Formula>,
        wanted: bool,
        all: bool,
    ) -> Node {
        let (unit, absorber) = (constant(all), constant(!all));
        let mut joined = Vec::new();
        for part in parts {
            let node = self.node(part, wanted);
            if node == absorber {
                return absorber;
            }
            if node != unit {
                joined.push(node);
            }
        }
        match (joined.len(), all) {
            (1, _) => joined.swap_remove(0),
            (_, true) => Node::All(joined),
            (_, false) => Node::Any(joined),
        }
    }

    fn relation(&mut self, relation: Relation, a: &Entity, b: &Entity, wanted: bool) -> Node {
        let (Some(a), Some(b)) = (self.find(a), self.find(b)) else { return constant(!wanted) };
        match (relation, self.body(a), self.body(b), self.things[b].bounds()) {
            (Relation::Eq, ..) => constant((a == b) == wanted),
            (Relation::In, Some(body), _, Some(region)) => {
                let wish = Wish::Inside { region, robot: body == Body::Agent, wanted };
                self.atom((a, body), (a, body), wish)
            }
            (Relation::Near | Relation::Left | Relation::Right, Some(first), Some(second), _)
                if first != second =>
            {
                // The robot comes first, and what never moves last.
                let turned = match relation {
                    Relation::Left => Relation::Right,
                    Relation::Right => Relation::Left,
                    other => other,
                };
                let (a, b, relation) =
                    if second == Body::Agent || (self.is_fixed(first) && first != Body::Agent) {
                        ((b, second), (a, first), turned)
                    } else {
                        ((a, first), (b, second), relation)
                    };
                let robot = a.1 == Body::Agent;
                match self.things[b.0].cell().filter(|_| self.is_fixed(b.1)) {
                    Some(cell) => self.atom(a, a, Wish::Next { relation, cell, robot, wanted }),
                    None => self.atom(a, b, Wish::Beside { relation, robot, wanted }),
                }
            }
            _ => constant(!wanted),
        }
    }

    /// Whether it stays where it is for ever.
    fn is_fixed(&self, body: Body) -> bool {
        matches!(body, Body::Object(object) if !self.dynamics.can_move(object))
    }

    /// A wish about two bodies, each with its index among the things; known at once when neither moves.
    fn atom(&mut self, first: (usize, Body), second: (usize, Body), wish: Wish) -> Node {
        if self.is_fixed(first.1)
            && self.is_fixed(second.1)
            && let (Some(a), Some(b)) = (self.things[first.0].cell(), self.things[second.0].cell())
        {
            return constant(wish.holds(a, b));
        }
        self.atoms.push((first.1, second.1, wish));
        Node::Atom(self.atoms.len() - 1)
    }

    /// The thing that goes by an entity.
    fn find(&self, entity: &Entity) -> Option<usize> {
        self.things.iter().position(|t| t.is(entity))
    }

    /// Agent or object; objects stand last among the things, in the state's order.
    fn body(&self, thing: usize) -> Option<Body> {
        match self.things[thing] {
            Thing::Agent { .. } => Some(Body::Agent),
            Thing::Object(_) => {
                let is_object = |t: &&Thing<'_>| matches!(t, Thing::Object(_));
                Some(Body::Object(self.things.iter().take(thing).filter(is_object).count()))
            }
            Thing::Room(_) | Thing::Door(_) => None,
        }
    }
}

/// What is always so, or never.
fn constant(value: bool) -> Node {
    if value { Node::All(Vec::new()) } else { Node::Any(Vec::new()) }
}
