//! λ-terms as they are written down: without types, not reduced, each a tree of its own. What is shown to people is
//! made of these; what is computed with is [`Terms`]. Variables are de Bruijn indices.

use super::origin::unmarked;
use super::term::{Node, TermId, Terms};
use std::fmt;

/// A λ-term as it is written down.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    /// A constant, by its name.
    Name(Box<str>),
    /// A variable by de Bruijn index.
    Variable(u32),
    /// A function with its arguments; one or more.
    Apply(Box<Expression>, Vec<Expression>),
    /// An abstraction over variable 0 of what stands below.
    Lambda(Box<Expression>),
}

impl Expression {
    /// A term as it is written down.
    pub fn of(terms: &Terms, term: TermId) -> Expression {
        Expression::arranged(terms, term, &mut |_| {})
    }

    /// A term as it is written down; `arrange` has a say in the order of the arguments of `and` and `or`, and may
    /// leave some out.
    pub fn arranged(
        terms: &Terms,
        term: TermId,
        arrange: &mut impl FnMut(&mut Vec<TermId>),
    ) -> Expression {
        match terms.node(term) {
            Node::Constant(constant) => Expression::Name(terms.name(constant).into()),
            Node::Variable(index) => Expression::Variable(index),
            Node::Lambda { body, .. } => {
                Expression::Lambda(Box::new(Expression::arranged(terms, body, arrange)))
            }
            Node::Apply { head, args } => {
                let head = Expression::arranged(terms, head, arrange);
                let mut args = args.to_vec();
                if matches!(&head, Expression::Name(name) if ["and", "or"].contains(&&**name)) {
                    arrange(&mut args);
                    if let [only] = args[..] {
                        return Expression::arranged(terms, only, arrange);
                    }
                }
                head.applied(
                    args.iter().map(|&arg| Expression::arranged(terms, arg, arrange)).collect(),
                )
            }
        }
    }

    /// The function applied to arguments; to none, the function itself.
    #[must_use]
    pub fn applied(self, mut args: Vec<Expression>) -> Expression {
        match self {
            function if args.is_empty() => function,
            Expression::Apply(head, mut all) => {
                all.append(&mut args);
                Expression::Apply(head, all)
            }
            function => Expression::Apply(Box::new(function), args),
        }
    }

    /// An abstraction over variable 0.
    #[must_use]
    pub fn lambda(self) -> Expression {
        Expression::Lambda(Box::new(self))
    }

    /// The number of nodes.
    pub fn size(&self) -> usize {
        match self {
            Expression::Name(_) | Expression::Variable(_) => 1,
            Expression::Lambda(body) => 1 + body.size(),
            Expression::Apply(head, args) => {
                args.iter().fold(head.size(), |sum, arg| sum + arg.size())
            }
        }
    }

    /// What it is called where its binders do nothing: `room` for `λx. room(x)`, `f` for `λx. f(x)`.
    fn contracted(&self) -> Option<Expression> {
        let mut body = self;
        let mut binders = 0;
        while let Expression::Lambda(below) = body {
            body = below;
            binders += 1;
        }
        let Expression::Apply(head, args) = body else { return None };
        let straight = binders > 0
            && args.len() == binders as usize
            && args
                .iter()
                .zip((0..binders).rev())
                .all(|(arg, own)| *arg == Expression::Variable(own));
        match &**head {
            Expression::Name(name) if straight => Some(Expression::Name(name.clone())),
            Expression::Variable(index) if straight => {
                Some(Expression::Variable(index.checked_sub(binders)?))
            }
            _ => None,
        }
    }
}

/// As a person writes it: `in(the agent, the λx. red(x) ∧ room(x))`.
impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write(self, 0, Binding::Loose, f)
    }
}

/// How tightly the place around an expression binds: what needs brackets there.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    /// Anything goes.
    Loose,
    /// Below `∨`: abstractions need brackets.
    Or,
    /// Below `∧`: `∨` needs brackets too.
    And,
    /// Below `¬`: all but applications need brackets.
    Tight,
}

fn write(
    expression: &Expression,
    depth: u32,
    around: Binding,
    out: &mut impl fmt::Write,
) -> fmt::Result {
    if let Some(short) = expression.contracted() {
        return write(&short, depth, around, out);
    }
    match expression {
        Expression::Name(name) => out.write_str(name),
        Expression::Variable(index) => out.write_str(&variable(depth, *index)),
        Expression::Lambda(body) => bracketed(around > Binding::Loose, out, |out| {
            out.write_char('λ')?;
            write_below(body, depth, out)
        }),
        Expression::Apply(head, args) => write_application(head, args, depth, around, out),
    }
}

/// `x. …` for what stands below a binder.
fn write_below(body: &Expression, depth: u32, out: &mut impl fmt::Write) -> fmt::Result {
    write!(out, "{}. ", variable(depth + 1, 0))?;
    write(body, depth + 1, Binding::Loose, out)
}

fn write_application(
    head: &Expression,
    args: &[Expression],
    depth: u32,
    around: Binding,
    out: &mut impl fmt::Write,
) -> fmt::Result {
    let name = match head {
        Expression::Name(name) => &**name,
        _ => "",
    };
    match (unmarked(name), args) {
        ("and", _) => join(args, depth, (" ∧ ", Binding::And), around, out),
        ("or", _) => join(args, depth, (" ∨ ", Binding::Or), around, out),
        ("not", [inner]) => {
            out.write_char('¬')?;
            write(inner, depth, Binding::Tight, out)
        }
        ("the", [description]) => bracketed(around > Binding::Loose, out, |out| {
            write!(out, "{name} ")?;
            write(description, depth, Binding::Loose, out)
        }),
        (plain @ "exists", [description @ Expression::Lambda(body)])
            if description.contracted().is_none() =>
        {
            bracketed(around > Binding::Loose, out, |out| {
                out.write_str(&name.replace(plain, "∃"))?;
                write_below(body, depth, out)
            })
        }
        _ => {
            write(head, depth, Binding::Tight, out)?;
            out.write_char('(')?;
            for (place, arg) in args.iter().enumerate() {
                out.write_str(if place > 0 { ", " } else { "" })?;
                write(arg, depth, Binding::Loose, out)?;
            }
            out.write_char(')')
        }
    }
}

fn join(
    args: &[Expression],
    depth: u32,
    (sign, own): (&str, Binding),
    around: Binding,
    out: &mut impl fmt::Write,
) -> fmt::Result {
    bracketed(around >= own, out, |out| {
        for (place, arg) in args.iter().enumerate() {
            out.write_str(if place > 0 { sign } else { "" })?;
            write(arg, depth, own, out)?;
        }
        Ok(())
    })
}

fn bracketed<W: fmt::Write>(
    needed: bool,
    out: &mut W,
    inside: impl FnOnce(&mut W) -> fmt::Result,
) -> fmt::Result {
    out.write_str(if needed { "(" } else { "" })?;
    inside(out)?;
    out.write_str(if needed { ")" } else { "" })
}

/// The letter of the variable `index` seen from `depth`: x, y, z, u, v, w, then x1, y1 …
fn variable(depth: u32, index: u32) -> String {
    const LETTERS: [char; 6] = ['x', 'y', 'z', 'u', 'v', 'w'];
    let Some(level) = depth.checked_sub(index.saturating_add(1)) else {
        return format!("free{index}");
    };
    let letter = LETTERS[level as usize % LETTERS.len()];
    match level as usize / LETTERS.len() {
        0 => letter.to_string(),
        round => format!("{letter}{round}"),
    }
}
