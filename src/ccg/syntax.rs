//! Syntactic categories: atoms and slashes, interned, so that equal ids are equal categories. Text is
//! left-associative: `S/PP/NP` is `(S/PP)/NP`, which looks for an NP to the right and then for a PP.

use crate::logic::{TyId, Types, ty};
use rustc_hash::FxHashMap;

/// The id of an interned syntactic category.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SyntaxId(u32);

impl SyntaxId {
    /// What means nothing: the atoms have the same ids everywhere, in their order.
    pub const EMPTY: SyntaxId = SyntaxId(Atom::EMPTY as u32);

    /// A command.
    pub(super) const S: SyntaxId = SyntaxId(Atom::S as u32);

    /// Several commands, one after the other.
    pub const LIST: SyntaxId = SyntaxId(Atom::LIST as u32);

    /// A prohibition.
    pub(super) const NEG: SyntaxId = SyntaxId(Atom::NEG as u32);

    /// A task over time.
    pub(super) const T: SyntaxId = SyntaxId(Atom::T as u32);

    /// Its place among the categories.
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }

    /// Whether a whole sentence may have the category: a command, a prohibition, several commands, or a task over time.
    pub fn is_sentence(self) -> bool {
        self.is_command() || self.is_several() || self.is_one_of(&[Atom::NEG, Atom::T])
    }

    /// Whether it is a clause that tells to do something: a command, or one with two things.
    pub(super) fn is_command(self) -> bool {
        self.is_one_of(&[Atom::S, Atom::PAIR])
    }

    /// Whether it tells of several things, side by side.
    pub(super) fn is_several(self) -> bool {
        self.is_one_of(&[Atom::PAIR, Atom::LIST])
    }

    fn is_one_of(self, atoms: &[Atom]) -> bool {
        atoms.iter().any(|&atom| self == SyntaxId(atom as u32))
    }
}

/// The atoms: sentence, noun, noun phrase, prepositional phrase, adverbial phrase, predicative adjective;
/// what means nothing here, which its neighbour absorbs; a prohibition, which is a sentence alone and no clause of
/// another (beside a goal it would hold all the time, not at the end); several commands side by side, which are a
/// sentence alone too (what is said of the first is not said of all); what a prohibition alone takes, two things of
/// which neither is to be; a command with two things, which no prohibition takes; a task over time, or a clause of one;
/// and where the robot passes on its way, which no clause of states takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the categories'")]
pub enum Atom {
    S,
    N,
    NP,
    PP,
    AP,
    ADJ,
    EMPTY,
    NEG,
    LIST,
    ALT,
    PAIR,
    T,
    VIA,
}

const ATOMS: [(Atom, &str); 13] = [
    (Atom::S, "S"),
    (Atom::N, "N"),
    (Atom::NP, "NP"),
    (Atom::PP, "PP"),
    (Atom::AP, "AP"),
    (Atom::ADJ, "ADJ"),
    (Atom::EMPTY, "EMPTY"),
    (Atom::NEG, "NEG"),
    (Atom::LIST, "LIST"),
    (Atom::ALT, "ALT"),
    (Atom::PAIR, "PAIR"),
    (Atom::T, "T"),
    (Atom::VIA, "VIA"),
];

/// Where a functor looks for its argument: `/` to the right, `\` to the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "said above")]
pub enum Direction {
    Right,
    Left,
}

/// A syntactic category, one level deep.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Syntax {
    /// An atom.
    Atom(Atom),
    /// `result/argument` or `result\argument`.
    Slash {
        /// What comes out.
        result: SyntaxId,
        /// Where the argument stands.
        direction: Direction,
        /// What is looked for.
        argument: SyntaxId,
    },
}

/// Slashes that a category's text may have.
const MAX_SLASHES: usize = 16;

/// The interned categories. The atoms have the same ids in every instance.
#[derive(Clone, Debug)]
pub struct Syntaxes {
    all: Vec<Syntax>,
    texts: Vec<Box<str>>,
    index: FxHashMap<Syntax, SyntaxId>,
}

impl Default for Syntaxes {
    fn default() -> Self {
        let mut syntaxes =
            Syntaxes { all: Vec::new(), texts: Vec::new(), index: FxHashMap::default() };
        for (atom, _) in ATOMS {
            syntaxes.atom(atom);
        }
        syntaxes
    }
}

impl Syntaxes {
    /// The category behind an id.
    pub fn get(&self, id: SyntaxId) -> Syntax {
        self.all[id.0 as usize]
    }

    /// The text of a category, as [`Syntaxes::read`] reads it; also its rank where categories are ordered.
    pub fn text(&self, id: SyntaxId) -> &str {
        &self.texts[id.0 as usize]
    }

    /// The id of an atom.
    pub fn atom(&mut self, atom: Atom) -> SyntaxId {
        self.intern(Syntax::Atom(atom))
    }

    /// The id of `result/argument` or `result\argument`.
    pub fn slash(
        &mut self,
        result: SyntaxId,
        direction: Direction,
        argument: SyntaxId,
    ) -> SyntaxId {
        self.intern(Syntax::Slash { result, direction, argument })
    }

    /// `result/argument`, if that is what the category is.
    pub fn forward(&self, id: SyntaxId) -> Option<(SyntaxId, SyntaxId)> {
        match self.get(id) {
            Syntax::Slash { result, direction: Direction::Right, argument } => {
                Some((result, argument))
            }
            _ => None,
        }
    }

    /// `result\argument`, if that is what the category is.
    pub fn backward(&self, id: SyntaxId) -> Option<(SyntaxId, SyntaxId)> {
        match self.get(id) {
            Syntax::Slash { result, direction: Direction::Left, argument } => {
                Some((result, argument))
            }
            _ => None,
        }
    }

    /// Whether the category is this atom.
    pub fn is(&self, id: SyntaxId, atom: Atom) -> bool {
        self.get(id) == Syntax::Atom(atom)
    }

    /// What comes of `result/argument` or `result\argument` applied to a constituent: what modifies a command modifies
    /// several side by side.
    pub(super) fn applied(
        &self,
        result: SyntaxId,
        argument: SyntaxId,
        to: SyntaxId,
    ) -> Option<SyntaxId> {
        let modifies_commands = [result, argument].iter().all(|&part| self.is(part, Atom::S));
        if argument == to {
            Some(result)
        } else {
            (modifies_commands && to.is_several()).then_some(to)
        }
    }

    /// How many arguments the category takes until an atom is left.
    pub fn arity(&self, id: SyntaxId) -> u32 {
        match self.get(id) {
            Syntax::Atom(_) => 0,
            Syntax::Slash { result, .. } => 1 + self.arity(result),
        }
    }

    /// Whether the category speaks of time anywhere.
    pub fn is_in_time(&self, id: SyntaxId) -> bool {
        match self.get(id) {
            Syntax::Atom(atom) => matches!(atom, Atom::T | Atom::VIA),
            Syntax::Slash { result, argument, .. } => {
                self.is_in_time(result) || self.is_in_time(argument)
            }
        }
    }

    /// Whether the category is that of a word that says of a clause of time what must not be so along it: `T\T/S`. It takes
    /// what is done, no bare phrase ("without the chair" is no place to be kept clear of).
    pub(super) fn forbids_along(&self, id: SyntaxId) -> bool {
        let Some((rest, argument)) = self.forward(id) else { return false };
        let parts = self.forward(rest).or_else(|| self.backward(rest));
        let is_clause = |id: SyntaxId| id == SyntaxId::T || id == SyntaxId::S;
        argument == SyntaxId::S
            && parts.is_some_and(|(whole, of)| whole == SyntaxId::T && is_clause(of))
    }

    /// Whether the category is that of a word that forbids the robot a place: `T\T/NP`, `NEG/S`.
    pub(super) fn forbids_place(&self, id: SyntaxId) -> bool {
        let Some((rest, argument)) = self.forward(id) else { return false };
        let is_clause = self.backward(rest) == Some((SyntaxId::T, SyntaxId::T));
        is_clause && self.is(argument, Atom::NP) || rest == SyntaxId::NEG && argument == SyntaxId::S
    }

    /// Whether the category is that of what describes a noun before it: `N\N`.
    pub(super) fn describes(&self, id: SyntaxId) -> bool {
        self.modifies(id, Atom::N)
    }

    /// Whether the category is that of a place that goes on with the one before it: `PP\PP`.
    pub(super) fn goes_on(&self, id: SyntaxId) -> bool {
        self.modifies(id, Atom::PP)
    }

    fn modifies(&self, id: SyntaxId, atom: Atom) -> bool {
        let parts = self.backward(id);
        parts.is_some_and(|(whole, of)| self.is(whole, atom) && self.is(of, atom))
    }

    /// Whether the category, once it has all it takes, is a sentence.
    pub(super) fn sets_goal(&self, id: SyntaxId) -> bool {
        match self.get(id) {
            Syntax::Atom(_) => id.is_sentence(),
            Syntax::Slash { result, .. } => self.sets_goal(result),
        }
    }

    /// What a word between two clauses, such as `T\T/T` or `LIST\S/S`, takes behind it; nothing for any other.
    pub(super) fn joined(&self, id: SyntaxId) -> Option<SyntaxId> {
        let (rest, right) = self.forward(id)?;
        let (whole, left) = self.backward(rest)?;
        [whole, left, right].iter().all(|part| part.is_sentence()).then_some(right)
    }

    /// The type of what the category means; `None` where that is left open.
    pub fn ty(&self, types: &mut Types, id: SyntaxId) -> Option<TyId> {
        match self.get(id) {
            Syntax::Atom(Atom::S | Atom::NEG | Atom::LIST | Atom::ALT | Atom::PAIR) => {
                Some(ty::TRUTH)
            }
            Syntax::Atom(Atom::NP) => Some(ty::ENTITY),
            Syntax::Atom(Atom::T) => Some(types.function(ty::RUN, ty::RUN)),
            Syntax::Atom(Atom::N | Atom::PP | Atom::VIA) => {
                Some(types.function(ty::ENTITY, ty::TRUTH))
            }
            Syntax::Atom(Atom::AP | Atom::ADJ | Atom::EMPTY) => None,
            Syntax::Slash { result, argument, .. } => {
                let [argument, result] = [argument, result].map(|part| self.ty(types, part));
                Some(types.function(argument?, result?))
            }
        }
    }

    fn intern(&mut self, syntax: Syntax) -> SyntaxId {
        if let Some(&known) = self.index.get(&syntax) {
            return known;
        }
        let id = SyntaxId(self.all.len() as u32);
        let text = self.print(syntax);
        self.all.push(syntax);
        self.texts.push(text.into());
        self.index.insert(syntax, id);
        id
    }

    fn print(&self, syntax: Syntax) -> String {
        match syntax {
            Syntax::Atom(atom) => {
                ATOMS.iter().find(|(a, _)| *a == atom).map_or("", |(_, name)| name).to_owned()
            }
            Syntax::Slash { result, direction, argument } => {
                let slash = if direction == Direction::Right { '/' } else { '\\' };
                let (result, right) = (self.text(result), self.text(argument));
                match self.get(argument) {
                    Syntax::Atom(_) => format!("{result}{slash}{right}"),
                    Syntax::Slash { .. } => format!("{result}{slash}({right})"),
                }
            }
        }
    }

    /// Reads a category such as `S\NP/(N/N)`; `None` when the text is not one or is too long.
    pub fn read(&mut self, text: &str) -> Option<SyntaxId> {
        if text.matches(['/', '\\', '(']).count() > MAX_SLASHES {
            return None;
        }
        let (id, rest) = self.read_prefix(text.trim())?;
        rest.is_empty().then_some(id)
    }

    fn read_prefix<'a>(&mut self, text: &'a str) -> Option<(SyntaxId, &'a str)> {
        let (mut id, mut rest) = self.read_operand(text)?;
        loop {
            let direction = match rest.chars().next() {
                Some('/') => Direction::Right,
                Some('\\') => Direction::Left,
                _ => return Some((id, rest)),
            };
            let (argument, after) = self.read_operand(&rest[1..])?;
            id = self.slash(id, direction, argument);
            rest = after;
        }
    }

    fn read_operand<'a>(&mut self, text: &'a str) -> Option<(SyntaxId, &'a str)> {
        if let Some(inner) = text.strip_prefix('(') {
            let (id, rest) = self.read_prefix(inner)?;
            return Some((id, rest.strip_prefix(')')?));
        }
        let end = text.find(|c: char| !c.is_ascii_uppercase()).unwrap_or(text.len());
        let (name, rest) = text.split_at(end);
        let (atom, _) = ATOMS.iter().find(|(_, known)| *known == name)?;
        Some((self.atom(*atom), rest))
    }
}
