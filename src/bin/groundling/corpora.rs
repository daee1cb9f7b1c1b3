//! Reading corpora and writing models for the commands that train and evaluate.

use super::command::Failure;
use groundling::ccg::{General, Model};
use groundling::corpus::{Example, Flaw, Form, Options, read};
use std::fs::{self, File};
use std::io::{self, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Flaws of a file that are told one by one.
const MAX_TOLD: usize = 20;

/// The examples of all files in their order; what is wrong or odd with a row goes to standard error.
pub(crate) fn examples(files: &[PathBuf], with_rejected: bool) -> Result<Vec<Example>, Failure> {
    let mut all = Vec::new();
    for path in files {
        let failed = |source| Failure::Input { path: path.clone(), source };
        let source: Box<dyn Read> = if path.as_os_str() == "-" {
            Box::new(io::stdin().lock())
        } else {
            Box::new(BufReader::new(File::open(path).map_err(failed)?))
        };
        let form = Form::of_name(&path.to_string_lossy());
        let (corpus, flaws) = read(form, source, Options { with_rejected });
        if corpus.examples.is_empty() {
            let why = flaws.first().map_or("it has no rows".to_owned(), ToString::to_string);
            let path = path.display();
            return Err(Failure::Usage(format!("{path}: no row can be used: {why}")));
        }
        tell(path, &flaws);
        all.extend(corpus.examples);
    }
    Ok(all)
}

/// Says on standard error what is wrong or odd with rows; the work goes on when nobody listens there.
fn tell(path: &Path, flaws: &[Flaw]) {
    let mut error = io::stderr();
    for flaw in flaws.iter().take(MAX_TOLD) {
        let fate = if flaw.kept { "kept" } else { "left out" };
        let _ = writeln!(error, "{}: {flaw} ({fate})", path.display());
    }
    if flaws.len() > MAX_TOLD {
        let _ = writeln!(error, "{}: and {} more", path.display(), flaws.len() - MAX_TOLD);
    }
}

/// The model in a file.
pub(crate) fn model(path: &Path) -> Result<Model, Failure> {
    Model::read(&text(path)?)
        .map_err(|e| Failure::Usage(format!("{}: no model: {e}", path.display())))
}

/// What words that no lexicon knows may stand for.
const WORDS: &str = include_str!("../../../assets/lexicon/words.txt");

/// The model in a file, to be asked: it understands more words than its lexicon knows.
pub(crate) fn speaker(path: &Path) -> Result<Model, Failure> {
    let mut model = model(path)?;
    let general = General::read(WORDS).map_err(|e| Failure::Usage(format!("words: {e}")))?;
    model.attach(Arc::new(general));
    Ok(model)
}

/// A text file.
pub(crate) fn text(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|source| Failure::Input { path: path.to_owned(), source })
}

/// Writes a file whole or not at all: beside it first, then in its place.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".part");
    let beside = PathBuf::from(beside);
    fs::write(&beside, text)
        .and_then(|()| fs::rename(&beside, path))
        .map_err(|e| Failure::Usage(format!("cannot write {}: {e}", path.display())))
}
