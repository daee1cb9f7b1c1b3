//! A run as a file of JSON, as it is kept: with it a run goes on where it was, in another tab or on another day.

use super::clock::Clock;
use super::curve::Point;
use super::state::{Pace, Run};
use crate::domain::misread;
use crate::worker::protocol::{Progress, Settings};
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// What such a file calls itself.
const FORMAT: &str = "groundling run";
/// The version of its form.
const VERSION: u32 = 1;

/// What it begins with.
const HEAD: &[u8] = b"{\"format\":\"groundling run\"";

/// Whether bytes are such a file.
pub fn is_run(bytes: &[u8]) -> bool {
    bytes.starts_with(HEAD)
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    corpus: String,
    pack: String,
    decisions: Option<String>,
    #[serde(default)]
    since: Option<String>,
    settings: Settings,
    pace: Pace,
    worked: f64,
    progress: Option<Progress>,
    points: Vec<Point>,
    checkpoint: Option<String>,
    model: Option<String>,
}

/// A run as a file.
pub fn write(run: &Run) -> String {
    let file = File {
        format: FORMAT.to_owned(),
        version: VERSION,
        corpus: run.corpus.clone(),
        pack: run.pack.clone(),
        decisions: run.decisions.clone(),
        since: run.since.as_ref().map(|(text, _)| text.clone()),
        settings: run.settings.clone(),
        pace: run.pace,
        worked: run.clock.worked(),
        progress: run.progress.clone(),
        points: run.points.to_vec(),
        checkpoint: run.checkpoint.as_ref().map(|(text, _)| text.clone()),
        model: run.model.as_deref().map(str::to_owned),
    };
    // It has no maps, and its numbers are finite.
    serde_json::to_string(&file).unwrap_or_default()
}

/// The run that a file is, kept under a name.
///
/// # Errors
/// In words, what is wrong with it.
pub fn read(name: &str, text: &str) -> Result<Run, String> {
    let file: File = misread::read(text)?;
    if file.format != FORMAT || file.version != VERSION {
        return Err(format!("it is no file of {FORMAT:?}, version {VERSION}"));
    }
    let mut run = Run::new(file.settings, file.corpus, file.pack);
    run.name = name.to_owned();
    run.decisions = file.decisions;
    run.since = file.since.map(|text| (text, 0));
    run.pace = file.pace;
    run.clock = Clock::worked_so_long(file.worked);
    run.progress = file.progress;
    run.points = Rc::new(file.points);
    run.checkpoint = file.checkpoint.map(|text| (text, 0.0));
    run.model = file.model.map(Rc::from);
    Ok(run)
}
