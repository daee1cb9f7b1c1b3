//! English grammar: goals, things, cells and changes in English sentences.

use super::english_claims;
use super::english_deeds;
use super::phrases::Phrases;
use super::scenes::{Scenes, Spot, spot};
use crate::domain::{Color, Lock, Object, Shape, Size, State};
use crate::ui::page::place::Place;
use crate::worker::protocol::{Claim, Noun, Phrase, Referent, Refers};

/// The grammar.
pub struct English;

impl Phrases for English {
    fn claim(&self, claim: &Claim) -> String {
        english_claims::claim(claim)
    }

    fn deed(&self, claim: &Claim) -> String {
        english_deeds::deed(claim)
    }

    fn keeps(&self, claim: &Claim) -> Option<String> {
        english_claims::keeps(claim)
    }

    fn noun(&self, noun: &Noun) -> String {
        english_claims::noun(noun)
    }

    fn failure(&self, phrase: &Phrase) -> String {
        let noun = self.noun(&phrase.noun);
        let bare = noun.strip_prefix("the ").unwrap_or(&noun);
        let all: Vec<String> = phrase.referents.iter().map(|r| self.referent(r)).collect();
        match phrase.refers {
            Refers::None => format!("There is no {bare}."),
            Refers::Several => {
                format!("There are {} things that “{noun}” fits: {}.", all.len(), self.list(&all))
            }
            Refers::Tie => {
                format!("{} things are equally “{bare}”: {}.", all.len(), self.list(&all))
            }
            Refers::Single => format!("“{noun}” needs more than one thing to choose from."),
            Refers::Mixed => format!("The sizes of things like “{noun}” cannot be compared."),
            Refers::One | Refers::Inner => format!("“{noun}” hangs on a phrase that fails."),
        }
    }

    fn referent(&self, referent: &Referent) -> String {
        let color = referent.color.map(|c| format!("{} ", c.name())).unwrap_or_default();
        let noun: &str = match referent.shape {
            Some(shape) => shape.name(),
            None => &referent.class,
        };
        let size = match referent.size {
            Some(Size::Medium) | None => "",
            Some(size) => size.name(),
        };
        let gap = if size.is_empty() { "" } else { " " };
        if noun == "agent" {
            "the robot".to_owned()
        } else {
            format!("the {size}{gap}{color}{noun}")
        }
    }
}

impl Scenes for English {
    fn list(&self, all: &[String]) -> String {
        match all {
            [] => "nothing".to_owned(),
            [one] => one.clone(),
            [first @ .., last] => format!("{} and {last}", first.join(", ")),
        }
    }

    fn look(&self, color: Color, shape: Shape, size: Option<Size>) -> String {
        match size {
            Some(size @ (Size::Small | Size::Large)) => format!("{size} {color} {shape}"),
            Some(Size::Medium) | None => format!("{color} {shape}"),
        }
    }

    fn color(&self, color: Color) -> &'static str {
        color.name()
    }

    fn room(&self, color: Color) -> String {
        format!("{color} room")
    }

    fn shape(&self, shape: Shape) -> &'static str {
        shape.name()
    }

    fn size(&self, size: Size) -> &'static str {
        size.name()
    }

    fn spot(&self, spot: Spot) -> String {
        match spot {
            Spot::Room(color) => format!("in the {color} room"),
            Spot::Door(lock) => format!("in {}", door_words(lock)),
            Spot::Wall => "in a wall".to_owned(),
            Spot::Outside => "outside all rooms".to_owned(),
        }
    }

    fn stands(&self, what: &str, spot: Spot) -> String {
        format!("{what} is {}.", self.spot(spot))
    }

    fn coordinates(&self, (x, y): Place) -> String {
        format!("column {x}, row {y}")
    }

    fn robot(&self, state: &State) -> String {
        let agent = &state.agent;
        let spot = self.spot(spot(state, (agent.x, agent.y)));
        format!("The robot is {spot}, facing {}.", agent.direction)
    }

    fn world(&self, state: &State) -> String {
        let mut words = self.robot(state);
        let rooms: Vec<String> = state.rooms.iter().map(|r| r.color.name().to_owned()).collect();
        words.push_str(&format!(" Rooms: {}.", self.list(&rooms)));
        for object in &state.objects {
            let spot = self.spot(spot(state, (object.x, object.y)));
            words.push_str(&format!(" A {} {spot}.", self.object(object)));
        }
        words
    }

    fn moved_robot(&self, _state: &State, to: Spot) -> String {
        format!("The robot is now {}.", self.spot(to))
    }

    fn turned_robot(&self, state: &State) -> String {
        format!("The robot faces {}.", state.agent.direction)
    }

    fn moved_object(&self, object: &Object, to: Spot) -> String {
        format!("The {} is now {}.", self.object(object), self.spot(to))
    }

    fn changed_door(&self, cell: Place, lock: Lock) -> String {
        let now = match lock {
            Lock::Unlocked => "open",
            Lock::Locked => "locked",
            Lock::Unknown => "untried",
        };
        format!("The door at {} is {now}.", self.coordinates(cell))
    }

    fn rebuilt(&self, state: &State) -> String {
        let State { rooms, doors, objects, .. } = state;
        format!("Rooms: {}, doors: {}, objects: {}.", rooms.len(), doors.len(), objects.len())
    }

    fn holds(&self, what: Option<&Object>) -> String {
        let what = what.map_or("robot".to_owned(), |object| self.object(object));
        format!("Holding the {what}. Arrow keys carry it, Enter puts it down, Escape lets it be.")
    }

    fn holds_corner(&self) -> String {
        "One corner is here. Arrow keys go to the opposite one, Enter paints the room.".to_owned()
    }

    fn robot_here(&self, state: &State) -> String {
        format!("the robot, facing {}", state.agent.direction)
    }
}

fn door_words(lock: Lock) -> &'static str {
    match lock {
        Lock::Unlocked => "a doorway",
        Lock::Locked => "a locked door",
        Lock::Unknown => "a door that nobody has tried",
    }
}
