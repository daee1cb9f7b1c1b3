//! Reading corpora and other files for the commands that train and evaluate.

use super::failure::Failure;
use groundling::ccg::{General, Model};
use groundling::corpus::limits::MAX_FILE_BYTES;
use groundling::corpus::{Corpus, Example, Flaw, Mapping, Options, read, text_of};
use groundling::learn::runs::RowCounts;
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
    /// What makes rejected rows count.
    admit: Option<&'static str>,
}

impl Rows {
    /// What became of a corpus' rows.
    pub(crate) fn of(corpus: &Corpus) -> Self {
        let (read, rejected, left_out) = (corpus.rows(), corpus.rejected, corpus.left_out);
        Rows { read, rejected, left_out, admit: None }
    }

    /// With those of more files.
    pub(crate) fn add(&mut self, other: Rows) {
        self.read += other.read;
        self.rejected += other.rejected;
        self.left_out += other.left_out;
        self.admit = self.admit.or(other.admit);
    }

    /// With so many more rejected among those that were read, and what makes them count.
    pub(crate) fn rejecting(self, rejected: usize, admit: &'static str) -> Self {
        Rows { rejected: self.rejected + rejected, admit: Some(admit), ..self }
    }

    /// As figures for a file of results.
    pub(crate) fn counts(self) -> RowCounts {
        let Rows { read, rejected, left_out, .. } = self;
        RowCounts { rows: read, rejected, left_out }
    }

    /// Says it in a report.
    pub(crate) fn put(self, report: &mut Value) {
        report["rows"] = self.read.into();
        report["rejected"] = self.rejected.into();
        report["left_out"] = self.left_out.into();
    }
}

impl From<RowCounts> for Rows {
    fn from(counts: RowCounts) -> Self {
        let RowCounts { rows, rejected, left_out } = counts;
        Rows { read: rows, rejected, left_out, admit: None }
    }
}

impl std::fmt::Display for Rows {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Rows { read, rejected, left_out, admit } = *self;
        let used = read - rejected - left_out;
        write!(f, "{read} rows: {used} used, {rejected} rejected, {left_out} left out")?;
        match admit {
            Some(admit) if rejected > 0 => write!(f, " ({admit} uses rejected rows)"),
            _ => Ok(()),
        }
    }
}

/// Whether rejected rows are used.
#[derive(Clone, Copy)]
pub(crate) enum Admit {
    /// The command has no use for them.
    Never,
    /// By an option, if it is given.
    By(&'static str, bool),
    /// All are handed out; which of them count is for others to say.
    All,
}

impl Admit {
    /// By the option that most commands have.
    pub(crate) fn with_rejected(is_given: bool) -> Self {
        Admit::By("--with-rejected", is_given)
    }

    fn option(self) -> Option<&'static str> {
        if let Admit::By(option, _) = self { Some(option) } else { None }
    }

    fn options(self, mapping: Mapping) -> Options {
        Options { with_rejected: matches!(self, Admit::All | Admit::By(_, true)), mapping }
    }
}

/// The examples of all files in their order; what became of the rows, and what is wrong or odd with one, goes to
/// standard error.
pub(crate) fn examples(files: &[PathBuf], admit: Admit) -> Result<Loaded, Failure> {
    mapped(files, Mapping::default(), admit)
}

/// The same, where columns are what a mapping says.
pub(crate) fn mapped(files: &[PathBuf], mapping: Mapping, admit: Admit) -> Result<Loaded, Failure> {
    all(files, mapping, admit, None)
}

/// The same, with what every row says under a key.
pub(crate) fn keyed(files: &[PathBuf], admit: Admit, key: &str) -> Result<Loaded, Failure> {
    all(files, Mapping::default(), admit, Some(key))
}

/// The mapping of columns in a file.
pub(crate) fn mapping(path: &Path) -> Result<Mapping, Failure> {
    Mapping::read(&text(path)?)
        .map_err(|e| Failure::Usage(format!("{}: no mapping: {e}", path.display())))
}

fn all(
    files: &[PathBuf],
    mapping: Mapping,
    admit: Admit,
    key: Option<&str>,
) -> Result<Loaded, Failure> {
    let mut all = Loaded::default();
    let options = admit.options(mapping);
    for path in files {
        let (corpus, flaws) = read(source(path)?, options.clone());
        let rows = Rows { admit: admit.option(), ..Rows::of(&corpus) };
        if let Some(why) = corpus.why_empty(&flaws) {
            let keep = rows.admit.filter(|_| rows.rejected > 0);
            let keep = keep.map_or(String::new(), |option| format!(" ({option} uses them)"));
            let path = path.display();
            return Err(Failure::Usage(format!("{path}: no row can be used: {why}{keep}")));
        }
        tell(path, &flaws);
        if rows.rejected + rows.left_out > 0 && !matches!(admit, Admit::All) {
            let _ = writeln!(io::stderr(), "{}: {rows}", path.display());
        }
        all.rows.add(rows);
        if let Some(key) = key {
            let value = |example| corpus.value(example, key).map(str::to_owned);
            all.values.extend(corpus.examples.iter().map(value));
        }
        all.examples.extend(corpus.examples);
    }
    Ok(all)
}

/// What a corpus is read from: standard input, or a file that is not too large.
fn source(path: &Path) -> Result<Box<dyn Read>, Failure> {
    if path.as_os_str() == "-" {
        return Ok(Box::new(io::stdin().lock()));
    }
    let failed = |source| Failure::Input { path: path.to_owned(), source };
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
    Ok(Box::new(file))
}

/// Says on standard error what is wrong or odd; the work goes on when nobody listens there.
fn tell(path: &Path, flaws: &[Flaw]) {
    let mut error = io::stderr();
    let path = path.display();
    for flaw in flaws.iter().take(MAX_TOLD) {
        let fate = if flaw.kept { "kept" } else { "left out" };
        let _ = writeln!(error, "{path}: {flaw} ({fate})");
    }
    if flaws.len() > MAX_TOLD {
        let _ = writeln!(error, "{path}: and {} more", flaws.len() - MAX_TOLD);
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
