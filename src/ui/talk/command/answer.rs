//! What the engine answered: while a command is typed, when it was sent, and for another reading.

use super::ask::{plan_again, question};
use super::state::CHOICES;
use super::study;
use crate::domain::State as World;
use crate::ui::page::document::Said;
use crate::ui::page::effect::Effect;
use crate::ui::page::shared::Shared;
use crate::ui::talk::past::lines;
use crate::ui::talk::state::State;
use crate::ui::talk::watch::playback::Playback;
use crate::ui::talk::watch::values;
use crate::ui::talk::why::messages::messages;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Answer, PlanText, Reading};
use std::rc::Rc;

/// What was typed has been read; it may have been sent meanwhile.
pub(crate) fn was_read(state: &mut State, shared: &Shared, answer: Answer) {
    let said = shared.document.said.as_ref();
    let is_said = said.is_some_and(|said| said.answer.command == answer.command);
    if answer.command == state.command.input && !is_said {
        state.command.live = Some(Rc::new(answer));
        state.command.link = None;
    }
}

/// A command has been answered that was said in this world.
pub(crate) fn answered(state: &mut State, shared: &mut Shared, mut answer: Answer, world: World) {
    state.settle(shared);
    let plan = answer.plan.take().map(Rc::new);
    shared.record();
    state.command.forget();
    let answer = Rc::new(answer);
    shared.document.said = Some(Said { world: Rc::new(world), answer, chosen: 0, plan });
    // What was in sight when it was sent may have made room for the answer.
    if !state.resume.is_quiet {
        shared.want(Effect::Reveal("scene"));
    }
    if question(state, shared).is_some() && is_taught(shared) {
        plan_again(state, shared);
    } else {
        planned(state, shared);
    }
    // What a session comes back with was said before.
    lines::note(state, shared, !state.resume.is_quiet);
    study::look_closer(state, shared);
}

/// Whether what was said is a lesson that was learned: what it means was told then.
fn is_taught(shared: &Shared) -> bool {
    let said = shared.document.said.as_ref().map(|said| said.answer.command.trim());
    let mut lessons = shared.document.lessons.iter().filter(|taught| taught.understood);
    lessons.any(|taught| said == Some(&*taught.lesson.command))
}

/// There is a plan for another reading.
pub(crate) fn replanned(state: &mut State, shared: &mut Shared, plan: PlanText) {
    if let Some(said) = &mut shared.document.said {
        said.plan = Some(Rc::new(plan));
        planned(state, shared);
        lines::note(state, shared, false);
    }
}

/// Plays the plan that has come, or says why there is none.
fn planned(state: &mut State, shared: &mut Shared) {
    play(state, shared);
    values::look(state, shared);
    let text = Text::of(shared.language);
    let mut words: Vec<String> = messages(state, shared)
        .iter()
        .map(|message| format!("{} {}", message.what, message.fix).trim_end().to_owned())
        .collect();
    if let Some(asks) = question(state, shared) {
        words.extend(asked(text, shared, asks));
        shared.want(Effect::Focus(CHOICES[0]));
    } else if let Some(reading) = shared.document.reading() {
        if words.is_empty() || state.watch.playback.is_some() {
            words.push(text.understood(&reading.claim));
        }
        words.extend(state.watch.playback.iter().map(|plan| (text.has_steps)(plan.steps())));
    }
    shared.say(words.join(" "));
}

/// A question as it is read aloud.
fn asked(text: &Text, shared: &Shared, asks: &[usize]) -> Vec<String> {
    let readings = shared
        .document
        .said
        .iter()
        .flat_map(|said| asks.iter().filter_map(|&at| said.answer.readings.get(at)));
    let choice = |(number, reading): (usize, &Reading)| {
        format!("{number}: {}", text.phrases.sentence(&reading.claim))
    };
    let head = text.which(asks.len()).to_owned();
    std::iter::once(head).chain((1..).zip(readings).map(choice)).collect()
}

/// Begins to play the plan of the reading that is chosen, if there is one; the world goes on from its end.
fn play(state: &mut State, shared: &mut Shared) {
    let plan = shared.document.plan();
    let work = plan.and_then(|plan| plan.work.clone());
    let playback = plan.and_then(|plan| Playback::begin(plan));
    state.watch.end(work, shared.clock);
    state.watch.playback = playback;
    let Some(playback) = &mut state.watch.playback else { return };
    if let Some(last) = playback.last() {
        shared.document.world = last.clone();
        if state.resume.is_quiet {
            playback.seek(playback.steps());
        } else {
            shared.want(state.watch.tick());
        }
    }
}
