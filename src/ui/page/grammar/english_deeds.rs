//! English deeds: what the robot is about to do, as what follows "I will": "go to the blue room". Names stand between
//! asterisks, for a page that sets them off.

use super::claims::{denied, one_place, related};
use super::english_claims::{claim, noun, relation_words};
use crate::worker::protocol::{Claim, Noun};

/// "bring *the yellow block* into *the biggest room*"
pub(super) fn deed(told: &Claim) -> String {
    let all = |all: &[Claim], word: &str| match one_place(all) {
        Some((things, relation, place)) => {
            let things: Vec<String> = things.into_iter().map(name).collect();
            bring(&things.join(&format!(" {word} ")), relation, place)
        }
        None => all.iter().map(deed).collect::<Vec<_>>().join(&format!(", {word} ")),
    };
    match told {
        // What is never to be is said behind what is to be done.
        Claim::All(claims) => {
            let (never, rest): (Vec<Claim>, Vec<Claim>) =
                claims.iter().cloned().partition(|one| matches!(one, Claim::Never(_)));
            let never = never.iter().map(deed).map(|never| format!(", but {never}"));
            return all(&rest, "and") + &never.collect::<String>();
        }
        Claim::Then(claims) => {
            return claims.iter().map(deed).collect::<Vec<_>>().join(", then ");
        }
        Claim::Never(inner) => {
            return match related(inner) {
                Some(("in", [Noun::Robot, place])) => format!("never enter {}", name(place)),
                _ => format!("see to it that {}", claim(told)),
            };
        }
        Claim::Until(both) => {
            return format!("{}, and until then {}", deed(&both[1]), deed(&both[0]));
        }
        Claim::Any(claims) => return all(claims, "or"),
        _ => {}
    }
    match (related(told), denied(told)) {
        (Some(("in", [Noun::Robot, place])), _) => format!("go to {}", name(place)),
        (Some((relation, [Noun::Robot, place])), _) if relation != "eq" => {
            format!("go {} {}", relation_words(relation), name(place))
        }
        (Some((relation, [thing, place])), _) if relation != "eq" => {
            bring(&name(thing), relation, place)
        }
        (_, Some(("in", [Noun::Robot, place]))) => format!("stay out of {}", name(place)),
        (_, Some(("near", [Noun::Robot, place]))) => format!("stay away from {}", name(place)),
        (_, Some(("in", [thing, place]))) => format!("get {} out of {}", name(thing), name(place)),
        (_, Some(("near", [thing, place]))) => {
            format!("get {} away from {}", name(thing), name(place))
        }
        _ => format!("see to it that {}", claim(told)),
    }
}

fn bring(things: &str, relation: &str, place: &Noun) -> String {
    let to = if relation == "in" { "into" } else { relation_words(relation) };
    format!("bring {things} {to} {}", name(place))
}

fn name(told: &Noun) -> String {
    format!("*{}*", noun(told))
}
