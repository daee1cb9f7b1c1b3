//! What is kept comes back: runs with their corpora, corpora with what was decided of them, models. The run that was kept
//! last is there again when the workbench opens, and goes on if it was at work when the page was left.

use super::action::Tab;
use super::data::{self, pack};
use super::effect::Effect;
use super::experiments::state::Found;
use super::experiments::{self, file as result};
use super::kept::ask::Ask;
use super::kept::state::{Kind, Purpose, Stage, Stamp};
use super::kept::words::Text;
use super::run::{self, file};
use super::state::State;
use crate::ui::page::files::{Given, Offered};
use crate::ui::page::keep::ask::Place;
use crate::ui::page::news::News;
use crate::worker::protocol::{CorpusFile, Request};
use run::state::{Pace, Run};
use std::rc::Rc;

/// Takes a run from files that were offered, and what experiments found, and opens them.
pub(super) fn take(state: &mut State, files: &mut Vec<Offered>) {
    let is = |file: &Offered, is: fn(&[u8]) -> bool| file.bytes.as_ref().is_ok_and(|b| is(b));
    let run = files.iter().position(|file| is(file, file::is_run)).map(|at| files.remove(at));
    let others = std::mem::take(files);
    let (results, others) = others.into_iter().partition(|file| is(file, result::is_result));
    *files = others;
    for (is_run, Offered { name, bytes }) in
        run.into_iter().map(|run| (true, run)).chain(results.into_iter().map(|one| (false, one)))
    {
        let name = name.trim_end_matches(".json");
        let text = string(bytes.unwrap_or_default());
        let opened = text.and_then(|text| match is_run {
            true => file::read(name, &text).map(|run| bring(state, run, Purpose::Run)),
            false => result::read("", &text).map(|found| show(state, found, "", true)),
        });
        if let Err(why) = opened {
            let words = (Text::of(state.desk.language).wrong)(name, &why);
            said(state, words);
        }
    }
}

/// What an experiment found is to be seen; whether a person opened it. Of one that was at work it is said that it is lost,
/// unless it is another tab's; a file has no name here.
fn show(
    State { desk, experiments, kept, tab, .. }: &mut State,
    found: Result<Found, String>,
    name: &str,
    is_opened: bool,
) {
    let found = match found {
        Ok(found) => found,
        Err(_) if kept.stage != Stage::Keeping || !experiments.begun.is_empty() => return,
        Err(plan) => {
            let words = (experiments::words::Text::of(desk.language).was_lost)(&plan);
            desk.say(words.clone());
            experiments.notice = Some(words);
            let place = Kind::Experiment.place(name);
            if kept.has(&place) {
                kept.ask(desk, Ask::Delete(place));
            }
            return;
        }
    };
    let results = &mut experiments.results;
    let is_there = |other: &Rc<Found>| !found.name.is_empty() && other.name == found.name;
    let place = if is_opened { 0 } else { results.len() };
    if !results.iter().any(is_there) {
        results.insert(place, Rc::new(found));
    }
    if is_opened {
        *tab = Tab::Experiments;
    }
}

/// Something that is kept has been read.
pub(super) fn read(state: &mut State, place: Place, found: Option<(Vec<u8>, bool)>) {
    let State { desk, kept, .. } = state;
    let text = Text::of(desk.language);
    let Some(at) = kept.reads.iter().position(|(of, _)| *of == place) else { return };
    let (_, purpose) = kept.reads.remove(at);
    let is_of_run = matches!(purpose, Purpose::Run | Purpose::Back);
    let Some((bytes, was_damaged)) = found else {
        let lacks = if is_of_run { text.no_corpus } else { text.gone };
        kept.ask(desk, Ask::List);
        if is_of_run {
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
            .map(|run| bring(state, run, Purpose::Run)),
        (Purpose::Open | Purpose::Show, Some(Kind::Experiment)) => string(bytes)
            .and_then(|text| result::read(&place.name, &text))
            .map(|found| show(state, found, &place.name, purpose == Purpose::Open)),
        (Purpose::Open, Some(Kind::Model)) => string(bytes).map(|text| {
            state.desk.want(Effect::Tell(News::Give(Given::Model(text))));
        }),
        (Purpose::Open | Purpose::Show | Purpose::Run | Purpose::Back, _) => pack::read(&bytes)
            .map(|pack| {
                data::open::unpack(&mut state.data, &mut state.desk, pack);
                resume(state, &place, purpose == Purpose::Back);
            }),
    };
    let desk = &mut state.desk;
    match opened {
        Err(why) => {
            if is_of_run {
                stop(state);
            }
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
            let end = if kind == Some(Kind::Model) { "model" } else { "json" };
            let name = format!("{}.{end}", place.name);
            desk.want(Effect::GiveBack(CorpusFile { name, bytes: bytes.into() }));
        }
    }
    Ok(())
}

/// The run that was kept last comes back, if nothing else was begun meanwhile.
fn go_on(state: &mut State, place: &Place, bytes: &[u8]) -> Result<(), String> {
    let sheet = state.data.sheet.as_ref();
    let is_begun = state.run.run.is_some() || sheet.is_some_and(|sheet| !sheet.is_untouched());
    let run = file::read(&place.name, &string(bytes.to_vec())?)?;
    if !is_begun {
        bring(state, run, Purpose::Back);
    }
    Ok(())
}

/// A run is opened: its corpus is read first.
fn bring(State { desk, run: training, kept, .. }: &mut State, run: Run, purpose: Purpose) {
    let pack = Kind::Corpus.place(&run.pack);
    kept.run = Some(stamp(&run));
    training.coming = Some(run);
    kept.read(desk, pack, purpose);
}

/// The corpus of a run is being opened: so is the run. What the robot of a page that comes back uses the page knows.
fn resume(
    State { desk, run: training, kept, tab, .. }: &mut State,
    pack: &Place,
    comes_back: bool,
) {
    let text = Text::of(desk.language);
    let Some(run) = training.coming.take_if(|run| run.pack == pack.name) else { return };
    let goes = run.pace == Pace::Goes;
    let since = run.since.as_ref().map(|(text, _)| text).filter(|_| !goes);
    if let Some(text) = since.or(run.decisions.as_ref()) {
        desk.send(Request::TakeDecisions { text: text.clone() }, false);
    }
    if goes {
        let (pass, command) = run.progress.as_ref().map_or((1, 0), |p| (p.epoch, p.example));
        kept.reached = Some((pass, command));
        let words = (text.goes_on)(&run.name, pass, command);
        desk.say(words.clone());
        kept.came_back = Some(words);
    }
    if let Some(model) = run.model.as_ref().filter(|_| !comes_back) {
        let (text, corpus) = (model.to_string(), run.corpus.clone());
        desk.want(Effect::Tell(News::Use { text, corpus }));
    }
    if goes || !comes_back {
        *tab = Tab::Run;
    } else {
        desk.say((text.is_back)(&run.name));
    }
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

/// Says what came of something, here and aloud.
pub(super) fn said(State { desk, kept, .. }: &mut State, words: String) {
    desk.say(words.clone());
    kept.notice = Some(words);
}

/// What tells a run as it is now from the same run later.
pub(super) fn stamp(run: &Run) -> Stamp {
    let is_over = (run.model.is_some(), run.pace == Pace::Stopped);
    let (name, at) = (run.name.clone(), run.checkpoint.as_ref().map(|(_, at)| *at));
    Stamp { name, at, is_over, since: run.since.as_ref().map(|(_, done)| *done) }
}
