//! What is kept comes back, and what is to be kept is: the parts' contents on their way to the store and from it. A run
//! at work is kept whenever its checkpoint is new, and goes on when the workbench opens.

use super::data::{self, pack};
use super::kept::action::Action;
use super::kept::ask::{Ask, News};
use super::kept::state::{Kind, Purpose, Stage, Stamp};
use super::kept::words::Text;
use super::run::{self, file};
use super::state::State;
use crate::ui::page::files::{Given, Offered};
use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::news;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{CorpusFile, Request};
use run::state::{Pace, Run};

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

/// Takes a run from files that were offered, and opens it.
pub(super) fn take_run(state: &mut State, files: &mut Vec<Offered>) {
    let is_run = |file: &Offered| file.bytes.as_ref().is_ok_and(|bytes| file::is_run(bytes));
    let Some(at) = files.iter().position(is_run) else { return };
    let Offered { name, bytes } = files.remove(at);
    let name = name.trim_end_matches(".json");
    let run = string(bytes.unwrap_or_default()).and_then(|text| file::read(name, &text));
    match run {
        Ok(run) => bring(state, run),
        Err(why) => {
            let words = (Text::of(state.desk.language).wrong)(name, &why);
            said(state, words);
        }
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

/// Says what came of something, here and aloud.
fn said(State { desk, kept, .. }: &mut State, words: String) {
    desk.say(words.clone());
    kept.notice = Some(words);
}

/// Something that is kept has been read.
fn read(state: &mut State, place: Place, found: Option<(Vec<u8>, bool)>) {
    let State { desk, kept, .. } = state;
    let text = Text::of(desk.language);
    let Some(at) = kept.reads.iter().position(|(of, _)| *of == place) else { return };
    let (_, purpose) = kept.reads.remove(at);
    let Some((bytes, was_damaged)) = found else {
        let lacks = match purpose {
            Purpose::Run => text.no_corpus,
            _ => text.gone,
        };
        kept.ask(desk, Ask::List);
        if purpose == Purpose::Run {
            stop(state);
            state.kept.came_back = Some(lacks(&place.name));
        }
        return said(state, lacks(&place.name));
    };
    let opened = match (purpose, Kind::of(&place)) {
        (Purpose::Save, _) => save(state, &place, bytes),
        (Purpose::GoOn, _) => go_on(state, &place, &bytes),
        (Purpose::Open, Some(Kind::Run)) => string(bytes)
            .and_then(|text| file::read(&place.name, &text))
            .map(|run| bring(state, run)),
        (Purpose::Open, Some(Kind::Model)) => string(bytes).map(|text| {
            state.desk.want(Effect::Tell(news::News::Give(Given::Model(text))));
        }),
        (Purpose::Open | Purpose::Run, _) => pack::read(&bytes).map(|pack| {
            data::open::unpack(&mut state.data, &mut state.desk, pack);
            resume(state, &place);
        }),
    };
    let desk = &mut state.desk;
    match opened {
        Err(why) => {
            stop(state);
            said(state, (text.wrong)(&place.name, &why));
        }
        Ok(()) if was_damaged => said(state, (text.was_damaged)(&place.name)),
        Ok(()) if purpose == Purpose::Open => {
            desk.say((text.opened)(&place.name));
        }
        Ok(()) => {}
    }
}

fn string(bytes: Vec<u8>) -> Result<String, String> {
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

/// Gives what is kept as files: a corpus as those that it was opened from.
fn save(State { desk, .. }: &mut State, place: &Place, bytes: Vec<u8>) -> Result<(), String> {
    match Kind::of(place) {
        Some(Kind::Corpus) => {
            for one in pack::read(&bytes)?.files {
                desk.want(Effect::GiveBack(one.file));
            }
        }
        kind => {
            let end = if kind == Some(Kind::Run) { "json" } else { "model" };
            let name = format!("{}.{end}", place.name);
            desk.want(Effect::GiveBack(CorpusFile { name, bytes }));
        }
    }
    Ok(())
}

/// The run that was kept last goes on if the page was left while it was at work, and nothing else was begun meanwhile.
fn go_on(state: &mut State, place: &Place, bytes: &[u8]) -> Result<(), String> {
    let sheet = state.data.sheet.as_ref();
    let is_begun = state.run.run.is_some() || sheet.is_some_and(|sheet| !sheet.is_untouched());
    let run = file::read(&place.name, &string(bytes.to_vec())?)?;
    if run.pace == Pace::Goes && !is_begun {
        bring(state, run);
    }
    Ok(())
}

/// A run is opened: its corpus is read first.
fn bring(State { desk, run: training, kept, .. }: &mut State, run: Run) {
    let pack = Kind::Corpus.place(&run.pack);
    kept.run = Some(stamp(&run));
    training.coming = Some(run);
    kept.read(desk, pack, Purpose::Run);
}

/// The corpus of a run is being opened: so is the run.
fn resume(State { desk, run: training, kept, tab, .. }: &mut State, pack: &Place) {
    let text = Text::of(desk.language);
    let Some(run) = training.coming.take_if(|run| run.pack == pack.name) else { return };
    if let Some(decisions) = &run.decisions {
        desk.send(Request::TakeDecisions { text: decisions.clone() }, false);
    }
    if run.pace == Pace::Goes {
        let (pass, command) = run.progress.as_ref().map_or((1, 0), |p| (p.epoch, p.example));
        kept.reached = Some((pass, command));
        let words = (text.goes_on)(&run.name, pass, command);
        desk.say(words.clone());
        kept.came_back = Some(words);
    }
    if let Some(model) = &run.model {
        let (text, corpus) = (model.to_string(), run.corpus.clone());
        desk.want(Effect::Tell(news::News::Use { text, corpus }));
    }
    *tab = super::action::Tab::Run;
    run::update::bring_back(training, desk, run);
}

/// A run whose corpus is not there can be seen, and gone on with once the corpus is.
fn stop(State { run: training, .. }: &mut State) {
    if let Some(mut run) = training.coming.take() {
        if run.pace != Pace::Over {
            run.pace = Pace::Stopped;
        }
        training.run = Some(run);
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

fn stamp(run: &Run) -> Stamp {
    let is_over = (run.model.is_some(), run.pace == Pace::Stopped);
    Stamp { name: run.name.clone(), at: run.checkpoint.as_ref().map(|(_, at)| *at), is_over }
}
