//! What is shown and said becomes a lesson. The model is always the one before any lesson, taught all of them in
//! their order: the same lessons give the same model, whichever way one came to them.

use super::state::{Missing, Offer, Teach};
use super::trail::driving;
use crate::domain::straight::passed;
use crate::domain::{letters, read_letters, straight};
use crate::ui::page::document::{Draft, Model, Said, Taught};
use crate::ui::page::effect::Effect;
use crate::ui::page::model;
use crate::ui::page::shared::Shared;
use crate::ui::page::way::states;
use crate::ui::talk::command::state::MOST_CHARACTERS;
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{
    Fit, Lesson, Meaning, PairText, Refusal, Request, RunText, TeachReport,
};
use serde::Serialize;
use std::rc::Rc;

/// Whether it is being taught.
pub fn is_teaching(shared: &Shared) -> bool {
    shared.learner.is_at(|request| matches!(request, Request::Teach { .. }))
}

/// The words of the lesson are these now.
pub(crate) fn typed(state: &mut State, words: &str) {
    state.teach.words = words.chars().take(MOST_CHARACTERS).collect();
    state.teach.missing = None;
}

/// Begins the demonstration anew.
pub(crate) fn clear_draft(state: &mut State, shared: &mut Shared) {
    if shared.document.draft.as_ref().is_some_and(is_begun) {
        shared.record();
        shared.document.draft = None;
        let phrases = Text::of(shared.language).phrases;
        shared.say(phrases.robot(state.shown(shared)));
        look(state, shared);
    }
}

/// Whether there is something to begin anew.
pub fn is_begun(draft: &Draft) -> bool {
    draft.shows() || !draft.contrasts.is_empty()
}

/// Looks what the page would have done in place of the way that is driven.
pub(crate) fn look(state: &mut State, shared: &Shared) {
    state.teach.straight = shared.document.draft.as_ref().and_then(|draft| {
        let driven = read_letters(draft.way.as_ref()?).ok()?;
        let other = letters(&straight(&draft.before, &driven)?);
        // One way through these rooms that is not meant is enough.
        let rooms = |way: &String| passed(&states(&draft.before, way), None);
        let is_new = draft.contrasts.iter().all(|known| rooms(known) != rooms(&other));
        is_new.then_some(other)
    });
}

/// Teaches what is shown and said, or says what is missing.
pub(crate) fn teach(state: &mut State, shared: &mut Shared) {
    let draft = shared.document.draft.as_ref().filter(|draft| draft.shows());
    state.teach.missing = match draft {
        None => Some(Missing::Demonstration),
        Some(draft) if draft.way.is_none() && !draft.contrasts.is_empty() => Some(Missing::Way),
        Some(_) if state.teach.words.trim().is_empty() => Some(Missing::Words),
        Some(_) => None,
    };
    if let Some(missing) = state.teach.missing {
        return shared.say(Text::of(shared.language).missing(missing));
    }
    let Some(draft) = draft else { return };
    let lesson = draft.lesson(state.teach.words.trim().to_owned());
    learn_besides(state, shared, lesson);
}

/// Teaches the reading of a lesson that the person chose, by its place among those offered.
pub(crate) fn mean(state: &mut State, shared: &mut Shared, place: usize) {
    let Some(Offer { lesson, fits }) = &state.teach.offer else { return };
    let Some(Fit { form, .. }) = fits.get(place) else { return };
    let lesson = Lesson { means: Some(Meaning::Form(form.clone())), ..lesson.clone() };
    learn_besides(state, shared, lesson);
}

/// Says why a lesson in other words is none.
pub(crate) fn refuse(state: &mut State, shared: &mut Shared, command: &str, refusal: &Refusal) {
    let words = (Text::of(shared.language).refused)(command, refusal);
    shared.say(words.clone());
    state.teach.drop_last();
    state.teach.notice = Some(words);
}

/// Teaches a lesson besides those there are; a meaning that was given takes the place of one given before.
pub(crate) fn learn_besides(state: &mut State, shared: &mut Shared, lesson: Lesson) {
    let mut all = shared.document.taught();
    if lesson.means.is_some() {
        all.retain(|known| known.means.is_none() || known.command != lesson.command);
    }
    all.push(lesson);
    learn(state, shared, all);
}

/// The command that the person answered a question about, as a lesson: from where it was said to where its plan ends.
/// Nothing where the plan changes nothing, or that was learned already.
pub fn answered(shared: &Shared) -> Option<Lesson> {
    let was_chosen = |said: &&Said| said.chosen > 0 || !said.answer.asks.is_empty();
    let said = shared.document.said.as_ref().filter(was_chosen)?;
    let form = said.answer.readings.get(said.chosen)?.form.clone();
    let plan = said.plan.as_ref().filter(|plan| plan.reached && !plan.actions.is_empty())?;
    let mut draft = Draft::new((*said.world).clone());
    // What a task over time means no pair shows.
    let way = if plan.done.is_empty() { None } else { Some(driving(&plan.states)?) };
    draft.show(plan.states.last()?.clone(), way.as_deref());
    let lesson = draft.lesson(said.answer.command.trim().to_owned());
    let lesson = Lesson { means: Some(Meaning::Form(form)), ..lesson };
    let mut lessons = shared.document.lessons.iter();
    let is_same = |known: &Taught| {
        known.lesson.command == lesson.command && known.lesson.means == lesson.means
    };
    lessons.all(|known| !is_same(known)).then_some(lesson)
}

/// Keeps that as a lesson.
pub(crate) fn remember(state: &mut State, shared: &mut Shared) {
    if let Some(lesson) = answered(shared) {
        learn_besides(state, shared, lesson);
    }
}

/// Forgets the lesson at a place.
pub(crate) fn unteach(state: &mut State, shared: &mut Shared, place: usize) {
    let mut lessons = shared.document.taught();
    if place < lessons.len() {
        lessons.remove(place);
        learn(state, shared, lessons);
    }
}

/// Teaches what was taught before again, to another model.
pub(crate) fn learn_again(state: &mut State, shared: &mut Shared) {
    let lessons = shared.document.taught();
    learn(state, shared, lessons);
}

/// Teaches the model before any lesson exactly these.
pub(crate) fn learn(state: &mut State, shared: &mut Shared, lessons: Vec<Lesson>) {
    let Some(base) = &shared.document.base else { return };
    state.teach.drop_last();
    if lessons.is_empty() {
        let base = base.clone();
        shared.record();
        shared.document.lessons = Rc::new(Vec::new());
        return model::go_on_with(shared, base);
    }
    let model = base.report.model.clone();
    shared.learner.retain(|request| !matches!(request, Request::Teach { .. }));
    shared.send(Request::Teach { model, examples: lessons }, true);
}

/// The model was taught.
pub(crate) fn taught(
    state: &mut State,
    shared: &mut Shared,
    lessons: Vec<Lesson>,
    report: TeachReport,
) {
    let Some(base) = &shared.document.base else { return };
    let Some(newest) = lessons.last().cloned() else { return };
    let is_new = shared.document.lessons.iter().all(|known| known.lesson != newest);
    let understood = report.understood.last().copied().unwrap_or(false);
    let last = newest.command.clone();
    let text = Text::of(shared.language);
    let fits = report.check.as_ref().map_or(&[][..], |check| &check.fits);
    if is_new && (!understood || !fits.is_empty()) {
        let words = match &report.refusal {
            Some(refusal) => (text.refused)(&last, refusal),
            None if fits.is_empty() => (text.not_learned)(&last),
            None => text.otherwise.to_owned(),
        };
        shared.say(words.clone());
        state.teach.notice = Some(words);
        let fits = fits.to_vec();
        state.teach.offer = (!fits.is_empty()).then_some(Offer { lesson: newest, fits });
        return;
    }
    let model = Model { report: Rc::new(report.model.clone()), origin: base.origin.clone() };
    shared.record();
    let all =
        lessons.into_iter().zip(report.understood.iter().copied().chain(std::iter::repeat(false)));
    let all = all.map(|(lesson, understood)| Taught { lesson, understood });
    shared.document.lessons = Rc::new(all.collect());
    if is_new && state.resume.command.is_none() {
        // The world is as it was before the demonstration: the command can be tried at once.
        shared.document.draft = None;
        state.room.mode = Mode::Watch;
        state.command.input.clone_from(&last);
        state.teach =
            Teach { report: Some(Rc::new(report)), taught: Some(newest), ..Teach::default() };
        shared.say(text.learned);
    }
    model::go_on_with(shared, model);
}

/// Teaching was refused, for a reason: the person can mend the lesson.
pub(crate) fn refused(state: &mut State, message: String) {
    state.teach.notice = Some(message);
    state.room.mode = Mode::Teach;
}

/// A row of a corpus in JSON lines.
#[derive(Serialize)]
struct Row<'a> {
    id: String,
    command: &'a str,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pairs: &'a [PairText],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    runs: &'a [RunText],
}

/// Saves the lessons as a corpus.
pub(crate) fn save(shared: &mut Shared) {
    let lessons = shared.document.taught();
    // Every part has such a form.
    shared.want(Effect::SaveLessons(postcard::to_allocvec(&lessons).unwrap_or_default()));
}

/// Lessons, packed, as a corpus that the page and the command line open: those that were shown.
pub fn corpus(packed: &[u8]) -> String {
    let lessons: Vec<Lesson> = postcard::from_bytes(packed).unwrap_or_default();
    let row = |(place, Lesson { command, pairs, runs, .. }): (usize, &Lesson)| {
        let row = Row { id: format!("taught-{}", place + 1), command, pairs, runs };
        // Strings and numbers only: JSON can hold them all.
        serde_json::to_string(&row).map(|row| row + "\n").unwrap_or_default()
    };
    let is_shown = |lesson: &&Lesson| !lesson.pairs.is_empty() || !lesson.runs.is_empty();
    lessons.iter().filter(is_shown).enumerate().map(row).collect()
}
