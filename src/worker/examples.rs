//! A command to try in a world: candidates are made from what there is in it, and the first is taken that is read as it
//! is meant, in one way, and that the planner can do there. One kind is there to be taught: a word nobody knows.

use super::ask::answer;
use super::plan::{Begun, Planning};
use super::protocol::{Event, Fate, PlanText, Wanted, WorldRules};
use super::read::parsed;
use crate::ccg::Model;
use crate::domain::{Object, Room, State};
use crate::logic::print;
use std::collections::VecDeque;

/// An example is done in so many steps at most.
const MOST_STEPS: usize = 60;

/// So many steps of the planner, and it is no example.
const PATIENCE: u32 = 60;

/// Words that hardly a model knows.
const UNKNOWN: [&str; 3] = ["dungeon", "lair", "quay"];

/// Looks for an example.
pub(super) struct Looking {
    wanted: Wanted,
    state: State,
    rules: WorldRules,
    left: VecDeque<String>,
    planning: Option<(String, Box<Planning>, u32)>,
}

impl Looking {
    pub(super) fn new(wanted: Wanted, state: State, rules: WorldRules) -> Looking {
        let left = candidates(&wanted, &state).into();
        Looking { wanted, state, rules, left, planning: None }
    }

    /// Reads a candidate, or plans on for it; what was found, in the end.
    pub(super) fn step(&mut self, model: &mut Model) -> Option<Event> {
        if let Some((command, mut planning, steps)) = self.planning.take() {
            match planning.step() {
                Some(plan) if self.shows(&plan) => return Some(self.found(Some(command))),
                None if steps < PATIENCE => self.planning = Some((command, planning, steps + 1)),
                _ => {}
            }
            return None;
        }
        let Some(command) = self.left.pop_front() else { return Some(self.found(None)) };
        let parse = parsed(model, &command);
        let answer = answer(model, &parse, &command, &self.state);
        if self.wanted == Wanted::Unknown {
            let is_unknown = answer.words.iter().any(|word| word.fate == Fate::Unknown);
            return is_unknown.then(|| self.found(Some(command)));
        }
        let is_read = answer.reason.is_none()
            && answer.asks.is_empty()
            && answer.words.iter().all(|word| matches!(word.fate, Fate::Meant | Fate::Empty));
        let best = parse.answer().filter(|_| is_read)?;
        let form = print(&model.grammar.terms, best.form);
        match Planning::begin(&form, std::slice::from_ref(&self.state), &self.rules, false).ok()? {
            Begun::Work(planning) => self.planning = Some((command, planning, 0)),
            Begun::Done(plan) => return self.shows(&plan).then(|| self.found(Some(command))),
        }
        None
    }

    /// Whether a plan is worth to be seen; that a room has something that cannot be done is, too.
    fn shows(&self, plan: &PlanText) -> bool {
        let is_barred = plan.reason.as_deref() == Some("unreachable");
        plan.reached && (2..=MOST_STEPS).contains(&plan.actions.len())
            || is_barred && matches!(self.wanted, Wanted::Said(_))
    }

    fn found(&self, command: Option<String>) -> Event {
        Event::Example { wanted: self.wanted.clone(), command }
    }
}

/// Commands of a kind that may do in a world, the best first.
fn candidates(wanted: &Wanted, state: &State) -> Vec<String> {
    let State { agent, rooms, objects, .. } = state;
    let within = |room: &&Room, x, y| room.bounds.strictly_inside(x, y);
    let rooms: Vec<&Room> = rooms
        .iter()
        .filter(|one| rooms.iter().filter(|other| other.color == one.color).count() == 1)
        .collect();
    let objects: Vec<(&Object, String)> = objects
        .iter()
        .filter(|one| objects.iter().filter(|other| look(other) == look(one)).count() == 1)
        .map(|one| (one, look(one)))
        .collect();
    match wanted {
        Wanted::Said(command) => vec![command.clone()],
        Wanted::Go => {
            let others = rooms.iter().filter(|room| !within(room, agent.x, agent.y));
            others.map(|room| format!("go to the {} room", room.color)).collect()
        }
        Wanted::Bring => {
            let all = objects.iter().rev().flat_map(|(object, look)| {
                let others = rooms.iter().filter(|room| !within(room, object.x, object.y));
                others.map(move |room| format!("take the {look} to the {} room", room.color))
            });
            all.collect()
        }
        Wanted::Describe => {
            let biggest =
                objects.iter().map(|(_, look)| format!("put the {look} in the biggest room"));
            let with = objects
                .iter()
                .map(|(object, _)| format!("go to the room with the {}", object.shape));
            with.chain(biggest).chain(["go to the smallest room".to_owned()]).collect()
        }
        Wanted::Beside => {
            let pairs = objects.iter().zip(objects.iter().skip(1));
            let pairs =
                pairs.map(|((_, one), (_, other))| format!("put the {one} next to the {other}"));
            pairs
                .chain(objects.iter().map(|(_, look)| format!("walk next to the {look}")))
                .collect()
        }
        Wanted::Unknown => UNKNOWN.map(|word| format!("go to the {word}")).into(),
    }
}

/// What an object is called.
fn look(object: &Object) -> String {
    format!("{} {}", object.color, object.shape)
}
