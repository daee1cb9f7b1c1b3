//! Marks: constants that carry where they came from through every reduction. A marked constant is one of its own, with
//! its `origin` in its name; marked terms live in an arena apart.
//! Invariant: a marked term without its marks, conjuncts said twice but once, is the plain term.

use super::expression::Expression;
use super::origin::{named, origin, split, unmarked};
use super::term::{LogicError, Node, TermId, Terms};
use super::ty::{TyId, Type};
use rustc_hash::FxHashMap;

/// A term of one arena in another, its constants marked as come from `origin`.
///
/// # Errors
/// When the term is too large.
pub fn marked(
    from: &Terms,
    term: TermId,
    to: &mut Terms,
    origin: Option<u32>,
) -> Result<TermId, LogicError> {
    let rename = |name: &str| named(name, origin);
    Copying { from, to, rename: &rename, known: FxHashMap::default() }.copy(term)
}

/// A marked term, and what each of its parts is without its marks.
pub struct Marks<'a> {
    marked: &'a Terms,
    plain: &'a Terms,
    known: FxHashMap<TermId, TermId>,
}

impl<'a> Marks<'a> {
    /// Takes the marks off a term: its plain parts are put into `plain`.
    ///
    /// # Errors
    /// When the term is too large.
    pub fn off(
        marked: &'a Terms,
        term: TermId,
        plain: &'a mut Terms,
    ) -> Result<Marks<'a>, LogicError> {
        let rename = |name: &str| unmarked(name).to_owned();
        let mut copying =
            Copying { from: marked, to: plain, rename: &rename, known: FxHashMap::default() };
        copying.copy(term)?;
        let known = copying.known;
        Ok(Marks { marked, plain, known })
    }

    /// The plain term of a marked one.
    pub fn plain(&self, term: TermId) -> Option<TermId> {
        self.known.get(&term).copied()
    }

    /// The term as a person writes it, in pieces: each constant with its origin, what stands between with none.
    pub fn pieces(&self, term: TermId) -> Vec<(String, Option<u32>)> {
        // In the order of the plain terms, and what is said twice once.
        let mut arrange = |args: &mut Vec<TermId>| {
            let mut plain: Vec<TermId> = args.iter().filter_map(|&arg| self.plain(arg)).collect();
            self.plain.sort(&mut plain);
            plain.dedup();
            let marked = |&plain: &TermId| args.iter().find(|&&arg| self.plain(arg) == Some(plain));
            *args = plain.iter().filter_map(marked).copied().collect();
        };
        split(&Expression::arranged(self.marked, term, &mut arrange).to_string())
    }

    /// The origins of all parts of a term that are this plain term, each once.
    pub fn origins(&self, term: TermId, plain: TermId) -> Vec<u32> {
        let mut found = Vec::new();
        self.collect(term, plain, false, &mut found);
        found
    }

    fn collect(&self, term: TermId, plain: TermId, inside: bool, found: &mut Vec<u32>) {
        let inside = inside || self.plain(term) == Some(plain);
        match self.marked.node(term) {
            Node::Constant(constant) if inside => {
                let origin = origin(self.marked.name(constant));
                found.extend(origin.filter(|origin| !found.contains(origin)));
            }
            Node::Constant(_) | Node::Variable(_) => {}
            Node::Lambda { body, .. } => self.collect(body, plain, inside, found),
            Node::Apply { head, args } => {
                self.collect(head, plain, inside, found);
                args.iter().for_each(|&arg| self.collect(arg, plain, inside, found));
            }
        }
    }
}

/// Terms on their way from one arena into another.
struct Copying<'a, R> {
    from: &'a Terms,
    to: &'a mut Terms,
    rename: &'a R,
    known: FxHashMap<TermId, TermId>,
}

impl<R: Fn(&str) -> String> Copying<'_, R> {
    fn copy(&mut self, term: TermId) -> Result<TermId, LogicError> {
        if let Some(&known) = self.known.get(&term) {
            return Ok(known);
        }
        let copy = match self.from.node(term) {
            Node::Constant(constant) => {
                let ty = self.ty(self.from.constant_ty(constant));
                let name = (self.rename)(self.from.name(constant));
                let constant = self.to.constant(&name, ty);
                self.to.raw_constant(constant)
            }
            Node::Variable(index) => {
                let ty = self.ty(self.from.ty(term));
                self.to.raw_variable(index, ty)
            }
            Node::Lambda { parameter, body } => {
                let parameter = self.ty(parameter);
                let body = self.copy(body)?;
                self.to.lambda(parameter, body)?
            }
            Node::Apply { head, args } => {
                let head = self.copy(head)?;
                let args: Result<Vec<TermId>, LogicError> =
                    args.iter().map(|&arg| self.copy(arg)).collect();
                self.to.apply_head(head, &args?)?
            }
        };
        self.known.insert(term, copy);
        Ok(copy)
    }

    fn ty(&mut self, ty: TyId) -> TyId {
        match self.from.types.get(ty) {
            // The base types have the same ids in every arena.
            Type::Entity | Type::Truth | Type::Number | Type::Run => ty,
            Type::Function(from, to) => {
                let (from, to) = (self.ty(from), self.ty(to));
                self.to.types.function(from, to)
            }
            Type::Variadic(each, to) => {
                let (each, to) = (self.ty(each), self.ty(to));
                self.to.types.intern(Type::Variadic(each, to))
            }
        }
    }
}
