//! German grammar: goals, things, cells and changes in German sentences.

use super::german_words::Case::{self, Dative, Nominative};
use super::german_words::Gender::{self, Feminine, Masculine, Neuter};
use super::german_words::{adjective, article, compass, definite, indefinite, property};
use super::phrases::{Phrases, Spot, capitalised, spot};
use crate::domain::{Color, Lock, Object, Shape, Size, State};
use crate::ui::page::place::Place;
use crate::worker::protocol::{Article, Claim, Description, Noun, Phrase, Referent, Refers};

/// The grammar.
pub struct German;

impl Phrases for German {
    fn claim(&self, claim: &Claim) -> String {
        match claim {
            Claim::All(all) => all.iter().map(|c| self.claim(c)).collect::<Vec<_>>().join(", und "),
            Claim::Any(all) => {
                all.iter().map(|c| self.claim(c)).collect::<Vec<_>>().join(", oder ")
            }
            Claim::Not(inner) => match &**inner {
                Claim::Related { relation, nouns } => {
                    let [first, second] = &**nouns;
                    format!("{} ist nicht {}", noun(first, Nominative), related(relation, second))
                }
                other => format!("es gilt nicht: {}", self.claim(other)),
            },
            Claim::Related { relation, nouns } => {
                let [first, second] = &**nouns;
                format!("{} ist {}", noun(first, Nominative), related(relation, second))
            }
            Claim::Is(property, thing) => {
                format!("{} ist {}", noun(thing, Nominative), adjective(property))
            }
            Claim::Exists(description) => {
                format!("irgendwo ist {}", described(description, Nominative))
            }
            Claim::Formula(formula) => format!("es gilt: {formula}"),
        }
    }

    fn noun(&self, thing: &Noun) -> String {
        noun(thing, Nominative)
    }

    fn failure(&self, phrase: &Phrase) -> String {
        let name = self.noun(&phrase.noun);
        let all: Vec<String> = phrase.referents.iter().map(|r| self.referent(r)).collect();
        match phrase.refers {
            Refers::None => format!("„{name}“ gibt es hier nicht."),
            Refers::Several => {
                format!("„{name}“ passt auf {} Dinge: {}.", all.len(), self.list(&all))
            }
            Refers::Tie => {
                format!("„{name}“ passt auf {} gleich große: {}.", all.len(), self.list(&all))
            }
            Refers::Single => format!("Für „{name}“ müsste es mehr als eines davon geben."),
            Refers::Mixed => {
                format!("Was zu „{name}“ passt, lässt sich nicht der Größe nach vergleichen.")
            }
            Refers::One | Refers::Inner => format!("„{name}“ hängt an etwas, das es nicht gibt."),
        }
    }

    fn referent(&self, referent: &Referent) -> String {
        let (word, gender) = match (referent.shape, referent.class.as_str()) {
            (Some(shape), _) => property(shape.name()),
            (None, class) => property(class),
        };
        let mut adjectives: Vec<&str> = Vec::new();
        adjectives.extend(match referent.size {
            Some(Size::Small) => Some("klein"),
            Some(Size::Large) => Some("groß"),
            Some(Size::Medium) | None => None,
        });
        adjectives.extend(referent.color.map(|color| adjective(color.name())));
        definite(&adjectives, word, gender, Nominative)
    }

    fn list(&self, all: &[String]) -> String {
        match all {
            [] => "nichts".to_owned(),
            [one] => one.clone(),
            [first @ .., last] => format!("{} und {last}", first.join(", ")),
        }
    }

    fn look(&self, color: Color, shape: Shape, size: Option<Size>) -> String {
        let (word, gender) = property(shape.name());
        let ending = match gender {
            Masculine => "er",
            Feminine => "e",
            Neuter => "es",
        };
        let size = match size {
            Some(Size::Small) => format!("klein{ending} "),
            Some(Size::Large) => format!("groß{ending} "),
            Some(Size::Medium) | None => String::new(),
        };
        format!("{size}{}{ending} {word}", adjective(color.name()))
    }

    fn color(&self, color: Color) -> &'static str {
        adjective(color.name())
    }

    fn shape(&self, shape: Shape) -> &'static str {
        property(shape.name()).0
    }

    fn size(&self, size: Size) -> &'static str {
        match size {
            Size::Small => "klein",
            Size::Medium => "mittel",
            Size::Large => "groß",
        }
    }

    fn spot(&self, spot: Spot) -> String {
        match spot {
            Spot::Room(color) => format!("im {}en Raum", adjective(color.name())),
            Spot::Door(Lock::Unlocked) => "in einer offenen Tür".to_owned(),
            Spot::Door(Lock::Locked) => "in einer verschlossenen Tür".to_owned(),
            Spot::Door(Lock::Unknown) => "in einer Tür, die niemand probiert hat".to_owned(),
            Spot::Wall => "in einer Wand".to_owned(),
            Spot::Outside => "außerhalb aller Räume".to_owned(),
        }
    }

    fn coordinates(&self, (x, y): Place) -> String {
        format!("Spalte {x}, Zeile {y}")
    }

    fn robot(&self, state: &State) -> String {
        let agent = &state.agent;
        let spot = self.spot(spot(state, (agent.x, agent.y)));
        format!("Der Roboter ist {spot} und schaut nach {}.", compass(agent.direction))
    }

    fn world(&self, state: &State) -> String {
        let mut words = self.robot(state);
        let rooms: Vec<String> =
            state.rooms.iter().map(|r| adjective(r.color.name()).to_owned()).collect();
        words.push_str(&format!(" Räume: {}.", self.list(&rooms)));
        for object in &state.objects {
            let spot = self.spot(spot(state, (object.x, object.y)));
            let object = capitalised(&self.object(object));
            words.push_str(&format!(" {object} {spot}."));
        }
        words
    }

    fn moved_robot(&self, _state: &State, to: Spot) -> String {
        format!("Der Roboter ist jetzt {}.", self.spot(to))
    }

    fn turned_robot(&self, state: &State) -> String {
        format!("Der Roboter schaut nach {}.", compass(state.agent.direction))
    }

    fn moved_object(&self, object: &Object, to: Spot) -> String {
        let (word, gender) = property(object.shape.name());
        let name = definite(&[adjective(object.color.name())], word, gender, Nominative);
        format!("{} ist jetzt {}.", capitalised(&name), self.spot(to))
    }

    fn changed_door(&self, cell: Place, lock: Lock) -> String {
        let now = match lock {
            Lock::Unlocked => "offen",
            Lock::Locked => "verschlossen",
            Lock::Unknown => "nicht probiert",
        };
        format!("Die Tür bei {} ist {now}.", self.coordinates(cell))
    }

    fn rebuilt(&self, state: &State) -> String {
        let State { rooms, doors, objects, .. } = state;
        format!("Räume: {}, Türen: {}, Gegenstände: {}.", rooms.len(), doors.len(), objects.len())
    }

    fn holds(&self, what: Option<&Object>) -> String {
        let what = what.map_or("Roboter".to_owned(), |object| self.object(object));
        format!("In der Hand: {what}. Pfeiltasten tragen, Eingabe setzt ab, Escape lässt los.")
    }

    fn holds_corner(&self) -> String {
        "Eine Ecke ist hier. Pfeiltasten gehen zur anderen, Eingabe malt den Raum.".to_owned()
    }

    fn robot_here(&self, state: &State) -> String {
        format!("der Roboter, schaut nach {}", compass(state.agent.direction))
    }
}

fn noun(thing: &Noun, case: Case) -> String {
    match thing {
        Noun::Robot => definite(&[], "Roboter", Masculine, case),
        Noun::It => "es".to_owned(),
        Noun::Described(description) => described(description, case),
        Noun::Formula(formula) => formula.clone(),
    }
}

/// "neben dem roten Stuhl"
fn related(relation: &str, other: &Noun) -> String {
    let other = noun(other, Dative);
    match relation {
        "in" => match other.strip_prefix("dem ") {
            Some(rest) => format!("im {rest}"),
            None => format!("in {other}"),
        },
        "near" => format!("neben {other}"),
        "left" => format!("links von {other}"),
        "right" => format!("rechts von {other}"),
        _ => format!("dasselbe wie {other}"),
    }
}

fn described(description: &Description, case: Case) -> String {
    let Description { article, properties, claims } = description;
    let (colors, nouns): (Vec<&str>, Vec<&str>) =
        properties.iter().map(String::as_str).partition(|p| p.parse::<Color>().is_ok());
    let (word, gender) = nouns.first().map_or(("Ding", Neuter), |noun| property(noun));
    let others = nouns.iter().skip(1).map(|noun| format!(" und {}", property(noun).0));
    let word = format!("{word}{}", others.collect::<String>());
    let mut adjectives: Vec<&str> = match article {
        Article::Biggest => vec!["größt"],
        Article::Smallest => vec!["kleinst"],
        Article::A | Article::The | Article::Closest(_) => Vec::new(),
    };
    adjectives.extend(colors.into_iter().map(adjective));
    let phrase = match article {
        Article::A => indefinite(&adjectives, &word, gender, case),
        _ => definite(&adjectives, &word, gender, case),
    };
    // The shades have English names only.
    let shade = match (article, gender) {
        (Article::Closest(shade), Feminine) => Some(("deren", shade.name())),
        (Article::Closest(shade), _) => Some(("dessen", shade.name())),
        _ => None,
    };
    let shade = shade.map(|(whose, name)| format!("{whose} Farbe „{name}“ am nächsten kommt"));
    let claims = claims.iter().map(|claim| relative(claim, gender));
    let after: Vec<String> = shade.into_iter().chain(claims).collect();
    if after.is_empty() { phrase } else { format!("{phrase}, {}", after.join(" und ")) }
}

/// A claim about the thing at hand, behind its noun: "der im roten Raum ist".
fn relative(claim: &Claim, gender: Gender) -> String {
    let pronoun = article(gender, Nominative);
    match claim {
        Claim::Related { relation, nouns } => match (&**nouns, relation.as_str()) {
            ([Noun::It, other], relation) => {
                format!("{pronoun} {} ist", related(relation, other))
            }
            ([other, Noun::It], "in") => {
                format!("in {} {} ist", article(gender, Dative), noun(other, Nominative))
            }
            ([other, Noun::It], "left") => format!("{pronoun} {} ist", related("right", other)),
            ([other, Noun::It], "right") => format!("{pronoun} {} ist", related("left", other)),
            ([other, Noun::It], relation) => {
                format!("{pronoun} {} ist", related(relation, other))
            }
            _ => format!("wofür gilt: {}", German.claim(claim)),
        },
        Claim::Is(property, thing) if **thing == Noun::It => {
            format!("{pronoun} {} ist", adjective(property))
        }
        Claim::Not(inner) => match &**inner {
            Claim::Related { relation, nouns } if nouns[0] == Noun::It => {
                format!("{pronoun} nicht {} ist", related(relation, &nouns[1]))
            }
            Claim::Is(property, thing) if **thing == Noun::It => {
                format!("{pronoun} nicht {} ist", adjective(property))
            }
            _ => format!("wofür gilt: {}", German.claim(claim)),
        },
        _ => format!("wofür gilt: {}", German.claim(claim)),
    }
}
