//! β-reduction one step at a time, for those who want to watch it: the leftmost outermost redex first (normal order,
//! which finds the normal form; Curry and Feys 1958). Terms are kept normal, so this is no part of any computation.

use super::expression::Expression;

/// The most steps that are taken.
const MAX_STEPS: usize = 200;
/// The most nodes that an expression on the way may have.
const MAX_SIZE: usize = 4096;

/// The expression and what each step makes of it, as people write them; a step that does not show, since people leave
/// out binders that do nothing, has no line. A reduction that takes too long ends in `…`.
pub fn steps(whole: Expression) -> Vec<String> {
    let mut lines = vec![whole.to_string()];
    let mut at = whole;
    for _ in 0..MAX_STEPS {
        match step(&at) {
            None => return lines,
            Some(next) if next.size() > MAX_SIZE => break,
            Some(next) => at = next,
        }
        let line = at.to_string();
        if lines.last() != Some(&line) {
            lines.push(line);
        }
    }
    lines.push("…".to_owned());
    lines
}

/// What one step makes of an expression; `None` when it is normal.
fn step(expression: &Expression) -> Option<Expression> {
    match expression {
        Expression::Name(_) | Expression::Variable(_) => None,
        Expression::Lambda(body) => step(body).map(Expression::lambda),
        Expression::Apply(head, args) => {
            if let (Expression::Lambda(body), [first, rest @ ..]) = (&**head, args.as_slice()) {
                return Some(replaced(body, 0, first).applied(rest.to_vec()));
            }
            if let Some(head) = step(head) {
                return Some(head.applied(args.clone()));
            }
            let (place, arg) =
                args.iter().enumerate().find_map(|(place, arg)| Some((place, step(arg)?)))?;
            let mut args = args.clone();
            *args.get_mut(place)? = arg;
            Some(Expression::Apply(head.clone(), args))
        }
    }
}

/// `body` with `argument` for variable `depth`, and the variables beyond it one lower.
fn replaced(body: &Expression, depth: u32, argument: &Expression) -> Expression {
    match body {
        Expression::Name(_) => body.clone(),
        Expression::Variable(index) if *index == depth => raised(argument, depth, 0),
        Expression::Variable(index) => Expression::Variable(index - u32::from(*index > depth)),
        Expression::Lambda(below) => replaced(below, depth + 1, argument).lambda(),
        Expression::Apply(head, args) => replaced(head, depth, argument)
            .applied(args.iter().map(|arg| replaced(arg, depth, argument)).collect()),
    }
}

/// `expression` with its free variables, those from `depth` on, raised by `by`.
fn raised(expression: &Expression, by: u32, depth: u32) -> Expression {
    match expression {
        Expression::Name(_) => expression.clone(),
        Expression::Variable(index) => {
            Expression::Variable(if *index < depth { *index } else { index + by })
        }
        Expression::Lambda(below) => raised(below, by, depth + 1).lambda(),
        Expression::Apply(head, args) => {
            raised(head, by, depth).applied(args.iter().map(|arg| raised(arg, by, depth)).collect())
        }
    }
}
