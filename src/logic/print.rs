//! Prints terms: as s-expressions that [`super::read()`] reads back to the same id, and as people write logic.

use super::expression::Expression;
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
    Expression::of(terms, term).to_string()
}
