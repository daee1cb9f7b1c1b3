//! Sorts: what kinds of entity a constant can be true of. A phrase such as "the room in the room that is red" asks
//! for something in which nothing can stand: it is well typed and denotes nothing in any world. Inference is
//! conservative: what it refuses is never true, or denies what never is; what it lets pass may still be false.

use super::signature::{Signature, SortSet};
use super::term::{Node, TermId, Terms};
use rustc_hash::FxHashMap;

/// What a signature says of sorts, for the terms of one arena.
#[derive(Clone, Debug, Default)]
pub struct Sorts {
    arguments: FxHashMap<Box<str>, Box<[SortSet]>>,
    /// What is known of terms, by their places in the arena.
    known: Vec<Option<bool>>,
}

impl Sorts {
    /// The sorts of a signature's constants.
    pub fn new(signature: &Signature) -> Self {
        let arguments = signature.arguments().map(|(name, sets)| (name.into(), sets.into()));
        Sorts { arguments: arguments.collect(), known: Vec::new() }
    }

    /// Whether a closed term could be about something. Memoised.
    pub fn fit(&mut self, terms: &Terms, term: TermId) -> bool {
        let place = term.index();
        if let Some(&Some(known)) = self.known.get(place) {
            return known;
        }
        let fits = self.phrase(terms, term, &mut Vec::new()).is_some();
        if self.known.len() <= place {
            self.known.resize(place + 1, None);
        }
        self.known[place] = Some(fits);
        fits
    }

    /// The sorts of a constant's arguments.
    pub fn of(&self, name: &str) -> Option<&[SortSet]> {
        self.arguments.get(name).map(|sets| &**sets)
    }

    /// Whether the constant says what a thing is: a property that only one sort of entity can have.
    pub fn is_noun(&self, name: &str) -> bool {
        matches!(self.arguments.get(name).map(|sets| &**sets), Some([set]) if set.count_ones() == 1)
    }

    /// Whether the constant says how a thing is, not what it is: any other property.
    pub fn is_quality(&self, name: &str) -> bool {
        self.of(name).is_some_and(|sets| sets.len() == 1) && !self.is_noun(name)
    }

    /// Narrows the sorts of the variables around `term`, innermost last, by what it says of them.
    fn check(&self, terms: &Terms, term: TermId, around: &mut Vec<SortSet>) -> bool {
        match terms.node(term) {
            Node::Constant(_) | Node::Variable(_) => true,
            Node::Lambda { .. } => self.range(terms, term, around).is_some(),
            Node::Apply { head, args } => {
                let name = match terms.node(head) {
                    Node::Constant(constant) => terms.name(constant),
                    _ => "",
                };
                // What is denied is no claim about the variables; but it could have been true.
                if name == "not" {
                    return args.iter().all(|&arg| self.check(terms, arg, &mut around.clone()));
                }
                if ["or", "any"].contains(&name) {
                    return self.check_one(terms, args, around);
                }
                if name == "and" {
                    // What is denied is denied of what the rest leaves.
                    let is_denied = |arg: TermId| terms.head_name(arg) == Some("not");
                    let (denied, claimed): (Vec<TermId>, Vec<TermId>) =
                        args.iter().partition(|&&arg| is_denied(arg));
                    let mut parts = claimed.into_iter().chain(denied);
                    return parts.all(|part| self.check(terms, part, around));
                }
                if let ("eq", &[a, b]) = (name, args) {
                    return self.meet(terms, [a, b], around);
                }
                let sets = self.arguments.get(name);
                args.iter().enumerate().all(|(at, &arg)| {
                    let set = sets.and_then(|sets| sets.get(at)).copied().unwrap_or(SortSet::MAX);
                    match terms.node(arg) {
                        Node::Variable(index) => narrow(around, index, set),
                        _ => self.phrase(terms, arg, around).is_some_and(|own| own & set != 0),
                    }
                })
            }
        }
    }

    /// Whether two arguments could stand for the same: variables keep the sorts that both sides can have.
    fn meet(&self, terms: &Terms, sides: [TermId; 2], around: &mut Vec<SortSet>) -> bool {
        let mut both = SortSet::MAX;
        for side in sides {
            both &= match terms.node(side) {
                Node::Variable(index) => place(around, index).map_or(SortSet::MAX, |own| *own),
                _ => match self.phrase(terms, side, around) {
                    Some(own) => own,
                    None => return false,
                },
            };
        }
        let mut variables = sides.into_iter().filter_map(|side| match terms.node(side) {
            Node::Variable(index) => Some(index),
            _ => None,
        });
        both != 0 && variables.all(|index| narrow(around, index, both))
    }

    /// The same for one of several: each variable keeps the sorts that it has in any part that could be true.
    fn check_one(&self, terms: &Terms, parts: &[TermId], around: &mut Vec<SortSet>) -> bool {
        let mut found: Option<Vec<SortSet>> = None;
        for &part in parts {
            // What could not be true by itself is nobody's alternative.
            if !self.check(terms, part, &mut vec![SortSet::MAX; around.len()]) {
                return false;
            }
            let mut own = around.clone();
            if self.check(terms, part, &mut own) {
                let joined = found.get_or_insert_with(|| vec![0; own.len()]);
                joined.iter_mut().zip(own).for_each(|(all, set)| *all |= set);
            }
        }
        let fits = found.is_some();
        if let Some(joined) = found {
            *around = joined;
        }
        fits
    }

    /// The sorts of what an argument stands for; `None` when it cannot stand for anything.
    fn phrase(&self, terms: &Terms, term: TermId, around: &mut Vec<SortSet>) -> Option<SortSet> {
        let Node::Apply { head, args } = terms.node(term) else {
            return self.check(terms, term, around).then_some(SortSet::MAX);
        };
        let is_determiner =
            matches!(terms.node(head), Node::Constant(_)) && terms.ty(term) == super::ty::ENTITY;
        if !is_determiner {
            return self.check(terms, term, around).then_some(SortSet::MAX);
        }
        let mut own = SortSet::MAX;
        for &arg in args {
            own &= match terms.node(arg) {
                Node::Lambda { .. } => self.range(terms, arg, around)?,
                _ => SortSet::MAX,
            };
        }
        (own != 0).then_some(own)
    }

    /// The sorts of what a function can be given; `None` when there are none.
    fn range(&self, terms: &Terms, term: TermId, around: &mut Vec<SortSet>) -> Option<SortSet> {
        let Node::Lambda { body, .. } = terms.node(term) else { return None };
        around.push(SortSet::MAX);
        let fits = self.check(terms, body, around);
        let own = around.pop()?;
        (fits && own != 0).then_some(own)
    }
}

/// Leaves the variable of a de Bruijn index the sorts in `set`; whether any remain.
fn narrow(around: &mut [SortSet], index: u32, set: SortSet) -> bool {
    place(around, index).is_none_or(|own| {
        *own &= set;
        *own != 0
    })
}

/// What is known of the variable of a de Bruijn index.
fn place(around: &mut [SortSet], index: u32) -> Option<&mut SortSet> {
    around.iter_mut().nth_back(index as usize)
}
