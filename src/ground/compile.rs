//! A goal compiled to a test on packed states, with bounds on the way that is left (`bound`). Negations stand at the
//! atoms only, where they turn the places that fulfil it.
//! An object that never moves is a cell: what is said of it and a thing is said of that thing alone.

use super::bound::BoundOf;
use super::distance::Ground;
use super::goal::{Formula, Goal};
use super::pairs::{Pairs, Wanted};
use super::predicate::Relation;
use super::thing::{Entity, Thing};
use super::wish::{Atom, Body, Load, Node, Wish, Wishes, place};
use crate::domain::{Dynamics, Packed, State};

/// A goal over packed states of one [`Dynamics`].
#[derive(Clone, Debug)]
pub(super) struct Compiled {
    root: Node,
    atoms: Vec<Atom>,
    wishes: Vec<Wish>,
    bound: BoundOf,
    /// Whether it wants nothing but some places of some objects each, so that [`Pairs`] know all of it.
    is_paired: bool,
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
            atoms.push(Atom { first, second, wish: wishes.index_of(wish) });
        }
        wishes.load(&mut root, &atoms);
        let bound = BoundOf::new(&wishes, (&root, &atoms), dynamics, initial);
        let is_paired = is_paired(&root);
        Self { root, atoms, wishes: wishes.all, bound, is_paired }
    }

    /// Whether no state whatever fulfils it: it asks for something of a thing that is not there.
    pub(super) fn is_impossible(&self) -> bool {
        self.root == Node::Any(Vec::new())
    }

    /// Whether it holds.
    pub(super) fn holds(&self, dynamics: &Dynamics, packed: Packed) -> bool {
        self.node_holds(&self.root, dynamics, packed)
    }

    /// Whether it depends on where the robot is.
    pub(super) fn speaks_of_robot(&self) -> bool {
        self.atoms.iter().any(|atom| atom.first == Body::Agent)
    }

    /// Whether it is about nothing but where the robot is.
    pub(super) fn is_of_robot(&self) -> bool {
        let is_alone = |atom: &Atom| atom.first == Body::Agent && atom.second == Body::Agent;
        !self.atoms.is_empty() && self.atoms.iter().all(is_alone)
    }

    /// What makes the bound sharper, not made yet: see [`Pairs`]. The doors stay as they are in `initial`.
    pub(super) fn pairs(&self, dynamics: &Dynamics, initial: Packed) -> Option<Pairs> {
        let layout = dynamics.layout();
        let wanted = self.loads().iter().enumerate().filter_map(|(index, load)| match load {
            Load::One { object, wishes } => {
                let is_wanted = |place| {
                    let cell = layout.cell(place);
                    wishes.iter().all(|&wish| self.wishes[wish].holds(cell, cell))
                };
                let places = layout.places().map(is_wanted).collect();
                let least = self.part(index, dynamics, initial).unwrap_or_default();
                Some(Wanted { object: *object, places, least })
            }
            Load::Two(_) => None,
        });
        let wanted: Vec<Wanted> = wanted.collect();
        Pairs::new(dynamics, &Ground::new(dynamics, initial, false), &wanted)
    }

    /// A guess at the actions still needed: see [`BoundOf::guess`].
    pub(super) fn estimate(&self, dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        self.bound.guess(&self.root, &self.atoms, dynamics, packed)
    }

    /// A lower bound on the actions still needed, with what pairs of objects need; `None` when no number suffices.
    pub(super) fn bound_with(
        &self,
        pairs: &Pairs,
        dynamics: &Dynamics,
        packed: Packed,
    ) -> Option<u32> {
        let paired = pairs.bound(dynamics, packed)?;
        let whole = if self.is_paired && pairs.is_whole() {
            self.bound.sum(self.loads(), &self.atoms, dynamics, packed)?
        } else {
            self.bound(dynamics, packed)?
        };
        Some(whole.max(paired))
    }

    /// How many objects or pairs of objects it wants moved, all of them.
    pub(super) fn n_parts(&self) -> usize {
        self.loads().len().min(64)
    }

    fn loads(&self) -> &[Load] {
        if let Node::Together(_, loads) = &self.root { loads } else { &[] }
    }

    /// A lower bound on the actions until one of them is where it should be.
    pub(super) fn part(&self, index: usize, dynamics: &Dynamics, packed: Packed) -> Option<u32> {
        self.bound.part(&self.loads()[index], &self.atoms, dynamics, packed)
    }

    /// Those that are not where they should be, each with the guess if it comes first; the least first.
    pub(super) fn parts(&self, dynamics: &Dynamics, packed: Packed) -> Vec<(u32, usize)> {
        self.bound.parts(self.loads(), &self.atoms, dynamics, packed)
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

/// See [`Compiled::is_paired`].
fn is_paired(root: &Node) -> bool {
    let Node::Together(all, loads) = root else { return false };
    let wishes = loads.iter().map(|load| match load {
        Load::One { wishes, .. } => wishes.len(),
        Load::Two(_) => 0,
    });
    all.len() == wishes.sum::<usize>() && all.iter().all(|node| matches!(node, Node::Atom(_)))
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
