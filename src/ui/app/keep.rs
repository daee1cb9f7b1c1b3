//! The session of this tab on this machine: it comes back when the page opens, and is kept whenever it has changed.
//! It is what a file holds, and what nobody else is sent besides.

use super::action::Action;
use super::state::State;
use crate::ui::page::document::Document;
use crate::ui::page::effect::{Effect, Timer};
use crate::ui::page::history::History;
use crate::ui::page::keep::ask::{self, Ask, Place};
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::keep::state::{Keep, OWN, Origin, SESSION, Stage, short};
use crate::ui::page::news::News;
use crate::ui::page::shared::Shared;
use crate::ui::page::words::Text;
use crate::ui::page::{document, model};
use crate::ui::talk;
use crate::ui::talk::share::also::Also;
use crate::ui::talk::share::exchange::is_settled;
use crate::ui::talk::share::session::Session;

/// Milliseconds from a change to when it is kept: what changes meanwhile is kept with it.
const WAIT_MS: u32 = 700;
/// The session that was kept when the page was begun anew before it had come back.
const BEFORE: &str = "before";

/// The store said something.
pub(super) fn heard(state: &mut State, news: ask::News) {
    let State { shared, .. } = state;
    match news {
        ask::News::Open => {
            (shared.keep.stage, shared.keep.fault) = (Stage::Reading, None);
            claim(shared, false);
        }
        ask::News::Claimed(ours) => claimed(shared, ours),
        ask::News::Read(place, found) => read(state, place, found),
        ask::News::Written if shared.keep.fault == Some(Fault::Full) => shared.keep.fault = None,
        ask::News::Written => {}
        ask::News::Failed(place, fault) => failed(state, place, fault),
    }
}

/// Claims this tab's session.
fn claim(shared: &mut Shared, steal: bool) {
    let name = shared.keep.place().name;
    shared.want(Effect::Keep(Ask::Claim { name, steal }));
}

/// Whether this tab may keep its session is known.
fn claimed(shared: &mut Shared, ours: bool) {
    let keep = &mut shared.keep;
    keep.fault = (!ours).then_some(Fault::Elsewhere);
    if keep.stage == Stage::Reading {
        shared.want(Effect::Keep(Ask::Read(Place::new(SESSION, OWN))));
    } else {
        keep.stage = if ours { Stage::Keeping } else { Stage::Watching };
        keep.last.clear();
    }
}

/// What was kept of a session has been read.
fn read(state: &mut State, place: Place, found: Option<(Result<Vec<u8>, String>, bool)>) {
    let keep = &mut state.shared.keep;
    if keep.stage == Stage::Reading && keep.link.is_some() && place.name == OWN {
        let packed = found.as_ref().and_then(|(packed, _)| packed.as_deref().ok());
        let session = packed.and_then(Session::unpack);
        let also = session.and_then(|session| Also::unpack(&session.also?));
        let made = also.and_then(|also| also.made);
        if made != keep.link {
            // The link is another's: it is opened beside one's own session.
            keep.origin = found.is_some().then_some(Origin::Link);
            let place = keep.place();
            return state.shared.want(Effect::Keep(Ask::Read(place)));
        }
        keep.link = None;
        claim(&mut state.shared, false);
    }
    let is_first = state.shared.keep.stage == Stage::Reading;
    if is_first {
        let ours = state.shared.keep.fault != Some(Fault::Elsewhere);
        state.shared.keep.stage = if ours { Stage::Keeping } else { Stage::Watching };
    }
    let Some((packed, was_damaged)) = found else { return };
    if is_first && state.shared.keep.link.is_none() && state.talk.is_begun(&state.shared) {
        state.shared.keep.origin = Some(Origin::New);
        return put_aside(&mut state.shared);
    }
    talk::update::update(&mut state.talk, &mut state.shared, talk::Action::Open(packed));
    if is_first {
        // Before that there was nothing to go back to.
        state.shared.history = History::new();
    }
    let keep = &mut state.shared.keep;
    keep.origin = Some(match (&keep.link, was_damaged) {
        (Some(_), _) => Origin::Left,
        (None, true) => Origin::Before,
        (None, false) => Origin::Last,
    });
}

/// Something went wrong with the store.
fn failed(state: &mut State, place: Option<Place>, fault: Fault) {
    let keep = &mut state.shared.keep;
    if matches!(fault, Fault::None | Fault::Newer)
        || place.is_none() && keep.stage != Stage::Keeping
    {
        keep.stage = Stage::Closed;
    }
    if fault == Fault::Elsewhere {
        keep.stage = Stage::Watching;
    }
    let goes_on = keep.stage == Stage::Reading;
    // What was kept last is not known: it is tried again with the next change.
    keep.last.clear();
    // A tab that may not keep the session says so first of all.
    if !goes_on || keep.fault != Some(Fault::Elsewhere) {
        keep.fault = Some(fault.clone());
    }
    state.shared.say((Text::of(state.shared.language).fault)(&fault));
    if goes_on && let Some(place) = place {
        read(state, place, None);
    }
}

/// How an action may change the session.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// In no way.
    None,
    /// As what came of what a person did.
    Follows,
    /// As what a person did: from then on there is something to keep.
    Begins,
}

/// How an action may change the session.
pub(super) const fn change(action: &Action) -> Change {
    use talk::Action::{Demo, Link, Open, Preview, Shared, Touched};
    match action {
        Action::Talk(Link(_) | Preview(_) | Demo | Touched) => Change::None,
        Action::Talk(Open(_) | Shared(_)) | Action::Heard(..) => Change::Follows,
        Action::Talk(_) | Action::Deepen(_) | Action::Speak(_) | Action::Given(_) => Change::Begins,
        Action::Undo | Action::Redo | Action::Afresh => Change::Begins,
        Action::Bench(News::Use { .. } | News::Give(_)) => Change::Begins,
        _ => Change::None,
    }
}

/// Something has happened: what has changed of the session is kept soon, once there is something to keep.
pub(super) fn look(shared: &mut Shared, change: Change) {
    shared.keep.is_begun |= change == Change::Begins;
    let may = shared.keep.is_begun && shared.keep.stage == Stage::Keeping;
    if change != Change::None && may && !shared.keep.is_waiting {
        shared.keep.is_waiting = true;
        shared.want(Effect::StartTimer(Timer::Keep, WAIT_MS));
    }
}

/// Keeps the session, if it has changed.
pub(super) fn keep(state: &mut State) {
    state.shared.keep.is_waiting = false;
    let Keep { stage, is_begun, .. } = state.shared.keep;
    // What waits for a model is not in the document yet.
    if stage != Stage::Keeping || !is_begun || !is_settled(&state.talk, &state.shared) {
        return;
    }
    let packed = packed(state);
    let shared = &mut state.shared;
    if shared.keep.last != packed {
        let place = shared.keep.place();
        shared.keep.last.clone_from(&packed);
        shared.want(Effect::Keep(Ask::Write(place, packed)));
    }
}

/// The session as it is kept.
fn packed(state: &State) -> Vec<u8> {
    let State { shared, talk, .. } = state;
    let Document { preset, origin, draft, .. } = &shared.document;
    let also = Also {
        preset: *preset,
        origin: (**origin).clone(),
        draft: draft.clone(),
        lesson: talk.teach.words.clone(),
        input: talk.command.input.clone(),
        lines: talk.past.lines.clone(),
        language: shared.language.code().to_owned(),
        made: shared.keep.made.clone(),
        trained: shared.document.base.as_ref().and_then(|base| match &base.origin {
            document::Origin::Trained(corpus) => Some(corpus.clone()),
            _ => None,
        }),
    };
    let session = Session { also: Some(also.pack()), ..Session::of(shared, true) };
    session.pack()
}

/// Begins afresh: as a page that was never opened, but for what undo brings back.
pub(super) fn afresh(state: &mut State) {
    let State { shared, talk, .. } = state;
    talk.settle(shared);
    shared.record();
    let shipped = |model: &document::Model| model.origin == document::Origin::Shipped;
    let base = shared.document.base.take().filter(shipped);
    shared.document = Document { base: base.clone(), ..Document::new() };
    shared.keep =
        Keep { stage: shared.keep.stage, link: shared.keep.link.take(), ..Keep::default() };
    *talk = talk::State::new();
    match base {
        Some(base) => model::go_on_with(shared, base),
        None => model::fetch(shared),
    }
    shared.say(Text::of(shared.language).begun_afresh);
}

/// Goes back to one's own session from a link's, or to the one before this.
pub(super) fn go_back(state: &mut State) {
    keep(state);
    let keep = &mut state.shared.keep;
    let name = if keep.origin == Some(Origin::New) { BEFORE } else { OWN };
    let was_linked = keep.link.take().is_some();
    keep.origin = None;
    if was_linked {
        claim(&mut state.shared, false);
    }
    state.shared.want(Effect::Keep(Ask::Read(Place::new(SESSION, name))));
}

/// A link was opened, which is being unpacked: it has a session of its own.
pub(super) fn linked(state: &mut State, link: &str) {
    if state.shared.keep.stage >= Stage::Watching {
        keep(state);
        state.shared.keep.stage = Stage::Reading;
        state.shared.keep.link = Some(short(link));
        claim(&mut state.shared, false);
    }
    state.shared.keep.link = Some(short(link));
}

/// Puts aside what is kept of the session, since another is to take its place.
pub(super) fn put_aside(shared: &mut Shared) {
    let (from, to) = (shared.keep.place(), Place::new(SESSION, BEFORE));
    shared.want(Effect::Keep(Ask::Copy(from, to)));
}

/// This tab keeps the session from now on.
pub(super) fn keep_here(shared: &mut Shared) {
    put_aside(shared);
    claim(shared, true);
}
