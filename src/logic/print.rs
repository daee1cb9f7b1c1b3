//! Prints terms: as s-expressions that [`super::read()`] reads back to the same id, and as people write logic.

use super::term::{Node, TermId, Terms};

/// The s-expression of a term. Variables are `$d`, d being the depth of their binder from the root.
pub fn print(terms: &Terms, term: TermId) -> String {
    let mut text = String::new();
    write_sexp(terms, term, 0, &mut text);
    text
}

fn write_sexp(terms: &Terms, term: TermId, depth: u32, out: &mut String) {
    match terms.node(term) {
        Node::Constant(constant) => {
            out.push_str(terms.name(constant));
            out.push(':');
            out.push_str(&terms.types.print(terms.constant_ty(constant)));
        }
        // An open term prints its free variables as $-1, $-2 …, which no reader takes for bound ones.
        Node::Variable(index) => {
            out.push_str(&format!("${}", i64::from(depth) - 1 - i64::from(index)));
        }
        Node::Apply { head, args } => {
            out.push('(');
            write_sexp(terms, head, depth, out);
            for &arg in args {
                out.push(' ');
                write_sexp(terms, arg, depth, out);
            }
            out.push(')');
        }
        Node::Lambda { parameter, body } => {
            out.push_str(&format!("(lambda ${depth}:{} ", terms.types.print(parameter)));
            write_sexp(terms, body, depth + 1, out);
            out.push(')');
        }
    }
}

/// A term as a person writes it: `in(the agent, the λx. red(x) ∧ room(x))`.
pub fn print_human(terms: &Terms, term: TermId) -> String {
    let mut text = String::new();
    write_human(terms, term, 0, Binding::Loose, &mut text);
    text
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

fn write_human(terms: &Terms, term: TermId, depth: u32, around: Binding, out: &mut String) {
    if let Some(name) = eta_contracted(terms, term, depth) {
        return out.push_str(&name);
    }
    match terms.node(term) {
        Node::Constant(constant) => out.push_str(terms.name(constant)),
        Node::Variable(index) => out.push_str(&variable(depth, index)),
        Node::Lambda { body, .. } => bracketed(around > Binding::Loose, out, |out| {
            out.push('λ');
            out.push_str(&variable(depth + 1, 0));
            out.push_str(". ");
            write_human(terms, body, depth + 1, Binding::Loose, out);
        }),
        Node::Apply { head, args } => write_application(terms, head, args, depth, around, out),
    }
}

fn write_application(
    terms: &Terms,
    head: TermId,
    args: &[TermId],
    depth: u32,
    around: Binding,
    out: &mut String,
) {
    let name = match terms.node(head) {
        Node::Constant(constant) => terms.name(constant),
        _ => "",
    };
    match (name, args) {
        ("and", _) => join(terms, args, depth, (" ∧ ", Binding::And), around, out),
        ("or", _) => join(terms, args, depth, (" ∨ ", Binding::Or), around, out),
        ("not", [inner]) => {
            out.push('¬');
            write_human(terms, *inner, depth, Binding::Tight, out);
        }
        ("the", [description]) => {
            bracketed(around > Binding::Loose, out, |out| {
                out.push_str("the ");
                write_human(terms, *description, depth, Binding::Loose, out);
            });
        }
        ("exists", [description]) if eta_contracted(terms, *description, depth).is_none() => {
            bracketed(around > Binding::Loose, out, |out| {
                out.push('∃');
                if let Node::Lambda { body, .. } = terms.node(*description) {
                    out.push_str(&variable(depth + 1, 0));
                    out.push_str(". ");
                    write_human(terms, body, depth + 1, Binding::Loose, out);
                }
            });
        }
        _ => {
            write_human(terms, head, depth, Binding::Tight, out);
            out.push('(');
            for (place, &arg) in args.iter().enumerate() {
                if place > 0 {
                    out.push_str(", ");
                }
                write_human(terms, arg, depth, Binding::Loose, out);
            }
            out.push(')');
        }
    }
}

fn join(
    terms: &Terms,
    args: &[TermId],
    depth: u32,
    (sign, own): (&str, Binding),
    around: Binding,
    out: &mut String,
) {
    bracketed(around >= own, out, |out| {
        for (place, &arg) in args.iter().enumerate() {
            if place > 0 {
                out.push_str(sign);
            }
            write_human(terms, arg, depth, own, out);
        }
    });
}

fn bracketed(needed: bool, out: &mut String, write: impl FnOnce(&mut String)) {
    if needed {
        out.push('(');
    }
    write(out);
    if needed {
        out.push(')');
    }
}

/// `room` for `λx. room(x)`, `f` for `λx. f(x)`: the name of the constant or variable whose η-long form this is.
fn eta_contracted(terms: &Terms, term: TermId, depth: u32) -> Option<String> {
    let mut body = term;
    let mut binders = 0;
    while let Node::Lambda { body: below, .. } = terms.node(body) {
        body = below;
        binders += 1;
    }
    let Node::Apply { head, args } = terms.node(body) else { return None };
    let own = (0..binders).rev();
    let straight = args.len() == binders as usize
        && binders > 0
        && args.iter().zip(own).all(|(&arg, index)| terms.node(arg) == Node::Variable(index));
    match terms.node(head) {
        Node::Constant(constant) if straight => Some(terms.name(constant).to_owned()),
        Node::Variable(index) if straight => Some(variable(depth, index.checked_sub(binders)?)),
        _ => None,
    }
}

/// The letter of the variable `index` seen from `depth`: x, y, z, u, v, w, then x1, y1 …
fn variable(depth: u32, index: u32) -> String {
    const LETTERS: [char; 6] = ['x', 'y', 'z', 'u', 'v', 'w'];
    let Some(level) = (depth).checked_sub(index + 1) else { return format!("free{index}") };
    let letter = LETTERS[level as usize % LETTERS.len()];
    match level as usize / LETTERS.len() {
        0 => letter.to_string(),
        round => format!("{letter}{round}"),
    }
}
