//! Talking: a command is read while it is typed, answered when it is sent, and may be meant in another way.

use super::action::{Action, Depth, Effect};
use super::document::Said;
use super::engine::Health;
use super::link::Link;
use super::room::Mode;
use super::state::State;
use super::{watch, why};
use crate::worker::protocol::{Answer, PlanText, Request, Study};
use std::rc::Rc;

/// Commands to try; what they name is in the first world.
pub const EXAMPLES: [&str; 4] = [
    "go to the blue room",
    "put the yellow block in the biggest room",
    "take the block to the green room",
    "walk next to the block",
];

/// Characters that a command may have; the engine says so of those with too many words.
pub const MOST_CHARACTERS: usize = 1_000;

/// The talking side of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Talk {
    /// What stands in the command box.
    pub input: String,
    /// What it would mean, while it is typed.
    pub live: Option<Rc<Answer>>,
    /// Why the last command was not answered at all.
    pub notice: Option<String>,
    /// The words that are pointed at.
    pub link: Option<Link>,
    /// The reading whose goal cells are to be seen.
    pub preview: Option<usize>,
    /// What the readings' scores are made of, and how their meanings came about.
    pub studies: Option<Rc<Vec<Study>>>,
    /// Whether all readings are shown, or the first few.
    pub all_readings: bool,
    /// The constituent that is studied.
    pub node: Option<usize>,
    /// How many steps of its reduction are shown.
    pub steps: usize,
}

impl Talk {
    /// Only what stands in the box is kept: all else is of another command now.
    fn forget(&mut self) {
        let Talk { input, .. } = std::mem::take(self);
        self.input = input;
    }
}

/// What is said, and about it.
pub(super) fn act(state: &mut State, action: Action, effects: &mut Vec<Effect>) {
    match action {
        Action::Typed(command) => {
            state.talk.input = command.chars().take(MOST_CHARACTERS).collect();
            read(state, effects);
        }
        Action::Ask => ask(state, effects),
        Action::AskExample(command) => {
            state.talk.input = command;
            ask(state, effects);
        }
        Action::Choose(reading) => choose(state, reading, effects),
        Action::Link(link) => state.talk.link = link,
        Action::AllReadings => state.talk.all_readings = true,
        Action::Preview(reading) => state.talk.preview = reading,
        Action::ChooseNode(node) => (state.talk.node, state.talk.steps) = (Some(node), 0),
        Action::Reduce(steps) => state.talk.steps = steps,
        Action::Help(help) => why::help(state, help, effects),
        Action::SetRules(rules) if rules != state.document.rules => {
            state.record();
            state.document.rules = rules;
            plan_again(state, effects);
        }
        _ => {}
    }
}

/// Reads what stands in the box, without planning: what is typed is understood at once.
pub(super) fn read(state: &mut State, effects: &mut Vec<Effect>) {
    let is_read = |request: &Request| matches!(request, Request::Read { .. });
    state.talker.retain(|request| !is_read(request));
    let command = state.talk.input.clone();
    let said = state.document.said.as_ref();
    if command.trim().is_empty() || said.is_some_and(|said| said.answer.command == command) {
        state.talk.live = None;
    } else if state.document.model.is_some() && state.talker.health == Health::Ready {
        let world = state.shown().clone();
        state.talker.send(Request::Read { command, state: world }, true, effects);
    }
}

/// Sends the command in the box.
pub(super) fn ask(state: &mut State, effects: &mut Vec<Effect>) {
    if !state.can_ask() {
        return;
    }
    state.settle();
    state.room.mode = Mode::Watch;
    state.talk.forget();
    let command = state.talk.input.clone();
    request(state, |world, rules| Request::Ask { command, state: world, rules }, effects);
}

/// Means the last command in another of its ways.
fn choose(state: &mut State, reading: usize, effects: &mut Vec<Effect>) {
    let Some(said) = &state.document.said else { return };
    if said.chosen == reading && said.plan.is_some() || said.answer.readings.get(reading).is_none()
    {
        return;
    }
    state.settle();
    state.record();
    if let Some(said) = &mut state.document.said {
        said.chosen = reading;
        said.plan = None;
    }
    (state.talk.node, state.talk.preview, state.talk.link) = (None, None, None);
    plan_again(state, effects);
}

/// Plans anew for the reading that is chosen, from the world that the command was said in.
pub(super) fn plan_again(state: &mut State, effects: &mut Vec<Effect>) {
    state.watch.playback = None;
    let Some(said) = &state.document.said else { return };
    let Some(reading) = said.answer.readings.get(said.chosen) else { return };
    let form = reading.form.clone();
    state.document.world = (*said.world).clone();
    request(state, |world, rules| Request::Plan { form, state: world, rules }, effects);
}

fn request(
    state: &mut State,
    make: impl FnOnce(crate::domain::State, crate::worker::protocol::WorldRules) -> Request,
    effects: &mut Vec<Effect>,
) {
    // What waits is about the plan before.
    state.talker.retain(|request| matches!(request, Request::OpenModel { .. }));
    state.watch.begin(state.clock);
    let request = make(state.document.world.clone(), state.document.rules);
    state.talker.send(request, true, effects);
}

/// What was typed has been read; it may have been sent meanwhile.
pub(super) fn was_read(state: &mut State, answer: Answer) {
    let said = state.document.said.as_ref();
    let is_said = said.is_some_and(|said| said.answer.command == answer.command);
    if answer.command == state.talk.input && !is_said {
        state.talk.live = Some(Rc::new(answer));
        state.talk.link = None;
    }
}

/// A command has been answered.
pub(super) fn answered(
    state: &mut State,
    mut answer: Answer,
    world: crate::domain::State,
    effects: &mut Vec<Effect>,
) {
    state.settle();
    let plan = answer.plan.take().map(Rc::new);
    state.record();
    state.talk.forget();
    let answer = Rc::new(answer);
    state.document.said = Some(Said { world: Rc::new(world), answer, chosen: 0, plan });
    planned(state, effects);
    study(state, effects);
    let wanted = state.resume.form.take();
    let readings = state.document.said.iter().flat_map(|said| said.answer.readings.iter());
    let place = wanted.and_then(|form| readings.clone().position(|reading| reading.form == form));
    if let Some(place) = place.filter(|&place| place > 0) {
        choose(state, place, effects);
    }
}

/// There is a plan for another reading.
pub(super) fn replanned(state: &mut State, plan: PlanText, effects: &mut Vec<Effect>) {
    if let Some(said) = &mut state.document.said {
        said.plan = Some(Rc::new(plan));
        planned(state, effects);
    }
}

/// Plays the plan that has come, or says why there is none.
fn planned(state: &mut State, effects: &mut Vec<Effect>) {
    let work = state.document.plan().and_then(|plan| plan.work.clone());
    state.watch.end(work, state.clock);
    watch::play(state, effects);
    let text = state.text();
    let messages = why::messages(state);
    let words = match (messages.first(), &state.watch.playback, state.document.reading()) {
        (Some(message), ..) => format!("{} {}", message.what, message.fix),
        (None, Some(plan), Some(reading)) => {
            format!("{} {}", text.understood(&reading.claim), (text.has_steps)(plan.steps()))
        }
        (None, _, Some(reading)) => text.understood(&reading.claim),
        (None, ..) => String::new(),
    };
    state.say(words);
}

/// Asks what the scores are made of, if that is to be seen and not known.
pub(super) fn study(state: &mut State, effects: &mut Vec<Effect>) {
    if state.depth < Depth::Study || state.talk.studies.is_some() {
        return;
    }
    if let Some(said) = &state.document.said {
        let command = said.answer.command.clone();
        state.talker.retain(|request| !matches!(request, Request::Explain { .. }));
        state.talker.send(Request::Explain { command }, false, effects);
    }
}
