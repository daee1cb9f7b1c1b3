//! Simple types over `e` (entity), `t` (truth value), `n` (number) and `p` (property of a run), interned: equal ids
//! exactly when the types are equal. `<a,b>` is a function, `<a*,b>` takes two or more `a`s whose order does not matter.

use rustc_hash::FxHashMap;

/// The id of an interned type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TyId(u32);

/// A type, one level deep.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// `e`
    Entity,
    /// `t`
    Truth,
    /// `n`
    Number,
    /// `p`: what can be so of a finite run of states.
    Run,
    /// `<from,to>`
    Function(TyId, TyId),
    /// `<each*,to>`: only constants have it.
    Variadic(TyId, TyId),
}

/// `e`, in every arena.
pub const ENTITY: TyId = TyId(0);
/// `t`, in every arena.
pub const TRUTH: TyId = TyId(1);
/// `n`, in every arena.
pub const NUMBER: TyId = TyId(2);
/// `p`, in every arena.
pub const RUN: TyId = TyId(3);

/// The types of one arena.
#[derive(Clone, Debug)]
pub struct Types {
    types: Vec<Type>,
    index: FxHashMap<Type, TyId>,
}

impl Default for Types {
    fn default() -> Self {
        let mut types = Types { types: Vec::new(), index: FxHashMap::default() };
        for base in [Type::Entity, Type::Truth, Type::Number, Type::Run] {
            types.intern(base);
        }
        types
    }
}

impl Types {
    /// The type behind an id of this arena.
    pub fn get(&self, id: TyId) -> Type {
        self.types[id.0 as usize]
    }

    /// The id of a type.
    pub fn intern(&mut self, ty: Type) -> TyId {
        let next = TyId(self.types.len() as u32);
        *self.index.entry(ty).or_insert_with(|| {
            self.types.push(ty);
            next
        })
    }

    /// `<from,to>`
    pub fn function(&mut self, from: TyId, to: TyId) -> TyId {
        self.intern(Type::Function(from, to))
    }

    /// Whether `<a*,b>` occurs anywhere in it: such a type may only be a constant's own.
    pub fn has_variadic(&self, id: TyId) -> bool {
        match self.get(id) {
            Type::Entity | Type::Truth | Type::Number | Type::Run => false,
            Type::Function(from, to) => self.has_variadic(from) || self.has_variadic(to),
            Type::Variadic(..) => true,
        }
    }

    /// The text of a type, as [`Types::read`] reads it.
    pub fn print(&self, id: TyId) -> String {
        let mut text = String::new();
        self.print_into(id, &mut text);
        text
    }

    fn print_into(&self, id: TyId, out: &mut String) {
        let (from, star, to) = match self.get(id) {
            Type::Entity => return out.push('e'),
            Type::Truth => return out.push('t'),
            Type::Number => return out.push('n'),
            Type::Run => return out.push('p'),
            Type::Function(from, to) => (from, ",", to),
            Type::Variadic(each, to) => (each, "*,", to),
        };
        out.push('<');
        self.print_into(from, out);
        out.push_str(star);
        self.print_into(to, out);
        out.push('>');
    }

    /// Reads a type such as `<<e,t>,e>`; `None` when the text is not one, or nests deeper than 16.
    pub fn read(&mut self, text: &str) -> Option<TyId> {
        let (ty, rest) = self.read_prefix(text, 16)?;
        rest.is_empty().then_some(ty)
    }

    fn read_prefix<'a>(&mut self, text: &'a str, depth: u32) -> Option<(TyId, &'a str)> {
        let mut rest = text.chars();
        match rest.next()? {
            'e' => Some((ENTITY, rest.as_str())),
            't' => Some((TRUTH, rest.as_str())),
            'n' => Some((NUMBER, rest.as_str())),
            'p' => Some((RUN, rest.as_str())),
            '<' if depth > 0 => {
                let (from, rest) = self.read_prefix(rest.as_str(), depth - 1)?;
                let (variadic, rest) = match rest.strip_prefix('*') {
                    Some(rest) => (true, rest),
                    None => (false, rest),
                };
                let (to, rest) = self.read_prefix(rest.strip_prefix(',')?, depth - 1)?;
                let ty = if variadic { Type::Variadic(from, to) } else { Type::Function(from, to) };
                Some((self.intern(ty), rest.strip_prefix('>')?))
            }
            _ => None,
        }
    }
}
