//! Files that are brought to the part about studies, and those that it makes: the engine reads and writes them.

use super::action::Saved;
use super::state::State;
use super::words::Text;
use crate::corpus::text_of;
use crate::study::Study;
use crate::ui::page::files::Offered;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{CorpusFile, Request, Sheet, StudyAsk};

/// Answers on view at once.
pub const PAGE: usize = 25;

/// The text of the first file that is one, with its name.
pub(super) fn first_text(files: Vec<Offered>) -> Option<(String, String)> {
    let text = |Offered { name, bytes }: Offered| Some((name, text_of(bytes.ok()?).ok()?));
    files.into_iter().find_map(text)
}

/// Has the engine take in files of answers, and merge them with what there is.
pub(super) fn bring(state: &mut State, desk: &mut Desk, files: Vec<Offered>) {
    (state.notice, state.unreadable) = (None, Vec::new());
    let mut all = 0;
    for Offered { name, bytes } in files {
        match bytes {
            Ok(bytes) => {
                all += bytes.len() as u32;
                ask(desk, StudyAsk::Bring(CorpusFile { name, bytes: bytes.into() }));
            }
            Err(_) => state.unreadable.push(name),
        }
    }
    if all > 0 {
        let (done, before) = state.bringing.unwrap_or_default();
        state.bringing = Some((done, before + all));
        review(state, desk);
    }
}

/// Has the engine hold the answers, if there are any, against the study.
pub(super) fn hold(state: &mut State, desk: &mut Desk) {
    if !state.log.is_empty() {
        review(state, desk);
    }
}

/// Has the engine merge all that was brought, and hold it against the study, where that is another than before.
pub(super) fn review(state: &mut State, desk: &mut Desk) {
    let is_new = |(_, fingerprint): &&(Box<Study>, String)| *fingerprint != state.held;
    let study = state.study.as_ref().filter(is_new).map(|(study, fingerprint)| {
        let bytes = study.write().into_bytes().into();
        (CorpusFile { name: study.name.clone(), bytes }, fingerprint.clone())
    });
    let study = study.map(|(file, fingerprint)| {
        state.held = fingerprint;
        file
    });
    ask(desk, StudyAsk::Review(study));
}

/// Asks the engine something about answers.
pub(super) fn ask(desk: &mut Desk, ask: StudyAsk) {
    match ask.is_aside() {
        true => desk.ask(Request::Study(ask)),
        false => desk.send(Request::Study(ask), false),
    }
}

/// Has a file written and saved; why there is none, in words.
pub(super) fn save(state: &State, desk: &mut Desk, what: Saved, text: &Text) -> Option<String> {
    let mut named = |name: &str, text: String| {
        desk.want(Effect::Save { name: name.to_owned(), text });
        None
    };
    let sheet = match what {
        Saved::Study => {
            return match &state.study {
                Some((study, _)) => named("study.json", study.write()),
                None => Some(text.no_study.to_owned()),
            };
        }
        Saved::Mapping => {
            let (.., mapping) = state.survey.as_ref()?;
            return named("survey-mapping.json", mapping.write());
        }
        Saved::Table => Sheet::Table,
        Saved::Lines => Sheet::Lines,
        Saved::Pay => Sheet::Pay,
        Saved::TopUp => Sheet::TopUp(state.wanted),
    };
    write(state, desk, sheet);
    None
}

/// Has the engine write a file.
pub(super) fn write(state: &State, desk: &mut Desk, what: Sheet) {
    let (key, approved_only) = (state.key.clone(), state.approved_only);
    ask(desk, StudyAsk::Write { what, key, approved_only });
}

/// The engine began anew: it is asked all that it was asked of answers.
pub fn restore(state: &mut State, desk: &mut Desk) {
    (state.bringing, state.judging, state.making) = (None, None, None);
    let asked = std::mem::take(&mut state.log);
    // What was decided is told by a review alone.
    let is_decided = asked.iter().any(|ask| matches!(ask, StudyAsk::Decide(_)));
    for again in asked {
        desk.send(Request::Study(again), false);
    }
    if is_decided {
        review(state, desk);
    }
}
