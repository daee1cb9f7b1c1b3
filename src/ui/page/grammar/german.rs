//! German grammar: goals, things, cells and changes in German sentences.

use super::german_claims;
use super::german_deeds;
use super::german_words::Case::Nominative;
use super::german_words::Gender::{Feminine, Masculine, Neuter};
use super::german_words::{adjective, compass, definite, property};
use super::phrases::{Phrases, capitalised};
use super::scenes::{Scenes, Spot, spot};
use crate::domain::{Color, Lock, Object, Shape, Size, State};
use crate::ui::page::place::Place;
use crate::worker::protocol::{Claim, Noun, Phrase, Referent, Refers};

/// The grammar.
pub struct German;

impl Phrases for German {
    fn claim(&self, claim: &Claim) -> String {
        german_claims::claim(claim)
    }

    fn deed(&self, claim: &Claim) -> String {
        german_deeds::deed(claim)
    }

    fn keeps(&self, claim: &Claim) -> Option<String> {
        german_claims::keeps(claim)
    }

    fn noun(&self, thing: &Noun) -> String {
        german_claims::noun(thing, Nominative)
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
}

impl Scenes for German {
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

    fn room(&self, color: Color) -> String {
        format!("{}er Raum", adjective(color.name()))
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

    fn stands(&self, what: &str, spot: Spot) -> String {
        format!("{what} ist {}.", self.spot(spot))
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
