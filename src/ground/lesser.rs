//! What asks for less than a task over time: the task without one of its steps, or without one of its constraints. A run
//! that shows the task is to tell it from these.

use super::outline::Outline;
use crate::logic::{Node, TermId, Terms};

/// The tasks that one step less, or one constraint less, make of a task, each once; none is the task itself, and none
/// asks for nothing.
pub fn lesser(terms: &mut Terms, task: TermId) -> Vec<TermId> {
    let mut found = less(terms, task);
    let asks = |terms: &Terms, term: TermId| {
        term != task && Outline::new(terms, term).is_ok_and(|outline| !outline.guards().is_empty())
    };
    let mut kept: Vec<TermId> = Vec::new();
    found.retain(|&term| asks(terms, term));
    found.into_iter().for_each(|term| {
        if !kept.contains(&term) {
            kept.push(term);
        }
    });
    kept
}

fn less(terms: &mut Terms, term: TermId) -> Vec<TermId> {
    let Node::Apply { head, args } = terms.node(term) else { return Vec::new() };
    let Node::Constant(constant) = terms.node(head) else { return Vec::new() };
    let (name, args) = (terms.name(constant).to_owned(), args.to_vec());
    let mut found = Vec::new();
    match (name.as_str(), &args[..]) {
        ("always", _) => found.extend(terms.constant_term("done", crate::logic::ty::RUN).ok()),
        ("until", &[hold, reach, then]) => {
            found.push(then);
            let free = terms.truth();
            if hold != free {
                found.extend(terms.apply_head(head, &[free, reach, then]).ok());
            }
            for then in less(terms, then) {
                found.extend(terms.apply_head(head, &[hold, reach, then]).ok());
            }
        }
        ("all" | "any", parts) => {
            for (at, &part) in parts.iter().enumerate() {
                for part in less(terms, part) {
                    let mut parts = parts.to_vec();
                    parts[at] = part;
                    found.extend(terms.apply_head(head, &parts).ok());
                }
            }
        }
        _ => {}
    }
    found
}
