//! Questions are answered from the world and not by the parser's goals: what a question is about is read as a phrase of
//! a command of the same words (`query`), and looked up.

use super::query::Query;
use super::state::Reply;
use crate::domain::State as World;
use crate::ui::page::grammar::{capitalised, spot};
use crate::ui::page::place::Place;
use crate::ui::page::shared::Shared;
use crate::ui::talk::past::lines;
use crate::ui::talk::past::state::{Line, Outcome};
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Answer, Phrase, Referent, Refers, Request};

/// What a question is about that asks how many doors there are.
const DOORS: [&str; 3] = ["go to the door", "go to the doorway", "go to the entrance"];

/// Asks what the question is about, or answers at once where that is nothing.
pub(crate) fn ask(state: &mut State, shared: &mut Shared, query: Query, about: String) {
    state.settle(shared);
    state.command.forget();
    let text = Text::of(shared.language);
    let robot = shared.document.world.agent;
    match query {
        Query::World => {
            answer(state, shared, text.phrases.world(&shared.document.world), Vec::new())
        }
        Query::Can | Query::Else => {
            let words = if query == Query::Can { text.can_do } else { text.cannot_tell };
            answer(state, shared, words.to_owned(), Vec::new());
        }
        // A door is no thing that a command is about, but a place.
        Query::Count if DOORS.contains(&&*about) => {
            let doors = shared.document.world.doors.iter();
            let cells: Vec<Place> = doors.map(|d| (d.bounds.left, d.bounds.bottom)).collect();
            let names: Vec<_> = cells.iter().map(|&cell| text.phrases.coordinates(cell)).collect();
            let words = format!("{}: {}.", cells.len(), names.join("; "));
            answer(state, shared, words, cells)
        }
        Query::Where if about == "go to the robot" => {
            let words = text.phrases.robot(&shared.document.world);
            answer(state, shared, words, vec![(robot.x, robot.y)]);
        }
        _ => {
            state.command.query = Some((query, about.clone()));
            let world = shared.document.world.clone();
            shared.send(Request::Read { command: about, state: world }, true);
        }
    }
}

/// What a question is about has been read; whether it was.
pub(crate) fn was_read(state: &mut State, shared: &mut Shared, found: &Answer) -> bool {
    let Some((query, about)) = state.command.query.take() else { return false };
    if about != found.command {
        state.command.query = Some((query, about));
        return false;
    }
    let text = Text::of(shared.language);
    let world = shared.document.world.clone();
    let told = tell(text, &world, query, found);
    let (words, cells) = told.unwrap_or_else(|| (text.cannot_tell.to_owned(), Vec::new()));
    answer(state, shared, words, cells);
    true
}

fn answer(state: &mut State, shared: &mut Shared, words: String, cells: Vec<Place>) {
    let command = state.command.input.clone();
    let world = shared.document.world.clone();
    lines::push(state, Line { command, outcome: Outcome::Told, world });
    shared.say(words.clone());
    state.command.reply = Some(Reply { words, cells });
}

/// The answer, and the cells that it is about.
fn tell(text: &Text, world: &World, query: Query, found: &Answer) -> Option<(String, Vec<Place>)> {
    let phrases = text.phrases;
    let reading = found.readings.first()?;
    let is_thing = |phrase: &&Phrase| phrase.referents.iter().all(|r| r.class != "agent");
    let mut things = reading.phrases.iter().filter(is_thing);
    let phrase = things.next()?;
    let cells = |of: &[Referent]| of.iter().flat_map(|r| &r.cells).copied().collect::<Vec<_>>();
    let failed = |phrase: &Phrase| (phrases.failure(phrase), cells(&phrase.referents));
    let all = &phrase.referents;
    if query == Query::Count {
        let names: Vec<String> = all.iter().map(|r| phrases.referent(r)).collect();
        let words = match phrase.refers {
            Refers::None => phrases.failure(phrase),
            _ => format!("{}: {}.", names.len(), phrases.list(&names)),
        };
        return Some((words, cells(all)));
    }
    // All that a question of where or which may be about is told; any other is about one thing.
    let tells_all = matches!(query, Query::Where | Query::Name);
    if phrase.refers == Refers::None || !tells_all && phrase.refers != Refers::One {
        return Some(failed(phrase));
    }
    Some(match query {
        Query::Where => {
            let told = all.iter().filter_map(|one| {
                let cell = *one.cells.first()?;
                let what = capitalised(&phrases.referent(one));
                Some(match &*one.class {
                    "object" => phrases.stands(&what, spot(world, cell)),
                    _ => format!("{what}: {}.", phrases.coordinates(cell)),
                })
            });
            (told.collect::<Vec<_>>().join(" "), cells(all))
        }
        Query::Name => {
            let names: Vec<String> = all.iter().map(|one| phrases.referent(one)).collect();
            (format!("{}.", capitalised(&phrases.list(&names))), cells(all))
        }
        Query::Inside => {
            let inside = cells(all);
            let robot =
                inside.contains(&(world.agent.x, world.agent.y)).then(|| phrases.robot_here(world));
            let objects = world.objects.iter().filter(|o| inside.contains(&(o.x, o.y)));
            let names: Vec<String> = objects.map(|o| phrases.object(o)).chain(robot).collect();
            let what = all.first().map(|one| phrases.referent(one)).unwrap_or_default();
            (format!("{}: {}.", capitalised(&what), phrases.list(&names)), inside)
        }
        _ => {
            if let Some(other) = things.find(|phrase| phrase.refers != Refers::One) {
                return Some(failed(other));
            }
            let (robot, goal) = ((world.agent.x, world.agent.y), &reading.cells);
            let is_object = all.first().is_some_and(|one| one.class == "object");
            let moved = found.command.starts_with("put ") && is_object;
            let at = if moved { all.first()?.cells.first().copied()? } else { robot };
            let words = if goal.is_empty() { return None } else { text.yes_no };
            (words[usize::from(!goal.contains(&at))].to_owned(), vec![at])
        }
    })
}
