//! A study as one file, for `generate`: of tasks, or of a corpus's rows.

use super::command::Done;
use super::corpora::{Admit, examples, text};
use super::failure::Failure;
use groundling::study::make::{Making, of_corpus};
use groundling::study::{Study, StudyTask};
use std::io::{self, Write};
use std::path::PathBuf;

/// Pairs of an item, where nothing is said.
const PAIRS: usize = 5;

/// What study is wanted.
#[derive(Debug, Default)]
pub(crate) struct Wanted {
    /// What it is called.
    pub(crate) name: Option<String>,
    /// The corpora whose rows are its items.
    pub(crate) corpus: Vec<PathBuf>,
    /// Whether what was said of them is kept.
    pub(crate) rehearsed: bool,
    /// Whether the robot's way is shown, whatever the goal.
    pub(crate) ways: bool,
    /// What else it says.
    pub(crate) settings: Option<PathBuf>,
}

impl Wanted {
    /// Whether one is wanted at all.
    pub(crate) fn is_wanted(&self) -> bool {
        let Wanted { name, corpus, rehearsed, ways, settings } = self;
        name.is_some() || !corpus.is_empty() || *rehearsed || *ways || settings.is_some()
    }
}

/// Writes the study.
pub(crate) fn write(
    wanted: &Wanted,
    tasks: Option<Vec<StudyTask>>,
    pairs: Option<usize>,
    seed: u64,
) -> Result<Done, Failure> {
    let usage = |what: &str| Failure::Usage(what.to_owned());
    let name = wanted.name.as_ref().ok_or_else(|| usage("--study NAME is missing"))?;
    let mut study = Study::new(name, Vec::new());
    study.seed = u32::try_from(seed).map_err(|_| usage("a study's seed is below 4294967296"))?;
    if let Some(path) = &wanted.settings {
        let read = study.with(&text(path)?);
        study = read.map_err(|e| Failure::Usage(format!("{}: {e}", path.display())))?;
    }
    let study = match tasks {
        None if wanted.corpus.is_empty() => {
            return Err(usage("--tasks FILE|all is missing, or --from CORPUS"));
        }
        None if wanted.ways => {
            return Err(usage("--ways is for tasks; what --from brings is shown as it is"));
        }
        None => {
            let rows =
                examples(&wanted.corpus, Admit::By("--rehearsed", wanted.rehearsed))?.examples;
            // Nothing is drawn but the worked example.
            made(Making::new(of_corpus(study, &rows, wanted.rehearsed), Vec::new(), PAIRS))?
        }
        Some(_) if !wanted.corpus.is_empty() || wanted.rehearsed => {
            return Err(usage("--tasks draws pairs, --from brings its own: leave one out"));
        }
        Some(tasks) => {
            let pairs = pairs.unwrap_or(PAIRS);
            if !(1..=100).contains(&pairs) {
                return Err(Failure::Usage(format!("--pairs {pairs}: use 1 to 100")));
            }
            let making = Making::new(study, tasks, pairs);
            made(if wanted.ways { making.with_ways() } else { making })?
        }
    };
    let text = study.write();
    Study::read(&text).map_err(|e| Failure::Usage(format!("the study: {e}")))?;
    io::stdout().write_all(text.as_bytes()).map_err(Failure::Output)?;
    Ok(Done::Well)
}

/// The study, once it is made.
fn made(mut making: Making) -> Result<Study, Failure> {
    let made = loop {
        if let Some(made) = making.step() {
            break made.map_err(|e| Failure::Usage(e.to_string()))?;
        }
    };
    for open in &made.open {
        // Nobody may be listening there; the pairs are good all the same.
        let _ = writeln!(io::stderr(), "{open}");
    }
    Ok(made.study)
}
