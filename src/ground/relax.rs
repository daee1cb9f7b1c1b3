//! A task over time that a world has no way for, made to ask for less: without some of what it demands on the way, or with
//! that demanded only once it is so.

use super::goal::GoalError;
use super::outline::{Outline, Part};
use crate::logic::{LogicError, Node, TermId, Terms};

/// What a task demands of every state on the way, in the order of its parts, each once.
///
/// # Errors
/// Why the term is no task.
pub fn demands(terms: &Terms, task: TermId) -> Result<Vec<TermId>, GoalError> {
    let outline = Outline::new(terms, task)?;
    let mut found = Vec::new();
    for part in outline.parts() {
        let (Part::Always(at) | Part::Until { hold: at, .. }) = *part else { continue };
        let demand = outline.guards()[at];
        if let Part::Until { reach, .. } = *part
            && is_first(terms, demand, outline.guards()[reach])
        {
            continue;
        }
        if demand != terms.truth() && !found.contains(&demand) {
            found.push(demand);
        }
    }
    Ok(found)
}

/// The task without some of what it demands on the way.
///
/// # Errors
/// When it would be too large.
pub fn without(terms: &mut Terms, task: TermId, demands: &[TermId]) -> Result<TermId, LogicError> {
    let Node::Apply { head, args } = terms.node(task) else { return Ok(task) };
    let Node::Constant(constant) = terms.node(head) else { return Ok(task) };
    let (name, args) = (terms.name(constant).to_owned(), args.to_vec());
    match (name.as_str(), &args[..]) {
        ("always", [demand]) if demands.contains(demand) => {
            terms.constant_term("done", crate::logic::ty::RUN)
        }
        ("until", &[hold, reach, then]) => {
            let hold = if demands.contains(&hold) { terms.truth() } else { hold };
            let then = without(terms, then, demands)?;
            terms.apply_head(head, &[hold, reach, then])
        }
        ("all" | "any", parts) => {
            let parts: Result<Vec<TermId>, LogicError> =
                parts.iter().map(|&part| without(terms, part, demands)).collect();
            terms.apply_head(head, &parts?)
        }
        _ => Ok(task),
    }
}

/// Whether all that is to hold until something is so is that it is not: it is meant the first time that it is so.
pub fn is_first(terms: &Terms, hold: TermId, reach: TermId) -> bool {
    terms.denied(hold) == Some(reach) || terms.denied(reach) == Some(hold)
}

/// The task from where its demands are met for the first time: "once outside, not again".
///
/// # Errors
/// When it would be too large.
pub fn once(terms: &mut Terms, task: TermId, demands: &[TermId]) -> Result<TermId, LogicError> {
    let met = terms.conjoin(demands)?;
    let types = ["<t,<t,<p,p>>>", "<t,t>"].map(|text| terms.types.read(text));
    let [Some(until), Some(not)] = types else { return Ok(task) };
    let until = terms.constant_term("until", until)?;
    let unmet = match terms.denied(met) {
        Some(unmet) => unmet,
        None => {
            let not = terms.constant_term("not", not)?;
            terms.apply(not, met)?
        }
    };
    [unmet, met, task].into_iter().try_fold(until, |term, part| terms.apply(term, part))
}

/// What is left of a task when so many of its steps are done.
///
/// # Errors
/// When it would be too large.
pub fn after(terms: &mut Terms, task: TermId, steps: usize) -> Result<TermId, LogicError> {
    let Node::Apply { head, args } = terms.node(task) else { return Ok(task) };
    let (Node::Constant(constant), true) = (terms.node(head), steps > 0) else { return Ok(task) };
    let (name, args) = (terms.name(constant).to_owned(), args.to_vec());
    match (name.as_str(), &args[..]) {
        ("until", &[_, _, then]) => after(terms, then, steps - 1),
        ("all", parts) => {
            let parts: Result<Vec<TermId>, LogicError> =
                parts.iter().map(|&part| after(terms, part, steps)).collect();
            terms.apply_head(head, &parts?)
        }
        _ => Ok(task),
    }
}
