//! Files are opened: those for the robot go to the page, all others are one corpus.

use super::demo;
use super::pack::{self, Pack};
use super::state::{Refused, State};
use super::words::Text;
use crate::ui::page::files::{self, Given, Kind, Offered};
use crate::ui::page::news::News;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{CorpusFile, MappedFile, Mapping, Request};

/// What a mapping's file begins with.
const MAPPING: &[u8] = b"groundling mapping";

/// How far into a file that may stand.
const HEAD: usize = 64;

/// Files by what they are.
#[derive(Default)]
struct Sorted {
    corpora: Vec<CorpusFile>,
    packs: Vec<Pack>,
    given: Vec<Given>,
    mapping: Option<Mapping>,
}

/// Opens files: all corpora among them are one, mapped as a mapping among them says. Where one cannot be read, none is.
/// Whether there was anything but what is for the robot.
pub fn open(state: &mut State, desk: &mut Desk, files: Vec<Offered>) -> bool {
    let Sorted { corpora, packs, given, mapping } = match sorted(files, Text::of(desk.language)) {
        Ok(sorted) => sorted,
        Err(message) => {
            say(state, desk, message);
            return true;
        }
    };
    for given in given {
        desk.want(Effect::Tell(News::Give(given)));
    }
    if let Some(pack) = packs.into_iter().next() {
        unpack(state, desk, pack);
        return true;
    }
    let is_ours = !corpora.is_empty() || mapping.is_some();
    if corpora.is_empty() {
        mapping.iter().for_each(|mapping| map(state, desk, mapping));
    } else {
        let mapping = mapping.unwrap_or_default();
        let mapped = |file| MappedFile { file, mapping: mapping.clone() };
        read(state, desk, corpora.into_iter().map(mapped).collect(), false);
    }
    is_ours
}

fn sorted(files: Vec<Offered>, text: &Text) -> Result<Sorted, String> {
    let mut sorted = Sorted::default();
    for Offered { name, bytes } in files {
        let fault = |fault| (text.file_fault)(&name, fault);
        let bytes = bytes.map_err(fault)?;
        if is_mapping(&bytes) {
            let mapping = Mapping::read(&String::from_utf8_lossy(&bytes));
            sorted.mapping = Some(mapping.map_err(|wrong| format!("{name}: {wrong}."))?);
        } else if pack::is_pack(&bytes) {
            let pack = pack::read(&bytes);
            sorted.packs.push(pack.map_err(|wrong| format!("{name}: {wrong}."))?);
        } else if files::kind(&name, &bytes) == Kind::Corpus {
            sorted.corpora.push(CorpusFile { name, bytes: bytes.into() });
        } else {
            sorted.given.extend(files::given(&name, bytes).map_err(fault)?);
        }
    }
    Ok(sorted)
}

/// Gives the engine files to read as one corpus.
pub fn read(state: &mut State, desk: &mut Desk, files: Vec<MappedFile>, with_rejected: bool) {
    if desk.is_learning() {
        let message = Text::of(desk.language).busy.to_owned();
        return say(state, desk, message);
    }
    (state.refused, state.columns) = (None, None);
    desk.learner.retain(|request| !matches!(request, Request::OpenSheet { .. }));
    desk.send(Request::OpenSheet { files, with_rejected }, false);
}

/// Opens a corpus that was kept, with what was decided of it.
pub fn unpack(state: &mut State, desk: &mut Desk, pack: Pack) {
    let Pack { files, with_rejected, decisions } = pack;
    read(state, desk, files, with_rejected);
    if let Some(text) = decisions.filter(|_| !desk.is_learning()) {
        desk.send(Request::TakeDecisions { text }, false);
    }
}

/// Opens the page's own sentences.
pub fn open_demo(state: &mut State, desk: &mut Desk) {
    read(state, desk, vec![demo::file()], false);
}

/// The engine began anew: it is given its corpus again, and asked all that was done to it.
pub fn restore(state: &mut State, desk: &mut Desk) {
    if let Some(sheet) = &mut state.sheet {
        let (files, with_rejected) = (sheet.files.to_vec(), sheet.with_rejected);
        desk.send(Request::OpenSheet { files, with_rejected }, false);
        for request in std::mem::take(&mut sheet.log).iter() {
            desk.send(request.clone(), false);
        }
    }
}

/// Says what is wrong with files.
pub fn say(state: &mut State, desk: &mut Desk, message: String) {
    desk.say(message.clone());
    state.refused = Some(Refused::of(message));
}

/// A mapping was given: columns that are being mapped are so, or else the files that are open.
fn map(state: &mut State, desk: &mut Desk, mapping: &Mapping) {
    if let Some(columns) = &mut state.columns {
        return columns.take(mapping);
    }
    let refused = state.refused.as_ref().map(|refused| &refused.files[..]).unwrap_or_default();
    let open = state.sheet.as_ref().map(|sheet| &sheet.files[..]).unwrap_or_default();
    let files = if refused.is_empty() { open } else { refused };
    let mapped = |one: &MappedFile| MappedFile { file: one.file.clone(), mapping: mapping.clone() };
    let files: Vec<MappedFile> = files.iter().map(mapped).collect();
    read(state, desk, files, false);
}

fn is_mapping(bytes: &[u8]) -> bool {
    let head = bytes.get(..HEAD.min(bytes.len())).unwrap_or_default();
    head.trim_ascii_start().starts_with(b"{")
        && head.windows(MAPPING.len()).any(|part| part == MAPPING)
}
