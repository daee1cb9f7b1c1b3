//! What is to be kept is: the parts' contents on their way to the store. A run at work is kept whenever its checkpoint is
//! new. What comes back is `returning`'s.

use super::data::pack;
use super::experiments::state::{About, Begun, Found};
use super::experiments::{self, file as result};
use super::kept::action::Action;
use super::kept::ask::{Ask, News};
use super::kept::state::{Kind, Purpose, Stage};
use super::kept::words::Text;
use super::returning::{read, said, stamp};
use super::run::file;
use super::run::state::Run;
use super::state::State;
use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::fault::Fault;
use crate::worker::protocol::{Joined, Request};
use std::rc::Rc;

/// So many of the experiments that are kept are seen when the workbench opens.
const MOST_SHOWN: usize = 20;

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

/// What was decided of the rows is known: a corpus that waits for it is kept, and what was decided since a run with it.
pub(super) fn decided(State { desk, data, run: training, kept, .. }: &mut State, decisions: &str) {
    let Some(sheet) = &data.sheet else { return };
    let of_sheet = |run: &&mut Run| run.is_still() && run.pack == sheet.pack();
    if let Some(run) = training.run.as_mut().filter(of_sheet)
        && run.decisions.is_some()
    {
        run.since = Some((decisions.to_owned(), sheet.log.len()));
    }
    if let Some(name) = kept.waits.take() {
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
                let found = kept.own().filter(|(kind, _)| *kind == Kind::Experiment);
                let found = found.take(MOST_SHOWN).map(|(kind, item)| kind.place(&item.name));
                for place in found.collect::<Vec<Place>>() {
                    kept.read(desk, place, Purpose::Show);
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
            let begun = state.experiments.begun.iter();
            let mut at_work = begun.map(|begun| Kind::Experiment.place(&begun.name));
            let is_at_work = at_work.any(|at_work| at_work == place);
            if let Some(run) = state.run.run.as_ref().filter(|run| is_run && run.name == place.name)
            {
                let progress = run.progress.as_ref();
                kept.reached = progress.map(|progress| (progress.epoch, progress.example));
            }
            if !is_run && !is_at_work {
                said(state, (text.written)(&place.name));
            }
            let State { desk, kept, .. } = state;
            kept.ask(desk, Ask::List);
        }
        News::Deleted(place) => {
            // There may be room now for what there was none for.
            kept.run = None;
            let is_it = |run: &&Run| run.is_still() && Kind::Run.place(&run.name) == place;
            if let Some(run) = state.run.run.as_ref().filter(is_it) {
                kept.deleted = Some(run.name.clone());
            }
            let results = &mut state.experiments.results;
            if Kind::of(&place) == Some(Kind::Experiment) {
                results.retain(|found| found.name != place.name);
            }
            for found in results.iter_mut() {
                if !kept.has(&Kind::Experiment.place(&found.name)) {
                    Rc::make_mut(found).name.clear();
                }
            }
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
pub(super) fn look(state: &mut State) {
    look_at_rows(state);
    look_at_results(state);
    let State { desk, data, run: training, kept, .. } = state;
    let (Some(run), Stage::Keeping) = (&mut training.run, kept.stage) else { return };
    let is_new = run.decisions.is_some() && (run.checkpoint.is_some() || run.model.is_some());
    let is_deleted = run.is_still() && kept.deleted.as_ref() == Some(&run.name);
    if !is_new || is_deleted || kept.run.as_ref() == Some(&stamp(run)) {
        return;
    }
    if run.name.is_empty() {
        kept.came_back = None;
        run.name = kept.free_name(Kind::Run, &run.corpus);
        (kept.reached, kept.deleted) = (None, None);
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

/// What is decided of the rows after a run is asked for, so that it is kept with the run.
fn look_at_rows(State { desk, data, run: training, kept, .. }: &mut State) {
    let (Some(run), Some(sheet), Stage::Keeping) = (&training.run, &data.sheet, kept.stage) else {
        return;
    };
    let known = run.since.as_ref().map_or(0, |(_, done)| *done);
    let is_news = run.is_still() && run.decisions.is_some() && sheet.log.len() > known;
    if is_news && run.pack == sheet.pack() && !desk.is_asking(&Request::Decisions) {
        desk.ask(Request::Decisions);
    }
}

/// What an experiment found is kept; and as long as it is at work that it is.
fn look_at_results(State { desk, experiments, kept, .. }: &mut State) {
    if kept.stage != Stage::Keeping {
        return;
    }
    let experiments::State { results, begun, .. } = experiments;
    let mut keep = |name: &mut String, plan: &str, joined: Option<&Joined>| {
        if name.is_empty() {
            *name = kept.free_name(Kind::Experiment, &About::of(plan).name);
        }
        let bytes = result::write(plan, joined).into_bytes();
        kept.write(desk, Kind::Experiment.place(name), bytes);
    };
    for found in results.iter_mut().filter(|found| found.name.is_empty()) {
        let Found { name, plan, joined, .. } = Rc::make_mut(found);
        if let Some(at) = begun.iter().position(|begun| begun.plan == *plan) {
            *name = begun.remove(at).name;
        }
        keep(name, plan, Some(joined));
    }
    let mut given_up = Vec::new();
    begun.retain_mut(|Begun { plan, name, is_given_up }| {
        if *is_given_up {
            given_up.push(std::mem::take(name));
        } else if name.is_empty() {
            keep(name, plan, None);
        }
        !*is_given_up
    });
    for name in given_up.into_iter().filter(|name| !name.is_empty()) {
        kept.ask(desk, Ask::Delete(Kind::Experiment.place(&name)));
    }
}

/// A person wants to see nothing more of what an experiment found.
pub(super) fn forget(State { desk, experiments, kept, .. }: &mut State, at: usize) {
    if at < experiments.results.len() {
        let found = experiments.results.remove(at);
        let place = Kind::Experiment.place(&found.name);
        if kept.has(&place) {
            kept.ask(desk, Ask::Delete(place));
        }
    }
}
