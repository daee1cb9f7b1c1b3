//! What is to be kept is: the parts' contents on their way to the store. A run at work is kept whenever its checkpoint is
//! new. What comes back is `returning`'s.

use super::data::pack;
use super::kept::action::Action;
use super::kept::ask::{Ask, News};
use super::kept::state::{Kind, Purpose, Stage};
use super::kept::words::Text;
use super::returning::{read, said, stamp};
use super::run::file;
use super::state::State;
use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::fault::Fault;
use crate::worker::protocol::Request;

/// Does what a person wants with what is kept, or hears what the store says.
pub(super) fn update(state: &mut State, action: Action) {
    let State { desk, data, kept, .. } = state;
    if !matches!(action, Action::Heard(_)) {
        kept.notice = None;
    }
    match action {
        Action::Name(name) => kept.name = name,
        Action::KeepCorpus => {
            if let Some(sheet) = &data.sheet {
                kept.waits = Some(named(&mut kept.name, sheet.pack()));
                desk.ask(Request::Decisions);
            }
        }
        Action::KeepModel => {
            if let Some(model) = &desk.in_use {
                let text = model.report.model.clone().into_bytes();
                let corpus = data.sheet.as_ref().map_or(String::new(), |sheet| sheet.name.clone());
                let name = named(&mut kept.name, corpus);
                kept.write(desk, Kind::Model.place(&name), text);
            }
        }
        Action::Open(place) => kept.read(desk, place, Purpose::Open),
        Action::Save(place) => kept.read(desk, place, Purpose::Save),
        Action::Delete(place) => kept.ask(desk, Ask::Delete(place)),
        Action::KeepHere => kept.ask(desk, Ask::Claim(true)),
        Action::Heard(news) => heard(state, news),
    }
}

/// What a person typed as a name, or else another.
fn named(typed: &mut String, other: String) -> String {
    let typed = std::mem::take(typed).trim().to_owned();
    if typed.is_empty() { other } else { typed }
}

/// The workbench is to be seen: the store is opened, if nobody did.
pub(super) fn begin(State { desk, kept, .. }: &mut State) {
    if kept.stage == Stage::Closed {
        kept.stage = Stage::Opening;
        kept.ask(desk, Ask::Open);
    }
}

/// What was decided of the rows is known: a corpus that waits for it is kept.
pub(super) fn decided(State { desk, data, kept, .. }: &mut State, decisions: &str) {
    if let (Some(name), Some(sheet)) = (kept.waits.take(), &data.sheet) {
        let bytes = pack::write(&sheet.files, sheet.with_rejected, Some(decisions.to_owned()));
        kept.write(desk, Kind::Corpus.place(&name), bytes);
    }
}

fn heard(state: &mut State, news: News) {
    let State { desk, kept, .. } = state;
    let text = Text::of(desk.language);
    match news {
        News::Open => {
            (kept.stage, kept.fault) = (Stage::Looking, None);
            kept.ask(desk, Ask::Claim(false));
        }
        News::Claimed(ours) => {
            let is_first = kept.stage == Stage::Looking;
            kept.fault = (!ours).then_some(Fault::Elsewhere);
            // What is there is looked at before anything is written.
            if !is_first {
                kept.stage = if ours { Stage::Keeping } else { Stage::Watching };
            }
            kept.ask(desk, Ask::List);
        }
        News::List(items) => {
            kept.items = items.into();
            if kept.stage == Stage::Looking {
                let ours = kept.fault != Some(Fault::Elsewhere);
                kept.stage = if ours { Stage::Keeping } else { Stage::Watching };
                let last = kept.own().find(|(kind, _)| *kind == Kind::Run);
                let last = last.map(|(_, item)| Kind::Run.place(&item.name)).filter(|_| ours);
                if let Some(place) = last {
                    kept.read(desk, place, Purpose::GoOn);
                }
            }
        }
        News::Read(place, found) => read(state, place, found),
        News::Written(place) => {
            kept.writes.retain(|other| *other != place);
            if kept.fault == Some(Fault::Full) {
                kept.fault = None;
            }
            let is_run = Kind::of(&place) == Some(Kind::Run);
            if let Some(run) = state.run.run.as_ref().filter(|run| is_run && run.name == place.name)
            {
                let progress = run.progress.as_ref();
                kept.reached = progress.map(|progress| (progress.epoch, progress.example));
            }
            if !is_run {
                said(state, (text.written)(&place.name));
            }
            let State { desk, kept, .. } = state;
            kept.ask(desk, Ask::List);
        }
        News::Deleted(place) => {
            // There may be room now for what there was none for.
            kept.run = None;
            said(state, (text.deleted)(&place.name));
            let State { desk, kept, .. } = state;
            kept.ask(desk, Ask::List);
        }
        News::Failed(place, fault) => failed(state, place, fault),
    }
}

/// Something went wrong with the store.
fn failed(state: &mut State, place: Option<Place>, fault: Fault) {
    let State { desk, kept, .. } = state;
    let text = Text::of(desk.language);
    if let Some(place) = &place {
        kept.writes.retain(|other| other != place);
        kept.reads.retain(|(other, _)| other != place);
    }
    match fault {
        Fault::None | Fault::Newer => kept.stage = Stage::Opening,
        Fault::Elsewhere => kept.stage = Stage::Watching,
        _ => {}
    }
    let is_new = kept.fault.as_ref() != Some(&fault);
    kept.fault = Some(fault.clone());
    if is_new {
        let is_run = state.run.live().is_some();
        let words =
            if is_run { (text.run_fault)(&fault, kept.reached) } else { (text.fault)(&fault) };
        desk.say(words);
    }
}

/// Something has happened: a run that has got on since it was kept last is kept, and its corpus with it.
pub(super) fn look(State { desk, data, run: training, kept, .. }: &mut State) {
    let (Some(run), Stage::Keeping) = (&mut training.run, kept.stage) else { return };
    let is_new = run.decisions.is_some() && (run.checkpoint.is_some() || run.model.is_some());
    if !is_new || kept.run.as_ref() == Some(&stamp(run)) {
        return;
    }
    if run.name.is_empty() {
        kept.came_back = None;
        run.name = kept.free_name(&run.corpus);
        kept.reached = None;
    }
    let place = Kind::Run.place(&run.name);
    let corpus = Kind::Corpus.place(&run.pack);
    if kept.writes.contains(&place) || kept.writes.contains(&corpus) {
        return;
    }
    let sheet = data.sheet.as_ref().filter(|sheet| sheet.pack() == run.pack);
    if let Some(sheet) = sheet.filter(|_| !kept.has(&corpus)) {
        kept.write(desk, corpus, pack::write(&sheet.files, sheet.with_rejected, None));
    }
    kept.run = Some(stamp(run));
    kept.write(desk, place, file::write(run).into_bytes());
}
