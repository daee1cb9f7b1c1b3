//! A goal compiled to a test on packed states, with a lower bound on the actions that are still needed:
//! an atom's is exact in an empty world (`distance`), a conjunction's the largest of its parts and of the moves of
//! all its objects together, a disjunction's the smallest. Negations stand at the atoms only, where they turn the places that fulfil it.
//! An object that never moves is a cell: what is said of it and a thing is said of that thing alone.

use super::distance::{Ground, Moves, Steps, Table};
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
    tables: Vec<(Wish, Table)>,
    /// Moves of an object that a wish needs.
    moves: Vec<(Wish, Moves)>,
    steps: Steps,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Node {
    All(Vec<Node>),
    /// All of these atoms, which want something of two objects or more; the moves of different objects add up.
    Together(Vec<Node>, Vec<Load>),
    Any(Vec<Node>),
    /// By index.
    Atom(usize),
}

/// What a conjunction wants of one object, or of two that it wants nothing else of.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Load {
    /// By their indices: moves of a wish each, the largest of which counts.
    One { object: usize, moves: Vec<usize> },
    /// An atom about two objects.
    Two(usize),
}

/// What stands in one cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Body {
    Agent,
    Object(usize),
}

#[derive(Clone, Copy, Debug)]
struct Atom {
    first: Body,
    /// The second thing of a relation between two; of what is said of one thing, the first once more.
    second: Body,
    /// Its wish and table.
    table: usize,
}

/// What an atom wants of the places of its things, whichever these are; the key of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wish {
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
        let ground = Ground::new(dynamics, initial);
        let mut compiled = Self {
            root: constant(true),
            atoms: Vec::new(),
            tables: Vec::new(),
            moves: Vec::new(),
            steps: Steps::default(),
        };
        for (first, second, wish) in compiler.atoms {
            let known = compiled.tables.iter().position(|t| t.0 == wish);
            let table = known.unwrap_or_else(|| {
                compiled.tables.push((wish, table(wish, dynamics, &ground)));
                compiled.tables.len() - 1
            });
            compiled.atoms.push(Atom { first, second, table });
        }
        compiled.load(&mut root, dynamics, &ground);
        compiled.root = root;
        let is_carried = |t: &(Wish, Table)| matches!(t.1, Table::Fetch { .. });
        if !compiled.moves.is_empty() || compiled.tables.iter().any(is_carried) {
            compiled.steps = ground.steps();
        }
        compiled
    }

    /// Finds the conjunctions in which the moves of several objects add up.
    fn load(&mut self, node: &mut Node, dynamics: &Dynamics, ground: &Ground<'_>) {
        let (Node::All(parts) | Node::Any(parts)) = node else { return };
        parts.iter_mut().for_each(|part| self.load(part, dynamics, ground));
        let Node::All(parts) = node else { return };
        let atoms: Vec<usize> = parts
            .iter()
            .filter_map(|n| if let Node::Atom(index) = n { Some(*index) } else { None })
            .collect();
        let mut loads: Vec<Load> = Vec::new();
        let mut loaded: Vec<Body> = Vec::new();
        for &index in &atoms {
            let Atom { first, second, table } = self.atoms[index];
            let Body::Object(object) = first else { continue };
            if first != second {
                continue;
            }
            let moves = self.moves_of(self.tables[table].0, dynamics, ground);
            loaded.push(first);
            let known = loads.iter_mut().find_map(|load| match load {
                Load::One { object: o, moves } if *o == object => Some(moves),
                _ => None,
            });
            match known {
                Some(all) => all.push(moves),
                None => loads.push(Load::One { object, moves: vec![moves] }),
            }
        }
        for &index in &atoms {
            let Atom { first, second, .. } = self.atoms[index];
            let both = [first, second];
            if first != second && !both.iter().any(|b| *b == Body::Agent || loaded.contains(b)) {
                loaded.extend(both);
                loads.push(Load::Two(index));
            }
        }
        if loads.len() > 1 {
            *node = Node::Together(std::mem::take(parts), loads);
        }
    }

    /// The index of the moves that a wish about one object needs.
    fn moves_of(&mut self, wish: Wish, dynamics: &Dynamics, ground: &Ground<'_>) -> usize {
        self.moves.iter().position(|m| m.0 == wish).unwrap_or_else(|| {
            let holds = |p: Place| {
                let cell = dynamics.layout().cell(p);
                wish.holds(cell, cell)
            };
            self.moves.push((wish, ground.moves(holds)));
            self.moves.len() - 1
        })
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
        self.node_bound(&self.root, dynamics, packed)
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
                self.tables[atom.table].0.holds(cell(atom.first), cell(atom.second))
            }
        }
    }

    fn node_bound(&self, node: &Node, dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        match node {
            Node::All(all) => self.largest(all, dynamics, packed),
            Node::Together(all, loads) => {
                let largest = self.largest(all, dynamics, packed)?;
                Some(self.together(loads, dynamics, packed)?.max(largest))
            }
            Node::Any(any) => any.iter().filter_map(|n| self.node_bound(n, dynamics, packed)).min(),
            Node::Atom(index) => {
                let atom = &self.atoms[*index];
                let at = |body| place(body, dynamics, packed);
                let robot = (dynamics.agent(packed), dynamics.heading(packed));
                let things = (at(atom.first), at(atom.second));
                self.tables[atom.table].1.bound(&self.steps, robot, things)
            }
        }
    }

    fn largest(&self, all: &[Node], dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        all.iter().try_fold(0, |most, n| self.node_bound(n, dynamics, packed).map(|b| b.max(most)))
    }

    /// The moves of all loads, of which an action makes at most one, and the way to the first of them. To begin with
    /// a load that is where it should be costs a move away from there and one back: so one action never takes more
    /// than one from the sum.
    fn together(&self, loads: &[Load], dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        let robot = dynamics.agent(packed);
        let (mut sum, mut walk) = (0, u32::MAX);
        for load in loads {
            let (rest, way) = match load {
                Load::One { object, moves } => {
                    let at = dynamics.object(packed, *object);
                    let rest = moves.iter().try_fold(0, |most, &m| {
                        self.moves[m].1.from(at).map(|rest| rest.max(most))
                    })?;
                    (rest, self.steps.between(robot, at))
                }
                Load::Two(index) => {
                    let atom = &self.atoms[*index];
                    let (a, b) =
                        (place(atom.first, dynamics, packed), place(atom.second, dynamics, packed));
                    let ways = [self.steps.between(robot, a), self.steps.between(robot, b)];
                    let rest = self.tables[atom.table].1.moves(a, b)?;
                    (rest, ways.into_iter().flatten().min())
                }
            };
            sum += rest;
            match way {
                Some(way) => walk = walk.min(if rest > 0 { way } else { way + 2 }),
                None if rest > 0 => return None,
                None => {}
            }
        }
        Some(if sum == 0 { 0 } else { sum + walk.saturating_sub(1) })
    }
}

#[inline]
fn place(body: Body, dynamics: &Dynamics, packed: Packed) -> Place {
    match body {
        Body::Agent => dynamics.agent(packed),
        Body::Object(index) => dynamics.object(packed, index),
    }
}

fn table(wish: Wish, dynamics: &Dynamics, ground: &Ground<'_>) -> Table {
    let cell = |p: Place| dynamics.layout().cell(p);
    let holds = |a: Place, b: Place| wish.holds(cell(a), cell(b));
    match wish {
        Wish::Inside { robot: true, .. } | Wish::Next { robot: true, .. } => {
            ground.robot(|p| holds(p, p))
        }
        Wish::Inside { .. } | Wish::Next { .. } => ground.carry(|_, object| holds(object, object)),
        Wish::Beside { robot: true, .. } => ground.carry(holds),
        Wish::Beside { robot: false, .. } => ground.two_objects(holds),
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
