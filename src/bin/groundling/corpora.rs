//! Reading corpora and other files for the commands that train and evaluate.

use super::failure::Failure;
use groundling::ccg::{General, Model};
use groundling::corpus::limits::MAX_FILE_BYTES;
use groundling::corpus::{Example, Flaw, Mapping, Options, read, text_of};
use serde_json::Value;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Flaws of a file that are told one by one.
const MAX_TOLD: usize = 20;

/// The examples of some files, and what became of all their rows.
#[derive(Debug, Default)]
pub(crate) struct Loaded {
    pub(crate) examples: Vec<Example>,
    pub(crate) rows: Rows,
    /// For every example what it says under the key that was asked for.
    pub(crate) values: Vec<Option<String>>,
}

/// What became of rows.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Rows {
    read: usize,
    rejected: usize,
    left_out: usize,
}

impl Rows {
    /// With those of more files.
    pub(crate) fn add(&mut self, other: Rows) {
        self.read += other.read;
        self.rejected += other.rejected;
        self.left_out += other.left_out;
    }

    /// Says it in a report.
    pub(crate) fn put(self, report: &mut Value) {
        report["rows"] = self.read.into();
        report["rejected"] = self.rejected.into();
        report["left_out"] = self.left_out.into();
    }
}

impl std::fmt::Display for Rows {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Rows { read, rejected, left_out } = *self;
        let used = read - rejected - left_out;
        write!(f, "{read} rows: {used} used, {rejected} rejected, {left_out} left out")?;
        if rejected > 0 { f.write_str(" (--with-rejected uses rejected rows)") } else { Ok(()) }
    }
}

/// The examples of all files in their order; what became of the rows, and what is wrong or odd with one, goes to
/// standard error.
pub(crate) fn examples(files: &[PathBuf], with_rejected: bool) -> Result<Loaded, Failure> {
    mapped(files, &Options { with_rejected, ..Options::default() })
}

/// The same, with what every row says under a key.
pub(crate) fn keyed(files: &[PathBuf], with_rejected: bool, key: &str) -> Result<Loaded, Failure> {
    all(files, &Options { with_rejected, ..Options::default() }, Some(key))
}

/// The mapping of columns in a file.
pub(crate) fn mapping(path: &Path) -> Result<Mapping, Failure> {
    Mapping::read(&text(path)?)
        .map_err(|e| Failure::Usage(format!("{}: no mapping: {e}", path.display())))
}

/// The same, with what is to be taken of the files.
pub(crate) fn mapped(files: &[PathBuf], options: &Options) -> Result<Loaded, Failure> {
    all(files, options, None)
}

fn all(files: &[PathBuf], options: &Options, key: Option<&str>) -> Result<Loaded, Failure> {
    let mut all = Loaded::default();
    for path in files {
        let failed = |source| Failure::Input { path: path.clone(), source };
        let source: Box<dyn Read> = if path.as_os_str() == "-" {
            Box::new(io::stdin().lock())
        } else {
            let file = File::open(path).map_err(failed)?;
            // What is known to be too large need not be read to be refused.
            let bytes = file.metadata().map_or(0, |found| found.len());
            if bytes > MAX_FILE_BYTES {
                let (path, most) = (path.display(), MAX_FILE_BYTES >> 20);
                return Err(Failure::Usage(format!(
                    "{path}: the file has {} MB, more than {most}; split it, and give all parts",
                    bytes.div_ceil(1 << 20)
                )));
            }
            Box::new(file)
        };
        let (corpus, flaws) = read(source, options.clone());
        let rows =
            Rows { read: corpus.rows(), rejected: corpus.rejected, left_out: corpus.left_out };
        if let Some(why) = corpus.why_empty(&flaws) {
            let path = path.display();
            let keep = if rows.rejected > 0 { " (--with-rejected uses them)" } else { "" };
            return Err(Failure::Usage(format!("{path}: no row can be used: {why}{keep}")));
        }
        tell(path, &flaws, rows);
        all.rows.add(rows);
        if let Some(key) = key {
            let value = |example| corpus.value(example, key).map(str::to_owned);
            all.values.extend(corpus.examples.iter().map(value));
        }
        all.examples.extend(corpus.examples);
    }
    Ok(all)
}

/// Says on standard error what became of rows; the work goes on when nobody listens there.
fn tell(path: &Path, flaws: &[Flaw], rows: Rows) {
    let mut error = io::stderr();
    let path = path.display();
    for flaw in flaws.iter().take(MAX_TOLD) {
        let fate = if flaw.kept { "kept" } else { "left out" };
        let _ = writeln!(error, "{path}: {flaw} ({fate})");
    }
    if flaws.len() > MAX_TOLD {
        let _ = writeln!(error, "{path}: and {} more", flaws.len() - MAX_TOLD);
    }
    if rows.rejected + rows.left_out > 0 {
        let _ = writeln!(error, "{path}: {rows}");
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

/// A text file, without its byte-order mark.
pub(crate) fn text(path: &Path) -> Result<String, Failure> {
    let failed = |source| Failure::Input { path: path.to_owned(), source };
    text_of(fs::read(path).map_err(failed)?).map_err(|line| {
        let path = path.display();
        Failure::Usage(format!("{path}: line {line} is not UTF-8 text: save the file in UTF-8"))
    })
}
