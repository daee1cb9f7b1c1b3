//! The arena of hash-consed terms: de Bruijn indices, β-normal, η-long, conjuncts in canonical order
//! (invariant 1: equal ids exactly when terms are α-equivalent up to the order of conjuncts).
//! Equality, hash, type, size and free variables of a term cost O(1).

use super::order;
use super::ty::{ENTITY, RUN, TRUTH, TyId, Type, Types};
use hashbrown::HashTable;
use rustc_hash::{FxHashMap, FxHasher};
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

/// A term of one arena.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TermId(u32);

impl TermId {
    /// Its place in the arena.
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

/// A constant of one arena: a name with a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ConstantId(u32);

/// A term, one level deep. Heads are constants or variables; every argument is itself in normal form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Node<'a> {
    /// A constant: of base type as a term, of any type as a head.
    Constant(ConstantId),
    /// A variable by de Bruijn index: of base type as a term, of any type as a head.
    Variable(u32),
    /// A head applied to all its arguments.
    Apply {
        /// A constant or a variable.
        head: TermId,
        /// Its arguments; those of a variadic constant in canonical order.
        args: &'a [TermId],
    },
    /// An abstraction.
    Lambda {
        /// The type of its variable.
        parameter: TyId,
        /// What stands below the binder.
        body: TermId,
    },
}

/// Why two terms cannot be put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LogicError {
    /// The function's parameter and the argument differ in type.
    #[error("the argument has another type than the function takes")]
    TypeMismatch,
    /// What is applied is no function.
    #[error("what is applied to an argument is not a function")]
    NotAFunction,
    /// `<a*,b>` where only a plain type may stand.
    #[error("a variadic constant needs its arguments, and only a constant can be variadic")]
    BareVariadic,
    /// A variadic constant with fewer than two arguments.
    #[error("a variadic constant takes two or more arguments")]
    TooFewArguments,
    /// The normal form, or the way to it, is too large.
    #[error("the term's normal form is too large")]
    TooLarge,
}

/// Nodes that a normal form may have, counted as a tree.
pub const MAX_SIZE: u32 = 4096;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    Constant(ConstantId),
    Variable(u32),
    Apply { head: TermId, start: u32, len: u32 },
    Lambda { parameter: TyId, body: TermId },
}

#[derive(Clone, Copy, Debug)]
struct Stored {
    shape: Shape,
    ty: TyId,
    /// One more than the largest de Bruijn index that points out of the term.
    free: u32,
    size: u32,
    predicates: u32,
}

/// The constants that normal forms know: connectives of truth values, and those of runs (`TIME` below), by which equal
/// tasks are one term.
#[derive(Clone, Copy, Debug)]
pub(super) struct Connectives {
    pub(super) and: ConstantId,
    pub(super) or: ConstantId,
    pub(super) not: ConstantId,
    pub(super) truth: TermId,
    pub(super) falsity: TermId,
    pub(super) all: ConstantId,
    pub(super) any: ConstantId,
    pub(super) until: ConstantId,
    pub(super) always: ConstantId,
    pub(super) done: TermId,
    pub(super) failed: TermId,
}

/// The names of the constants that speak of runs, each with its type. They frame a sentence: no word means one.
pub const TIME: [(&str, &str); 6] = [
    ("until", "<t,<t,<p,p>>>"),
    ("always", "<t,p>"),
    ("done", "p"),
    ("failed", "p"),
    ("all", "<p*,p>"),
    ("any", "<p*,p>"),
];

/// One arena of terms and types, with memoised application and composition.
#[derive(Clone, Debug)]
pub struct Terms {
    /// The types of the arena.
    pub types: Types,
    constants: Vec<(Box<str>, TyId)>,
    constant_index: FxHashMap<(Box<str>, TyId), ConstantId>,
    stored: Vec<Stored>,
    args: Vec<TermId>,
    index: HashTable<TermId>,
    pub(super) connectives: Connectives,
    pub(super) applied: FxHashMap<(TermId, TermId), Result<TermId, LogicError>>,
    pub(super) composed: FxHashMap<(TermId, TermId), Result<TermId, LogicError>>,
}

impl Default for Terms {
    fn default() -> Self {
        Self::new()
    }
}

impl Terms {
    /// An arena that knows the connectives, and the constants that speak of runs ([`TIME`]).
    pub fn new() -> Self {
        let unset = ConstantId(0);
        let mut terms = Terms {
            types: Types::default(),
            constants: Vec::new(),
            constant_index: FxHashMap::default(),
            stored: Vec::new(),
            args: Vec::new(),
            index: HashTable::new(),
            connectives: Connectives {
                and: unset,
                or: unset,
                not: unset,
                truth: TermId(0),
                falsity: TermId(0),
                all: unset,
                any: unset,
                until: unset,
                always: unset,
                done: TermId(0),
                failed: TermId(0),
            },
            applied: FxHashMap::default(),
            composed: FxHashMap::default(),
        };
        let variadic = terms.types.intern(Type::Variadic(TRUTH, TRUTH));
        let negation = terms.types.function(TRUTH, TRUTH);
        let and = terms.constant("and", variadic);
        let or = terms.constant("or", variadic);
        let not = terms.constant("not", negation);
        let truth = terms.constant("true", TRUTH);
        let falsity = terms.constant("false", TRUTH);
        let of_runs = terms.types.intern(Type::Variadic(RUN, RUN));
        let onwards = terms.types.function(RUN, RUN);
        let reaching = terms.types.function(TRUTH, onwards);
        let until = terms.types.function(TRUTH, reaching);
        let until = terms.constant("until", until);
        let always = terms.types.function(TRUTH, RUN);
        let always = terms.constant("always", always);
        let (done, failed) = (terms.constant("done", RUN), terms.constant("failed", RUN));
        let (all, any) = (terms.constant("all", of_runs), terms.constant("any", of_runs));
        terms.connectives = Connectives {
            and,
            or,
            not,
            truth: terms.raw_constant(truth),
            falsity: terms.raw_constant(falsity),
            all,
            any,
            until,
            always,
            done: terms.raw_constant(done),
            failed: terms.raw_constant(failed),
        };
        terms
    }

    /// The term, one level deep.
    pub fn node(&self, term: TermId) -> Node<'_> {
        match self.at(term).shape {
            Shape::Constant(constant) => Node::Constant(constant),
            Shape::Variable(index) => Node::Variable(index),
            Shape::Apply { head, start, len } => {
                Node::Apply { head, args: &self.args[start as usize..(start + len) as usize] }
            }
            Shape::Lambda { parameter, body } => Node::Lambda { parameter, body },
        }
    }

    /// The term's type.
    pub fn ty(&self, term: TermId) -> TyId {
        self.at(term).ty
    }

    /// The number of nodes of the term as a tree.
    pub fn size(&self, term: TermId) -> u32 {
        self.at(term).size
    }

    /// How often constants that say something of an entity occur in it, such as `red` or `in`.
    pub fn predicates(&self, term: TermId) -> u32 {
        self.at(term).predicates
    }

    /// One more than the largest de Bruijn index that points out of the term: 0 when it is closed.
    pub fn free(&self, term: TermId) -> u32 {
        self.at(term).free
    }

    /// Whether the variable of a de Bruijn index occurs in it.
    pub fn uses(&self, term: TermId, index: u32) -> bool {
        if self.free(term) <= index {
            return false;
        }
        match self.node(term) {
            Node::Constant(_) => false,
            Node::Variable(found) => found == index,
            Node::Lambda { body, .. } => self.uses(body, index + 1),
            Node::Apply { head, args } => {
                self.uses(head, index) || args.iter().any(|&arg| self.uses(arg, index))
            }
        }
    }

    /// The name of a constant, without its type.
    pub fn name(&self, constant: ConstantId) -> &str {
        &self.constants[constant.0 as usize].0
    }

    /// The type of a constant.
    pub fn constant_ty(&self, constant: ConstantId) -> TyId {
        self.constants[constant.0 as usize].1
    }

    /// The constant of that name and type.
    pub fn constant(&mut self, name: &str, ty: TyId) -> ConstantId {
        let key = (Box::from(name), ty);
        if let Some(&known) = self.constant_index.get(&key) {
            return known;
        }
        let id = ConstantId(self.constants.len() as u32);
        self.constants.push(key.clone());
        self.constant_index.insert(key, id);
        id
    }

    /// `true`.
    pub fn truth(&self) -> TermId {
        self.connectives.truth
    }

    /// The constant that heads a term `c` or `c(…)`; `None` for a variable or an abstraction.
    pub fn head_constant(&self, term: TermId) -> Option<ConstantId> {
        match self.node(term) {
            Node::Constant(constant) => Some(constant),
            Node::Apply { head, .. } => self.head_constant(head),
            Node::Variable(_) | Node::Lambda { .. } => None,
        }
    }

    /// Whether a property is that something is not so.
    pub fn denies(&self, property: TermId) -> bool {
        match self.node(property) {
            Node::Lambda { body, .. } => self.head_name(body) == Some("not"),
            _ => false,
        }
    }

    /// The name of the constant that an application or a constant is headed by.
    pub fn head_name(&self, term: TermId) -> Option<&str> {
        self.head_constant(term).map(|constant| self.name(constant))
    }

    /// The arguments of an application that is headed by the constant of this name.
    pub fn arguments(&self, term: TermId, name: &str) -> Option<&[TermId]> {
        match self.node(term) {
            Node::Apply { args, .. } if self.head_name(term) == Some(name) => Some(args),
            _ => None,
        }
    }

    /// What a term says is not so.
    pub fn denied(&self, term: TermId) -> Option<TermId> {
        match self.arguments(term, "not") {
            Some(&[denied]) => Some(denied),
            _ => None,
        }
    }

    /// The constants of a term, in the order of their first occurrence.
    pub fn constants(&self, term: TermId) -> Vec<ConstantId> {
        let mut found = Vec::new();
        self.collect_constants(term, &mut found);
        found
    }

    fn collect_constants(&self, term: TermId, found: &mut Vec<ConstantId>) {
        match self.node(term) {
            Node::Constant(constant) if found.contains(&constant) => {}
            Node::Constant(constant) => found.push(constant),
            Node::Variable(_) => {}
            Node::Lambda { body, .. } => self.collect_constants(body, found),
            Node::Apply { head, args } => {
                self.collect_constants(head, found);
                args.iter().for_each(|&arg| self.collect_constants(arg, found));
            }
        }
    }

    /// The order of conjuncts: by structure, never by id. Constant < variable < application < lambda.
    pub fn compare(&self, a: TermId, b: TermId) -> Ordering {
        if a == b {
            return Ordering::Equal;
        }
        match (self.node(a), self.node(b)) {
            (Node::Constant(c), Node::Constant(d)) => self
                .name(c)
                .as_bytes()
                .cmp(self.name(d).as_bytes())
                .then_with(|| self.compare_types(self.constant_ty(c), self.constant_ty(d))),
            (Node::Variable(i), Node::Variable(j)) => {
                i.cmp(&j).then_with(|| self.compare_types(self.ty(a), self.ty(b)))
            }
            (Node::Apply { head: f, args: xs }, Node::Apply { head: g, args: ys }) => self
                .compare(f, g)
                .then_with(|| self.compare_each(xs, ys))
                .then_with(|| xs.len().cmp(&ys.len())),
            (Node::Lambda { parameter: s, body: x }, Node::Lambda { parameter: t, body: y }) => {
                self.compare_types(s, t).then_with(|| self.compare(x, y))
            }
            (x, y) => rank(x).cmp(&rank(y)),
        }
    }

    /// Puts constants in the order of their names.
    pub fn sort_by_name(&self, constants: &mut [ConstantId]) {
        order::sort_by(constants, |&a, &b| self.name(a).cmp(self.name(b)));
    }

    /// Puts terms in the order of conjuncts.
    pub fn sort(&self, terms: &mut [TermId]) {
        order::sort_by(terms, |&a, &b| self.compare(a, b));
    }

    fn compare_each(&self, xs: &[TermId], ys: &[TermId]) -> Ordering {
        xs.iter()
            .zip(ys)
            .map(|(&x, &y)| self.compare(x, y))
            .find(|order| order.is_ne())
            .unwrap_or(Ordering::Equal)
    }

    fn compare_types(&self, s: TyId, t: TyId) -> Ordering {
        if s == t { Ordering::Equal } else { self.types.print(s).cmp(&self.types.print(t)) }
    }

    fn at(&self, term: TermId) -> &Stored {
        &self.stored[term.0 as usize]
    }

    /// A constant as a head, or as a term when its type is a base type.
    pub(super) fn raw_constant(&mut self, constant: ConstantId) -> TermId {
        let ty = self.constant_ty(constant);
        let shape = Shape::Constant(constant);
        let of_entities = matches!(self.types.get(ty), Type::Function(ENTITY, _));
        let predicates = u32::from(of_entities);
        self.intern(Stored { shape, ty, free: 0, size: 1, predicates }, &[])
    }

    /// A variable as a head, or as a term when its type is a base type.
    pub(super) fn raw_variable(&mut self, index: u32, ty: TyId) -> TermId {
        let shape = Shape::Variable(index);
        self.intern(Stored { shape, ty, free: index + 1, size: 1, predicates: 0 }, &[])
    }

    /// An application whose parts are known to fit, in normal form and in canonical order.
    pub(super) fn raw_apply(
        &mut self,
        head: TermId,
        args: &[TermId],
        ty: TyId,
    ) -> Result<TermId, LogicError> {
        let parts = args.iter().map(|&arg| self.at(arg));
        let size =
            parts.clone().fold(1 + self.size(head), |sum, part| sum.saturating_add(part.size));
        let predicates = parts
            .clone()
            .fold(self.predicates(head), |sum, part| sum.saturating_add(part.predicates));
        let free = parts.fold(self.free(head), |most, part| most.max(part.free));
        if size > MAX_SIZE {
            return Err(LogicError::TooLarge);
        }
        let shape = Shape::Apply { head, start: self.args.len() as u32, len: args.len() as u32 };
        Ok(self.intern(Stored { shape, ty, free, size, predicates }, args))
    }

    /// An abstraction over variable 0 of `body`.
    pub fn lambda(&mut self, parameter: TyId, body: TermId) -> Result<TermId, LogicError> {
        if self.types.has_variadic(parameter) {
            return Err(LogicError::BareVariadic);
        }
        let below = *self.at(body);
        if below.size >= MAX_SIZE {
            return Err(LogicError::TooLarge);
        }
        let ty = self.types.function(parameter, below.ty);
        let shape = Shape::Lambda { parameter, body };
        let (free, size) = (below.free.saturating_sub(1), below.size + 1);
        let predicates = below.predicates;
        Ok(self.intern(Stored { shape, ty, free, size, predicates }, &[]))
    }

    /// The one id of a term; `args` are those of an application and are stored only when it is new.
    fn intern(&mut self, new: Stored, args: &[TermId]) -> TermId {
        let hash = hash(new.shape, new.ty, args);
        let Terms { stored, args: all, index, .. } = self;
        let same = |id: &TermId| {
            let old = &stored[id.0 as usize];
            match (old.shape, new.shape) {
                (Shape::Apply { head: f, start, len }, Shape::Apply { head: g, .. }) => {
                    f == g && &all[start as usize..(start + len) as usize] == args
                }
                (old_shape, new_shape) => old_shape == new_shape && old.ty == new.ty,
            }
        };
        if let Some(&known) = index.find(hash, same) {
            return known;
        }
        let id = TermId(stored.len() as u32);
        stored.push(new);
        all.extend_from_slice(args);
        index.insert_unique(hash, id, |&id| {
            let Stored { shape, ty, .. } = stored[id.0 as usize];
            let args = match shape {
                Shape::Apply { start, len, .. } => &all[start as usize..(start + len) as usize],
                _ => &[],
            };
            self::hash(shape, ty, args)
        });
        id
    }
}

fn rank(node: Node<'_>) -> u8 {
    match node {
        Node::Constant(_) => 0,
        Node::Variable(_) => 1,
        Node::Apply { .. } => 2,
        Node::Lambda { .. } => 3,
    }
}

fn hash(shape: Shape, ty: TyId, args: &[TermId]) -> u64 {
    let mut hasher = FxHasher::default();
    match shape {
        Shape::Constant(constant) => (0u8, constant).hash(&mut hasher),
        Shape::Variable(index) => (1u8, index, ty).hash(&mut hasher),
        Shape::Apply { head, .. } => (2u8, head, args).hash(&mut hasher),
        Shape::Lambda { parameter, body } => (3u8, parameter, body).hash(&mut hasher),
    }
    hasher.finish()
}
