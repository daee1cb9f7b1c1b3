//! What is kept comes back: runs with their corpora, corpora with what was decided of them, models. The run that was at
//! work when the page was left goes on when the workbench opens.

use super::action::Tab;
use super::data::{self, pack};
use super::effect::Effect;
use super::kept::ask::Ask;
use super::kept::state::{Kind, Purpose, Stamp};
use super::kept::words::Text;
use super::run::{self, file};
use super::state::State;
use crate::ui::page::files::{Given, Offered};
use crate::ui::page::keep::ask::Place;
use crate::ui::page::news::News;
use crate::worker::protocol::{CorpusFile, Request};
use run::state::{Pace, Run};

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

/// Something that is kept has been read.
pub(super) fn read(state: &mut State, place: Place, found: Option<(Vec<u8>, bool)>) {
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
            state.desk.want(Effect::Tell(News::Give(Given::Model(text))));
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
            desk.want(Effect::GiveBack(CorpusFile { name, bytes: bytes.into() }));
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
        desk.want(Effect::Tell(News::Use { text, corpus }));
    }
    *tab = Tab::Run;
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
    Stamp { name: run.name.clone(), at: run.checkpoint.as_ref().map(|(_, at)| *at), is_over }
}
