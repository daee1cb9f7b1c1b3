//! Factoring a category into the constants it speaks of and a template with typed holes (Kwiatkowski et al. 2011).
//! A template's meaning is the category's, abstracted over its holes: applying it to constants gives it back.

use crate::logic::{ConstantId, LogicError, Node, TIME, TermId, Terms};

/// The constants that never become a hole: they are the frame that words fill.
const FRAME: [&str; 7] = ["and", "or", "not", "true", "false", "the", "exists"];

/// Whether a constant is one of them: what speaks of time is.
fn is_frame(name: &str) -> bool {
    FRAME.contains(&name) || TIME.iter().any(|(known, _)| *known == name)
}

/// Constants in the order of their first occurrence, and the meaning abstracted over them in that order.
pub struct Factored {
    /// What fills the holes.
    pub constants: Vec<ConstantId>,
    /// `λhole₁. … λholeₙ. meaning`
    pub template: TermId,
}

/// Factors a closed meaning. `fixed` are further constants that belong to the frame.
///
/// # Errors
/// When the abstraction is too large.
pub fn factor(
    terms: &mut Terms,
    meaning: TermId,
    fixed: &[ConstantId],
) -> Result<Factored, LogicError> {
    let mut constants = terms.constants(meaning);
    constants.retain(|c| !is_frame(terms.name(*c)) && !fixed.contains(c));
    let mut template = abstract_constants(terms, meaning, &constants, 0)?;
    for &constant in constants.iter().rev() {
        template = terms.lambda(terms.constant_ty(constant), template)?;
    }
    Ok(Factored { constants, template })
}

/// Fills a template's holes.
///
/// # Errors
/// When a constant does not fit its hole.
pub fn instantiate(
    terms: &mut Terms,
    template: TermId,
    constants: &[ConstantId],
) -> Result<TermId, LogicError> {
    constants.iter().try_fold(template, |function, &constant| {
        let (name, ty) = (terms.name(constant).to_owned(), terms.constant_ty(constant));
        let argument = terms.constant_term(&name, ty)?;
        terms.apply(function, argument)
    })
}

/// `term` below `depth` binders with each constant replaced by the variable of its hole, the first outermost.
fn abstract_constants(
    terms: &mut Terms,
    term: TermId,
    constants: &[ConstantId],
    depth: u32,
) -> Result<TermId, LogicError> {
    match terms.node(term) {
        Node::Variable(_) => Ok(term),
        Node::Constant(constant) => match constants.iter().position(|&c| c == constant) {
            None => Ok(term),
            Some(place) => {
                let index = depth + (constants.len() - 1 - place) as u32;
                terms.variable(index, terms.constant_ty(constant))
            }
        },
        Node::Lambda { parameter, body } => {
            let body = abstract_constants(terms, body, constants, depth + 1)?;
            terms.lambda(parameter, body)
        }
        Node::Apply { head, args } => {
            let mut args = args.to_vec();
            for arg in &mut args {
                *arg = abstract_constants(terms, *arg, constants, depth)?;
            }
            let Node::Constant(constant) = terms.node(head) else {
                return terms.apply_head(head, &args);
            };
            match constants.iter().position(|&c| c == constant) {
                None => terms.apply_head(head, &args),
                Some(place) => {
                    let index = depth + (constants.len() - 1 - place) as u32;
                    let hole = terms.variable(index, terms.constant_ty(constant))?;
                    args.iter().try_fold(hole, |function, &arg| terms.apply(function, arg))
                }
            }
        }
    }
}
