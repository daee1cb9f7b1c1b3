//! The combinatory rules as rows of a table, and a cache from a pair of syntactic categories to the rows that
//! combine it: rejecting a pair costs one look-up. Normal form after Eisner (1996). Type shifts, which change one
//! category into another, are data of the lexicon: what may be left unsaid depends on the domain.

use super::category::Category;
use super::syntax::{Atom, Direction, SyntaxId, Syntaxes};
use crate::logic::{ConstantId, Expression, LogicError, Node, Sorts, TermId, Terms, ty};
use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap};

/// A row of [`RULES`], or after those a shift of the grammar's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RuleId(pub u8);

/// A rule for two neighbours.
pub struct Rule {
    /// Its name in derivations and features.
    pub name: &'static str,
    syntax: fn(&mut Syntaxes, SyntaxId, SyntaxId) -> Option<SyntaxId>,
    meaning: fn(&mut Terms, TermId, TermId) -> Result<TermId, LogicError>,
    /// What the meaning is before it is reduced.
    written: fn(Expression, Expression) -> Expression,
    /// The neighbour that is the functor.
    functor: Side,
    /// How what comes out may not be used at once (Eisner 1996).
    made: Made,
}

/// A rule for one constituent, such as `PP => N\N`.
#[derive(Clone, Debug, PartialEq)]
pub struct Shift {
    /// Its name in derivations and features.
    pub name: Box<str>,
    /// What it changes.
    pub from: SyntaxId,
    /// What comes out.
    pub to: SyntaxId,
    /// From the meaning before to the meaning after.
    pub meaning: TermId,
}

impl Shift {
    /// Whether it makes a clause of time of a command.
    fn is_late(&self) -> bool {
        self.to == SyntaxId::T
    }
}

/// One of two neighbours, or a way in which neither is the other's functor.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
    /// The left one is raised to a functor.
    Raised,
    Neither,
    /// Neither, and the right one may be no bare phrase that a shift made a command of.
    Beside,
    /// Neither, and the left one may be no bare phrase that a shift made a command of.
    Before,
}

/// How a constituent was made, as far as the normal form asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Made {
    /// From the lexicon, by application, or by any rule without restriction.
    Plainly,
    /// By forward composition: it may not be the functor of a forward rule.
    ByForwardComposition,
    /// By backward composition: it may not be the functor of a backward rule.
    ByBackwardComposition,
    /// By a shift: it may not shift again, but to a clause of time.
    ByShift,
    /// By the shift of a plain command to a clause of time.
    ByTask,
    /// By the shift of a noun to what describes another noun: no functor takes it for an adjective ("not the chair" is no
    /// "not red").
    ByDescription,
}

impl Made {
    /// Whether a shift made it.
    pub(super) fn is_shifted(self) -> bool {
        matches!(self, Made::ByShift | Made::ByTask | Made::ByDescription)
    }
}

/// The variable of the binder around. The parts are closed, so that nothing needs raising below a new binder.
const HERE: Expression = Expression::Variable(0);

/// The binary rules. The order is the order of ties.
pub const RULES: &[Rule] = &[
    Rule {
        name: ">",
        syntax: |all, left, right| {
            let (result, argument) = all.forward(left)?;
            all.applied(result, argument, right)
        },
        meaning: |terms, left, right| terms.apply(left, right),
        written: |left, right| left.applied(vec![right]),
        functor: Side::Left,
        made: Made::Plainly,
    },
    Rule {
        name: "<",
        syntax: |all, left, right| {
            let (result, argument) = all.backward(right)?;
            all.applied(result, argument, left)
        },
        meaning: |terms, left, right| terms.apply(right, left),
        written: |left, right| right.applied(vec![left]),
        functor: Side::Right,
        made: Made::Plainly,
    },
    Rule {
        name: ">B",
        syntax: |all, left, right| {
            let (result, middle) = all.forward(left)?;
            let (inner, argument) = all.forward(right)?;
            (middle == inner).then(|| all.slash(result, Direction::Right, argument))
        },
        meaning: |terms, left, right| terms.compose(left, right),
        written: |left, right| left.applied(vec![right.applied(vec![HERE])]).lambda(),
        functor: Side::Left,
        made: Made::ByForwardComposition,
    },
    Rule {
        name: "<B",
        syntax: |all, left, right| {
            let (result, middle) = all.backward(right)?;
            let (inner, argument) = all.backward(left)?;
            (middle == inner).then(|| all.slash(result, Direction::Left, argument))
        },
        meaning: |terms, left, right| terms.compose(right, left),
        written: |left, right| right.applied(vec![left.applied(vec![HERE])]).lambda(),
        functor: Side::Right,
        made: Made::ByBackwardComposition,
    },
    Rule {
        name: ">T",
        syntax: |all, left, right| {
            let (inner, argument) = all.forward(right)?;
            let (result, subject) = all.backward(inner)?;
            (subject == left).then(|| all.slash(result, Direction::Right, argument))
        },
        meaning: raised_composition,
        written: |left, right| right.applied(vec![HERE, left]).lambda(),
        functor: Side::Raised,
        made: Made::Plainly,
    },
    Rule {
        name: "rel",
        syntax: |all, left, right| {
            let (result, argument) = all.forward(right).or_else(|| all.backward(right))?;
            let clause = all.is(result, Atom::S) && all.is(argument, Atom::NP);
            (clause && all.is(left, Atom::N)).then_some(left)
        },
        meaning: conjoin_properties,
        written: |left, right| {
            let both = [left, right].map(|property| property.applied(vec![HERE]));
            Expression::Name("and".into()).applied(both.into()).lambda()
        },
        functor: Side::Neither,
        made: Made::Plainly,
    },
    // Several commands in one sentence: all are to be done. "Leave the red room" is not "leave", then the red room.
    Rule {
        name: "&",
        syntax: |_, left, right| {
            let begins = left.is_command() || left == SyntaxId::LIST;
            (begins && right.is_command()).then_some(SyntaxId::LIST)
        },
        meaning: |terms, left, right| terms.conjoin(&[left, right]),
        written: |left, right| Expression::Name("and".into()).applied(vec![left, right]),
        functor: Side::Beside,
        made: Made::Plainly,
    },
    // Two clauses of time: first the one, then the other.
    Rule {
        name: ";",
        syntax: |_, left, right| (left == SyntaxId::T && right == SyntaxId::T).then_some(left),
        meaning: |terms, left, right| terms.compose(left, right),
        written: |left, right| left.applied(vec![right.applied(vec![HERE])]).lambda(),
        functor: Side::Beside,
        made: Made::Plainly,
    },
    // A prohibition beside a clause of time holds all along, wherever it is said.
    Rule {
        name: "!",
        syntax: |_, left, right| {
            (left == SyntaxId::T && right == SyntaxId::NEG).then_some(SyntaxId::T)
        },
        meaning: |terms, left, right| terms.bounded(right, left),
        written: |left, right| bounded(right, left),
        functor: Side::Before,
        made: Made::Plainly,
    },
    Rule {
        name: "!>",
        syntax: |_, left, right| {
            (left == SyntaxId::NEG && right == SyntaxId::T).then_some(SyntaxId::T)
        },
        meaning: |terms, left, right| terms.bounded(left, right),
        written: bounded,
        functor: Side::Beside,
        made: Made::Plainly,
    },
];

/// `λk. all(always(φ), f(k))`
fn bounded(holds: Expression, clause: Expression) -> Expression {
    let name = |name: &str| Expression::Name(name.into());
    let parts = vec![name("always").applied(vec![holds]), clause.applied(vec![HERE])];
    name("all").applied(parts).lambda()
}

/// `λy. g(y)(x)` for `x g`: `x` raised to `λf. f(x)` and composed with `g`.
fn raised_composition(terms: &mut Terms, x: TermId, g: TermId) -> Result<TermId, LogicError> {
    let function = terms.ty(g);
    let crate::logic::Type::Function(argument, _) = terms.types.get(function) else {
        return Err(LogicError::NotAFunction);
    };
    // Both are closed in a chart, so that nothing needs shifting below the new binder.
    let y = terms.variable(0, argument)?;
    let applied = terms.apply(g, y)?;
    let both = terms.apply(applied, x)?;
    terms.lambda(argument, both)
}

/// `λx. f(x) ∧ g(x)`; not with a denial, by which nothing is told without "that".
fn conjoin_properties(terms: &mut Terms, f: TermId, g: TermId) -> Result<TermId, LogicError> {
    if terms.denies(g) {
        return Err(LogicError::TypeMismatch);
    }
    let x = terms.variable(0, ty::ENTITY)?;
    let both = [terms.apply(f, x)?, terms.apply(g, x)?];
    let body = terms.conjoin(&both)?;
    terms.lambda(ty::ENTITY, body)
}

/// How many rows a pair of syntactic categories can match.
type Rows = Vec<(RuleId, SyntaxId)>;

/// The arena, the syntactic categories and the rules' cache: what it takes to combine categories.
#[derive(Clone, Debug, Default)]
pub struct Grammar {
    /// The meanings.
    pub terms: Terms,
    /// The syntactic categories.
    pub syntaxes: Syntaxes,
    /// What can be true of what.
    pub sorts: Sorts,
    /// Binary relations whose arguments may change places, such as `near`: two readings that differ in nothing
    /// else are one answer.
    pub commutative: Vec<ConstantId>,
    /// The type shifts. The order is the order of ties.
    pub shifts: Vec<Shift>,
    /// For every left and every right category the place of their rows in `known`, one more than that; 0 where it was
    /// not asked yet.
    rows: Vec<Vec<u32>>,
    known: IndexSet<Rows, FxBuildHasher>,
    /// What became of neighbours by rules without a functor: applications and compositions are known to the terms.
    beside: FxHashMap<(RuleId, TermId, TermId), Option<TermId>>,
}

impl Grammar {
    /// The rows that combine two syntactic categories, and what comes out: one look-up after the first time.
    pub fn rows(&mut self, left: SyntaxId, right: SyntaxId) -> &[(RuleId, SyntaxId)] {
        let Grammar { syntaxes, rows, known, .. } = self;
        if rows.len() <= left.index() {
            rows.resize(left.index() + 1, Vec::new());
        }
        let row = &mut rows[left.index()];
        if row.len() <= right.index() {
            row.resize(right.index() + 1, 0);
        }
        let place = &mut row[right.index()];
        if *place == 0 {
            let made = |(row, rule): (u8, &Rule)| {
                Some((RuleId(row), (rule.syntax)(syntaxes, left, right)?))
            };
            let found = (0..).zip(RULES).filter_map(made).collect();
            *place = known.insert_full(found).0 as u32 + 1;
        }
        &known[*place as usize - 1]
    }

    /// The meaning that a row gives two neighbours; `None` when the meanings do not fit, the result would be too
    /// large, or, unless that is allowed, the functor adds nothing to its argument (`green green room`).
    pub fn combine(
        &mut self,
        rule: RuleId,
        left: TermId,
        right: TermId,
        allow_vacuous: bool,
    ) -> Option<TermId> {
        let Rule { functor, meaning, .. } = RULES.get(usize::from(rule.0))?;
        let (functor, argument) = match functor {
            Side::Left => (left, right),
            Side::Right => (right, left),
            Side::Raised | Side::Neither | Side::Beside | Side::Before => {
                let make = || meaning(&mut self.terms, left, right).ok();
                return *self.beside.entry((rule, left, right)).or_insert_with(make);
            }
        };
        let meaning = meaning(&mut self.terms, left, right).ok()?;
        let vacuous = meaning == argument && !self.is_identity(functor);
        (allow_vacuous || !vacuous).then_some(meaning)
    }

    /// Whether a function throws its argument away, after taking so many others.
    pub fn throws(&self, function: TermId, after: u32) -> bool {
        let mut body = function;
        for _ in 0..=after {
            let Node::Lambda { body: inner, .. } = self.terms.node(body) else { return false };
            body = inner;
        }
        !self.terms.uses(body, 0)
    }

    /// How what a shift makes of a constituent is marked for the normal form.
    pub fn shift_makes(&self, rule: RuleId, of: Made) -> Made {
        let Some(shift) = self.shift(rule) else { return Made::ByShift };
        let is_noun = |syntax: SyntaxId| self.syntaxes.is(syntax, Atom::N);
        let describes = self.syntaxes.forward(shift.to);
        match describes {
            // Where one passes is no command of its own.
            _ if self.syntaxes.is(shift.from, Atom::VIA) => Made::ByShift,
            _ if shift.is_late() && !of.is_shifted() => Made::ByTask,
            Some((noun, of)) if [shift.from, noun, of].into_iter().all(is_noun) => {
                Made::ByDescription
            }
            _ => Made::ByShift,
        }
    }

    /// Whether a shift throws away what it changes.
    pub(super) fn shift_throws(&self, rule: RuleId) -> bool {
        self.shift(rule).is_some_and(|shift| self.throws(shift.meaning, 0))
    }

    /// Which of two neighbours the row throws away, if any.
    pub(super) fn thrown(&self, rule: RuleId, left: TermId, right: TermId) -> Option<Side> {
        let throws = |meaning| [0, 1].map(|after| self.throws(meaning, after));
        let functor = RULES.get(usize::from(rule.0))?.functor;
        let thrown = if functor == Side::Left { Side::Right } else { Side::Left };
        rule.throws(throws(left), throws(right)).then_some(thrown)
    }

    /// What any rule, a shift too, makes of the meanings of its parts; `None` when they do not fit or the result would
    /// be too large.
    pub fn meaning(&mut self, rule: RuleId, parts: &[TermId]) -> Option<TermId> {
        match *parts {
            [left, right] => self.combine(rule, left, right, true),
            [part] => {
                let shift = self.shift(rule)?;
                // A thing is told by what is not so only where "that is" or the like says so: "the chair out of the red
                // room" is no chair but where it is to be.
                if self.terms.denies(part) && self.syntaxes.describes(shift.to) {
                    return None;
                }
                self.terms.apply(shift.meaning, part).ok()
            }
            _ => None,
        }
    }

    /// The same, written down before it is reduced.
    pub fn written(&self, rule: RuleId, parts: &[TermId]) -> Option<Expression> {
        let of = |term: TermId| Expression::of(&self.terms, term);
        match *parts {
            [left, right] => {
                let rule = RULES.get(usize::from(rule.0))?;
                Some((rule.written)(of(left), of(right)))
            }
            [part] => Some(of(self.shift(rule)?.meaning).applied(vec![of(part)])),
            _ => None,
        }
    }

    fn shift(&self, rule: RuleId) -> Option<&Shift> {
        self.shifts.get(usize::from(rule.0).checked_sub(RULES.len())?)
    }

    /// Whether a meaning could be about something.
    pub fn fits(&mut self, meaning: TermId) -> bool {
        self.sorts.fit(&self.terms, meaning)
    }

    /// How many predicates of the parts are missing from what came of them.
    pub fn lost(&self, parts: &[TermId], whole: TermId) -> u32 {
        let said =
            parts.iter().fold(0, |sum, &part| self.terms.predicates(part).saturating_add(sum));
        said.saturating_sub(self.terms.predicates(whole))
    }

    /// The shifts of a syntactic category, with what they make of it.
    /// Those to clauses of time are `late`: they may follow one of the others.
    pub(super) fn shifts_of(
        &self,
        from: SyntaxId,
        late: bool,
    ) -> impl Iterator<Item = (RuleId, SyntaxId)> {
        let numbered = (RULES.len() as u8..).map(RuleId).zip(&self.shifts);
        let fits = move |shift: &Shift| shift.from == from && shift.is_late() == late;
        numbered.filter(move |(_, shift)| fits(shift)).map(|(rule, shift)| (rule, shift.to))
    }

    /// What the shifts make of a category, with the rules.
    pub fn shifted(&mut self, category: Category, late: bool) -> Vec<(RuleId, Category)> {
        let shifts: Vec<_> = self.shifts_of(category.syntax, late).collect();
        let shifted = shifts.into_iter().filter_map(|(rule, syntax)| {
            let meaning = self.meaning(rule, &[category.meaning])?;
            Some((rule, Category { syntax, meaning }))
        });
        shifted.collect()
    }

    /// The rules, shifts behind the rest.
    pub(super) fn rules(&self) -> impl Iterator<Item = RuleId> + use<> {
        (0..(RULES.len() + self.shifts.len()) as u8).map(RuleId)
    }

    /// A rule's name.
    pub fn rule_name(&self, rule: RuleId) -> &str {
        match RULES.get(usize::from(rule.0)) {
            Some(rule) => rule.name,
            None => self.shift(rule).map_or("", |shift| &shift.name),
        }
    }

    /// The rule of that name.
    pub fn rule_named(&self, name: &str) -> Option<RuleId> {
        let rules = RULES.iter().map(|rule| rule.name);
        let names = rules.chain(self.shifts.iter().map(|shift| &*shift.name));
        (0..).zip(names).find(|(_, known)| *known == name).map(|(row, _)| RuleId(row))
    }

    /// `λx. x`, at any type.
    fn is_identity(&mut self, term: TermId) -> bool {
        let Node::Lambda { parameter, .. } = self.terms.node(term) else {
            return false;
        };
        let x = self.terms.variable(0, parameter);
        x.and_then(|x| self.terms.lambda(parameter, x)) == Ok(term)
    }
}

impl RuleId {
    /// How what the rule makes is marked for the normal form.
    pub fn makes(self) -> Made {
        RULES.get(usize::from(self.0)).map_or(Made::ByShift, |rule| rule.made)
    }

    /// Whether the rule throws one of its neighbours away, of each of which is known whether as a functor it throws its
    /// first and its second argument away.
    pub(super) fn throws(self, left: [bool; 2], right: [bool; 2]) -> bool {
        match RULES.get(usize::from(self.0)).map(|rule| rule.functor) {
            Some(Side::Left) => left[0],
            Some(Side::Right) => right[0],
            // What is raised is the second argument of its neighbour.
            Some(Side::Raised) => right[1],
            Some(Side::Neither | Side::Beside | Side::Before) | None => false,
        }
    }

    /// Whether the normal form admits the rule on constituents made so (Eisner 1996).
    pub fn admits(self, left: Made, right: Made) -> bool {
        match RULES.get(usize::from(self.0)).map(|rule| rule.functor) {
            Some(Side::Left) => left != Made::ByForwardComposition && right != Made::ByDescription,
            Some(Side::Right) => {
                right != Made::ByBackwardComposition && left != Made::ByDescription
            }
            Some(Side::Beside) => right != Made::ByShift,
            Some(Side::Before) => left != Made::ByShift,
            _ => true,
        }
    }
}
