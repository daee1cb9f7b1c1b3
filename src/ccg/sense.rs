//! What nobody means. Some goals are well typed and could hold, but say nothing, or something else than any speaker would:
//! a sentence that has only such readings has none. And one of several denials, which is what "or" comes to beside a word
//! that denies ("anywhere but the red or the blue room"), is all of them.

use crate::logic::signature::SortSet;
use crate::logic::{LogicError, Node, Sorts, TermId, Terms, ty};

/// Whether somebody could mean a goal.
pub(super) fn makes_sense(terms: &Terms, sorts: &Sorts, term: TermId) -> bool {
    let mut rooms = Rooms::default();
    says_something(terms, sorts, &mut rooms, term)
        && !rooms.are_one()
        && !defeats_itself(terms, sorts, term)
}

/// Whether a goal, or a part of it, is said so that it can never be, or always is: whatever else the words might mean is not
/// what was said.
pub(super) fn defeats_itself(terms: &Terms, sorts: &Sorts, term: TermId) -> bool {
    let args = match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => return false,
        Node::Lambda { body, .. } => return defeats_itself(terms, sorts, body),
        Node::Apply { args, .. } => args,
    };
    let is_void = match (terms.head_name(term), args) {
        (Some("near" | "left" | "right"), &[thing, other]) => {
            thing == other && !is_robot(terms, thing)
        }
        (Some("exists"), _) => are_homes(terms, term),
        (Some("all"), parts) => forbids_itself(terms, parts),
        (Some("and"), parts) => denies_idly(terms, sorts, parts),
        _ => false,
    };
    is_void || args.iter().any(|&arg| defeats_itself(terms, sorts, arg))
}

/// Which kinds of rooms a goal speaks of.
#[derive(Default)]
struct Rooms {
    /// "The room", with nothing more.
    bare: bool,
    /// One that is told from others by more than where the robot is.
    told: bool,
}

impl Rooms {
    /// Adds what a phrase speaks of, given all that it says of it.
    fn see(&mut self, terms: &Terms, phrase: &str, parts: &[TermId]) {
        if !parts.iter().any(|&part| terms.head_name(part) == Some("room")) {
            return;
        }
        let is_own =
            |&part: &TermId| stands(terms, part).is_some_and(|thing| is_robot(terms, thing));
        let is_bare = parts.len() == 1 && phrase == "the";
        let is_here = parts.len() == 2 && parts.iter().any(is_own);
        self.bare |= is_bare;
        self.told |= !(is_bare || is_here);
    }

    /// Whether a goal speaks of the room and of one that is told from others: that one would be meant by both ("take it to the
    /// red room and stay out of the room").
    fn are_one(&self) -> bool {
        self.bare && self.told
    }
}

/// Whether a goal and all its parts say something that could be meant; the rooms that it speaks of are noted.
fn says_something(terms: &Terms, sorts: &Sorts, rooms: &mut Rooms, term: TermId) -> bool {
    let args = match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => return true,
        Node::Lambda { body, .. } => return says_something(terms, sorts, rooms, body),
        Node::Apply { args, .. } => args,
    };
    let is_said = match (terms.head_name(term), args) {
        (Some(phrase @ ("the" | "argmax" | "argmin")), &[property, ..]) => {
            let body = body(terms, property);
            rooms.see(terms, phrase, &body.map_or(Vec::new(), |body| conjuncts(terms, body)));
            body != Some(terms.truth())
        }
        (Some("exists"), _) => !is_idle(terms, term),
        (Some("not"), &[denied]) => {
            !is_everywhere(terms, denied)
                && !is_narrow(terms, denied)
                && !is_elsewhere(terms, denied)
        }
        (Some("in"), &[_, place]) => !is_door(terms, place),
        (Some("until"), &[_, first, next]) => !is_undone(terms, first, next),
        (Some("and"), parts) => {
            let is_void = contradicts(terms, parts)
                || mixes(terms, sorts, parts)
                || claims_same(terms, parts);
            !is_void && !excludes_idly(terms, sorts, parts) && !excludes_half(terms, parts)
        }
        _ => true,
    };
    is_said && args.iter().all(|&arg| says_something(terms, sorts, rooms, arg))
}

/// The goal with every choice between denials made their conjunction.
///
/// # Errors
/// When the result is too large.
pub(super) fn denied(terms: &mut Terms, term: TermId) -> Result<TermId, LogicError> {
    match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => Ok(term),
        Node::Lambda { parameter, body } => {
            let body = denied(terms, body)?;
            terms.lambda(parameter, body)
        }
        Node::Apply { head, args } => {
            let mut args = args.to_vec();
            for arg in &mut args {
                *arg = denied(terms, *arg)?;
            }
            match terms.head_name(head) {
                Some("or") if are_denials(terms, &args) => {
                    let all: Vec<_> = args.iter().flat_map(|&arg| conjuncts(terms, arg)).collect();
                    terms.conjoin(&all)
                }
                _ => terms.apply_head(head, &args),
            }
        }
    }
}

/// Whether each of several says the same as the others, and denies something besides. Where they claim nothing, it is of the
/// same thing: of two things it is one or the other ("get either the block or the chair out").
fn are_denials(terms: &Terms, several: &[TermId]) -> bool {
    let parts: Vec<Vec<TermId>> = several.iter().map(|&one| conjuncts(terms, one)).collect();
    let is_shared = |part: &TermId| parts.iter().all(|other| other.contains(part));
    let claims = parts.iter().flatten().any(is_shared);
    let mut of_one = None;
    parts.iter().all(|own| {
        let mut own = own.iter().filter(|part| !is_shared(part)).peekable();
        own.peek().is_some()
            && own.all(|&part| {
                terms.denied(part).is_some_and(|denied| {
                    let of = subject(terms, denied);
                    claims || *of_one.get_or_insert(of) == of
                })
            })
    })
}

/// What something is said of, if one thing is: the first argument.
fn subject(terms: &Terms, part: TermId) -> Option<TermId> {
    match terms.node(part) {
        Node::Apply { args: &[of, ..], .. } if terms.ty(of) == ty::ENTITY => Some(of),
        _ => None,
    }
}

/// The parts of a conjunction; anything else is one.
fn conjuncts(terms: &Terms, term: TermId) -> Vec<TermId> {
    match terms.node(term) {
        Node::Apply { args, .. } if terms.head_name(term) == Some("and") => args.to_vec(),
        _ => vec![term],
    }
}

/// What a function makes of its argument.
fn body(terms: &Terms, function: TermId) -> Option<TermId> {
    match terms.node(function) {
        Node::Lambda { body, .. } => Some(body),
        _ => None,
    }
}

/// What is said of what a phrase such as `the` or `exists` is of, part by part.
fn said_of(terms: &Terms, phrase: TermId, quantifier: &str) -> Option<Vec<TermId>> {
    let &[property] = terms.arguments(phrase, quantifier)? else { return None };
    Some(body(terms, property).map_or(Vec::new(), |body| conjuncts(terms, body)))
}

/// The thing that is said to be in a place that `the` names, and what is said of that place.
fn placed(terms: &Terms, part: TermId) -> Option<(TermId, Vec<TermId>)> {
    let &[thing, place] = terms.arguments(part, "in")? else { return None };
    Some((thing, said_of(terms, place, "the")?))
}

/// Whether it is said of a place, by the innermost variable, that a thing is in it: which.
fn stands(terms: &Terms, part: TermId) -> Option<TermId> {
    match terms.arguments(part, "in")? {
        &[thing, place] if terms.node(place) == Node::Variable(0) => Some(thing),
        _ => None,
    }
}

/// Whether it is that in some room a thing is not, and no more of what is there: it always is so.
fn is_idle(terms: &Terms, some: TermId) -> bool {
    let parts = said_of(terms, some, "exists").unwrap_or_default();
    is_everywhere(terms, some) && !parts.iter().any(|&part| stands(terms, part).is_some())
}

/// Whether it is that in some room a thing is not: denied, the thing would have to be in all rooms at once.
fn is_everywhere(terms: &Terms, denied: TermId) -> bool {
    let Some(parts) = said_of(terms, denied, "exists") else { return false };
    let is_room = |&part: &TermId| terms.head_name(part) == Some("room");
    let is_outside =
        |&part: &TermId| terms.denied(part).is_some_and(|inside| stands(terms, inside).is_some());
    parts.iter().any(is_room) && parts.iter().any(is_outside)
}

/// Whether it is that something is in one place and not in another: all that is in the first place would be brought to the
/// second by being brought anywhere ("move everything in the red room to the blue room").
fn is_elsewhere(terms: &Terms, denied: TermId) -> bool {
    let Some(parts) = said_of(terms, denied, "exists") else { return false };
    let is_placed = |part: TermId| {
        let is_own = |of: TermId| terms.node(of) == Node::Variable(0);
        let Node::Apply { args: &[of, _], .. } = terms.node(part) else { return false };
        is_own(of) && !matches!(terms.head_name(part), Some("and" | "or" | "eq"))
    };
    let is_elsewhere = |part: &TermId| terms.denied(*part).is_some_and(is_placed);
    parts.iter().any(|&part| is_placed(part)) && parts.iter().any(is_elsewhere)
}

/// Whether a thing is to leave the place where it is, if that is none of some others: "the other room, not the red one".
fn is_narrow(terms: &Terms, denied: TermId) -> bool {
    let Some((thing, parts)) = placed(terms, denied) else { return false };
    parts.iter().any(|&part| stands(terms, part) == Some(thing))
        && parts.iter().any(|&part| terms.head_name(part) == Some("not"))
}

/// Whether a place is a door, in which nothing ever is: to be there is out of reach, what is there is nothing, and not to be
/// there is idle ("do not block the door").
fn is_door(terms: &Terms, place: TermId) -> bool {
    let parts = said_of(terms, place, "the").unwrap_or_default();
    parts.iter().any(|&part| terms.head_name(part) == Some("door"))
}

/// Whether a thing is to be somewhere, and then not: whoever leaves a place when a thing is there is the robot.
fn is_undone(terms: &Terms, first: TermId, next: TermId) -> bool {
    let undone = terms.arguments(next, "until").and_then(|then| then.get(1).copied());
    let denied = undone.and_then(|undone| terms.denied(undone));
    let Some(&[thing, _]) = terms.arguments(first, "in") else { return false };
    denied == Some(first) && !is_robot(terms, thing)
}

/// Whether what is never to be so is to be reached ("go to the chair but don't touch it").
fn forbids_itself(terms: &Terms, parts: &[TermId]) -> bool {
    let forbidden = parts.iter().filter_map(|&part| {
        let &[always] = terms.arguments(part, "always")? else { return None };
        terms.denied(always)
    });
    let forbidden: Vec<TermId> = forbidden.collect();
    parts.iter().any(|&part| {
        let mut next = part;
        while let Some(&[_, reached, then]) = terms.arguments(next, "until") {
            if forbidden.contains(&reached) {
                return true;
            }
            next = then;
        }
        false
    })
}

/// Whether it is that several are each in the room where they are: they always are, and to deny it is to have each elsewhere
/// than it will be ("put every chair in a different room").
fn are_homes(terms: &Terms, some: TermId) -> bool {
    let parts = said_of(terms, some, "exists").unwrap_or_default();
    parts.iter().any(|&part| {
        let Some((thing, of_place)) = placed(terms, part) else { return false };
        let is_own = |part: &TermId| match terms.arguments(*part, "in") {
            Some(&[of, _]) => terms.node(of) == Node::Variable(1),
            _ => false,
        };
        terms.node(thing) == Node::Variable(0) && of_place.iter().any(is_own)
    })
}

/// Whether a thing is the robot.
fn is_robot(terms: &Terms, thing: TermId) -> bool {
    let is_agent = |part: TermId| terms.head_name(part) == Some("agent");
    said_of(terms, thing, "the").is_some_and(|all| matches!(all[..], [one] if is_agent(one)))
}

/// Whether something is claimed and denied, be it as one of several.
fn contradicts(terms: &Terms, parts: &[TermId]) -> bool {
    let several =
        |part: TermId| terms.arguments(part, "or").map_or_else(|| vec![part], <[_]>::to_vec);
    let claimed: Vec<TermId> = parts.iter().flat_map(|&part| several(part)).collect();
    let mut denials = parts.iter().filter_map(|&part| terms.denied(part));
    denials.any(|denied| several(denied).iter().any(|one| claimed.contains(one)))
}

/// Whether one thing is said to have two qualities of one kind, such as colours, or to be in two places that have.
fn mixes(terms: &Terms, sorts: &Sorts, parts: &[TermId]) -> bool {
    let own = parts.iter().flat_map(|&part| quality(terms, sorts, part));
    let places = parts.iter().flat_map(|&part| {
        let Some((thing, parts)) = placed(terms, part) else { return Vec::new() };
        let all = parts.into_iter().flat_map(|part| quality(terms, sorts, part));
        all.map(|(_, kind, name)| (thing, kind, name)).collect()
    });
    [own.collect::<Vec<_>>(), places.collect()].iter().any(|all| {
        let differs = |a: &(TermId, &[SortSet], &str), b: &(TermId, &[SortSet], &str)| {
            a.0 == b.0 && a.1 == b.1 && a.2 != b.2
        };
        (1..all.len()).any(|at| all[..at].iter().any(|other| differs(other, &all[at])))
    })
}

/// Whether something is said not to have a quality beside another of that kind: nothing red is yellow ("the blocks in the red
/// room except the yellow one").
fn denies_idly(terms: &Terms, sorts: &Sorts, parts: &[TermId]) -> bool {
    let claimed: Vec<_> = parts.iter().filter_map(|&part| quality(terms, sorts, part)).collect();
    let denied = parts.iter().filter_map(|&part| quality(terms, sorts, terms.denied(part)?));
    let mut denied = denied.into_iter();
    denied.any(|(of, kind, name)| {
        claimed.iter().any(|&(own, claimed, other)| own == of && claimed == kind && other != name)
    })
}

/// What a part says of a variable that is no noun: the variable, of what sorts it can be said, and what.
fn quality<'a>(
    terms: &'a Terms,
    sorts: &'a Sorts,
    part: TermId,
) -> Option<(TermId, &'a [SortSet], &'a str)> {
    let Node::Apply { args: &[of], .. } = terms.node(part) else { return None };
    let name = terms.head_name(part)?;
    let is_quality = matches!(terms.node(of), Node::Variable(_)) && sorts.is_quality(name);
    is_quality.then_some((of, sorts.of(name)?, name))
}

/// Whether something of a kind is said to be what another phrase names: only a denial of a denial says so ("a room other than
/// this one, though not the yellow one").
fn claims_same(terms: &Terms, parts: &[TermId]) -> bool {
    let is_variable = |&of: &TermId| matches!(terms.node(of), Node::Variable(_));
    parts
        .iter()
        .any(|&part| terms.arguments(part, "eq").is_some_and(|both| both.iter().any(is_variable)))
}

/// Whether something is said to be, or not to be, what its kind can never be: a chair other than the block, a red room other
/// than the blue one. Or it is said not to be what has all its properties: the chair other than the chair.
fn excludes_idly(terms: &Terms, sorts: &Sorts, parts: &[TermId]) -> bool {
    parts.iter().any(|&part| {
        let denied = terms.denied(part);
        let Some(&[a, b]) = terms.arguments(denied.unwrap_or(part), "eq") else { return false };
        let (index, phrase) = match (terms.node(a), terms.node(b)) {
            (Node::Variable(index), _) => (index, b),
            (_, Node::Variable(index)) => (index, a),
            _ => return false,
        };
        let Some(of_phrase) = said_of(terms, phrase, "the") else { return false };
        let is_own = |part: &TermId| parts.contains(part);
        if denied.is_some() && index == 0 && of_phrase.iter().all(is_own) {
            return true;
        }
        let qualities = |parts: &[TermId], index: u32| -> Vec<(&[SortSet], &str)> {
            let all = parts.iter().filter_map(|&part| quality(terms, sorts, part));
            let of_one = all.filter(|&(of, ..)| terms.node(of) == Node::Variable(index));
            of_one.map(|(_, kind, name)| (kind, name)).collect()
        };
        let [own, other] = [qualities(parts, index), qualities(&of_phrase, 0)];
        let excludes = |(kind, name): &(&[SortSet], &str)| {
            other.iter().any(|(of, other)| of == kind && other != name)
        };
        if own.iter().any(excludes) {
            return true;
        }
        let [own, other] = [kinds(terms, sorts, parts, index), kinds(terms, sorts, &of_phrase, 0)];
        !own.is_empty() && !other.is_empty() && !own.iter().any(|kind| other.contains(kind))
    })
}

/// Whether a thing is to be in two places at once, one of which is told by what it is not: of what is listed behind "other
/// than" only a part would be excluded, and the rest asked for.
fn excludes_half(terms: &Terms, parts: &[TermId]) -> bool {
    let denies = |&part: &TermId| {
        terms.denied(part).is_some_and(|denied| terms.head_name(denied) != Some("in"))
    };
    let place = |&part: &TermId| -> Option<(TermId, bool)> {
        let (thing, of_place) = match said_of(terms, part, "exists") {
            Some(all) => (all.iter().find_map(|&part| stands(terms, part))?, all),
            None => placed(terms, part)?,
        };
        (!of_place.is_empty()).then(|| (thing, of_place.iter().any(denies)))
    };
    let places: Vec<(TermId, bool)> = parts.iter().filter_map(place).collect();
    places.iter().enumerate().any(|(at, &(thing, excludes))| {
        excludes && places.iter().enumerate().any(|(other, &(of, _))| other != at && of == thing)
    })
}

/// What the thing of a variable may be, by what is said of it: nouns; none where nothing is said.
fn kinds<'a>(terms: &'a Terms, sorts: &Sorts, parts: &[TermId], index: u32) -> Vec<&'a str> {
    let mut found = Vec::new();
    for &part in parts {
        let Node::Apply { args, .. } = terms.node(part) else { continue };
        match (terms.head_name(part), args) {
            (Some("or"), args) => {
                let all = args.iter().map(|&arg| conjuncts(terms, arg));
                found.extend(all.flat_map(|own| kinds(terms, sorts, &own, index)));
            }
            (Some("object"), _) => {}
            (Some(name), &[of]) if terms.node(of) == Node::Variable(index) => {
                found.extend(sorts.is_noun(name).then_some(name));
            }
            _ => {}
        }
    }
    found
}
