//! German deeds: what the robot is about to do, as what follows "Ich werde": "in den blauen Raum gehen". Names stand
//! between asterisks, for a page that sets them off.

use super::claims::{denied, one_place, related};
use super::german_claims::{claim, noun};
use super::german_words::Case::{self, Accusative, Dative};
use crate::worker::protocol::{Claim, Noun};

/// "*den gelben Block* in *den größten Raum* bringen"
pub(super) fn deed(told: &Claim) -> String {
    let all = |all: &[Claim], word: &str| match one_place(all) {
        Some((things, relation, place)) => {
            let things: Vec<String> = things.into_iter().map(|t| name(t, Accusative)).collect();
            let things = things.join(&format!(" {word} "));
            format!("{things} {} bringen", to(relation, place))
        }
        None => all.iter().map(deed).collect::<Vec<_>>().join(&format!(" {word} ")),
    };
    match told {
        // What is never to be is said behind what is to be done.
        Claim::All(claims) => {
            let (never, rest): (Vec<Claim>, Vec<Claim>) =
                claims.iter().cloned().partition(|one| matches!(one, Claim::Never(_)));
            let never = never.iter().map(deed).map(|never| format!(", aber {never}"));
            return all(&rest, "und") + &never.collect::<String>();
        }
        Claim::Then(claims) => {
            return claims.iter().map(deed).collect::<Vec<_>>().join(", dann ");
        }
        Claim::Never(inner) => {
            return match related(inner) {
                Some(("in", [Noun::Robot, place])) => format!("nie {} gehen", to("in", place)),
                _ => format!("dafür sorgen, dass gilt: {}", claim(told)),
            };
        }
        Claim::Until(both) => {
            return format!("{} und bis dahin {}", deed(&both[1]), deed(&both[0]));
        }
        Claim::Any(claims) => return all(claims, "oder"),
        _ => {}
    }
    match (related(told), denied(told)) {
        (Some((relation, [Noun::Robot, place])), _) if relation != "eq" => {
            format!("{} gehen", to(relation, place))
        }
        (Some((relation, [thing, place])), _) if relation != "eq" => {
            format!("{} {} bringen", name(thing, Accusative), to(relation, place))
        }
        (_, Some(("in" | "near", [Noun::Robot, place]))) => {
            format!("{} fernbleiben", name(place, Dative))
        }
        (_, Some(("in", [thing, place]))) => {
            format!("{} aus {} schaffen", name(thing, Accusative), name(place, Dative))
        }
        (_, Some(("near", [thing, place]))) => {
            format!("{} von {} wegbringen", name(thing, Accusative), name(place, Dative))
        }
        _ => format!("dafür sorgen, dass gilt: {}", claim(told)),
    }
}

/// "in *den blauen Raum*", "links neben *den Stuhl*"
fn to(relation: &str, place: &Noun) -> String {
    let word = match relation {
        "near" => "neben",
        "left" => "links neben",
        "right" => "rechts neben",
        other => other,
    };
    format!("{word} {}", name(place, Accusative))
}

fn name(told: &Noun, case: Case) -> String {
    format!("*{}*", noun(told, case))
}
