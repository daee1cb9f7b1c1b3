//! Teaching: what is shown and said becomes a lesson. The model is always the one before any lesson, taught all of
//! them in their order: the same lessons give the same model, whichever way one came to them.

use super::action::{Action, Effect};
use super::document::{Draft, Taught};
use super::room::Mode;
use super::state::State;
use super::{model, talk};
use crate::worker::protocol::{Lesson, Request, TeachReport};
use serde::Serialize;
use std::rc::Rc;

/// The teaching side of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Teach {
    /// The words of the lesson in preparation.
    pub words: String,
    /// What the last lesson added.
    pub report: Option<Rc<TeachReport>>,
    /// The command that was taught last.
    pub taught: Option<String>,
    /// Why the last lesson was not learned.
    pub notice: Option<String>,
    /// What the lesson lacks, once it was to be taught without.
    pub missing: Option<Missing>,
}

/// What a lesson still lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// Nothing is shown.
    Demonstration,
    /// Nothing is said.
    Words,
}

/// What is taught.
pub(super) fn act(state: &mut State, action: Action, effects: &mut Vec<Effect>) {
    match action {
        Action::TypedLesson(words) => say(state, words),
        Action::Teach => teach(state, effects),
        Action::ClearDraft if state.document.draft.as_ref().is_some_and(Draft::shows) => {
            state.record();
            state.document.draft = None;
            let words = state.text().robot(state.shown());
            state.say(words);
        }
        Action::Unteach(place) if place < state.document.lessons.len() => {
            let mut lessons = state.document.taught();
            lessons.remove(place);
            learn(state, lessons, effects);
        }
        Action::SaveLessons => {
            let text = rows(&state.document.lessons);
            effects.push(Effect::Save { name: "taught.jsonl".to_owned(), text });
        }
        _ => {}
    }
}

/// A row of a corpus in JSON lines.
#[derive(Serialize)]
struct Row<'a> {
    id: String,
    #[serde(flatten)]
    lesson: &'a Lesson,
}

/// Lessons as a corpus, which the page and the command line open.
fn rows(lessons: &[Taught]) -> String {
    let row = |(place, taught): (usize, &Taught)| {
        let row = Row { id: format!("taught-{}", place + 1), lesson: &taught.lesson };
        // Strings and numbers only: JSON can hold them all.
        serde_json::to_string(&row).map(|row| row + "\n").unwrap_or_default()
    };
    lessons.iter().enumerate().map(row).collect()
}

/// The room is for teaching now: the learner is made ready meanwhile.
pub(super) fn begin(state: &mut State, effects: &mut Vec<Effect>) {
    let before = state.document.world.clone();
    state.document.draft.get_or_insert_with(|| Draft::new(before));
    state.learner.wake(effects);
}

/// The words of the lesson are these now.
pub(super) fn say(state: &mut State, words: String) {
    state.teach.words = words.chars().take(talk::MOST_CHARACTERS).collect();
    state.teach.missing = None;
}

fn teach(state: &mut State, effects: &mut Vec<Effect>) {
    let draft = state.document.draft.as_ref().filter(|draft| draft.shows());
    state.teach.missing = match draft {
        None => Some(Missing::Demonstration),
        Some(_) if state.teach.words.trim().is_empty() => Some(Missing::Words),
        Some(_) => None,
    };
    if let Some(missing) = state.teach.missing {
        let words = state.text().missing(missing).to_owned();
        return state.say(words);
    }
    let Some(draft) = draft else { return };
    let mut all = state.document.taught();
    all.push(draft.lesson(state.teach.words.trim().to_owned()));
    learn(state, all, effects);
}

/// Teaches the model before any lesson exactly these.
pub(super) fn learn(state: &mut State, lessons: Vec<Lesson>, effects: &mut Vec<Effect>) {
    let Some(base) = &state.document.base else { return };
    (state.teach.notice, state.teach.report) = (None, None);
    if lessons.is_empty() {
        let base = base.clone();
        state.record();
        state.document.lessons = Rc::new(Vec::new());
        model::go_on_with(state, base, effects);
        return;
    }
    let model = base.report.model.clone();
    state.learner.retain(|request| !matches!(request, Request::Teach { .. }));
    state.learner.send(Request::Teach { model, examples: lessons }, true, effects);
}

/// The model was taught.
pub(super) fn taught(
    state: &mut State,
    lessons: Vec<Lesson>,
    report: TeachReport,
    effects: &mut Vec<Effect>,
) {
    let Some(base) = &state.document.base else { return };
    let is_new = lessons.len() > state.document.lessons.len();
    let understood = report.understood.last().copied().unwrap_or(false);
    let last = lessons.last().map(|lesson| lesson.command.clone()).unwrap_or_default();
    if is_new && !understood {
        let words = (state.text().not_learned)(&last);
        state.say(words.clone());
        state.teach.notice = Some(words);
        return;
    }
    let model = super::document::Model {
        report: Rc::new(report.model.clone()),
        origin: base.origin.clone(),
    };
    state.record();
    let all =
        lessons.into_iter().zip(report.understood.iter().copied().chain(std::iter::repeat(false)));
    let all = all.map(|(lesson, understood)| Taught { lesson, understood });
    state.document.lessons = Rc::new(all.collect());
    if is_new && state.resume.command.is_none() {
        // The world is as it was before the demonstration: the command can be tried at once.
        state.document.draft = None;
        state.room.mode = Mode::Watch;
        state.talk.input.clone_from(&last);
        state.teach =
            Teach { report: Some(Rc::new(report)), taught: Some(last), ..Teach::default() };
        let words = state.text().learned.to_owned();
        state.say(words);
    }
    model::go_on_with(state, model, effects);
}
