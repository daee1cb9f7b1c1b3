//! What all experiments are given alike.

use crate::arguments::Arguments;
use crate::corpora::{Admit, Loaded, Rows, examples, keyed, text};
use crate::failure::Failure;
use crate::parallel::default_jobs;
use groundling::ccg::Model;
use groundling::corpus::Example;
use groundling::learn::experiment::By;
use groundling::learn::{Config, seed_model};
use serde_json::Value;
use std::path::PathBuf;
use std::sync::Arc;

/// What an option lacks.
pub(super) fn missing(name: &str) -> Failure {
    Failure::Usage(format!("{name} is missing"))
}

/// The options that every experiment takes.
#[derive(Debug)]
pub(super) struct Common {
    pub(super) config: Config,
    pub(super) json: bool,
    pub(super) jobs: usize,
    pub(super) with_rejected: bool,
    lexicon: Option<PathBuf>,
    /// What became of the rows of all files so far.
    pub(super) rows: Rows,
}

impl Common {
    pub(super) fn new() -> Self {
        let (config, jobs) = (Config::default(), default_jobs());
        Common {
            config,
            json: false,
            jobs,
            lexicon: None,
            with_rejected: false,
            rows: Rows::default(),
        }
    }

    /// Takes an option by its name, with its value.
    pub(super) fn take(&mut self, name: &str, given: &mut Arguments) -> Result<(), Failure> {
        match name {
            "json" => self.json = true,
            "with-rejected" => self.with_rejected = true,
            "lexicon" => self.lexicon = Some(given.file()?),
            "without-idioms" => self.config.idioms = false,
            "without-contrasts" => self.config.contrasts = false,
            "epochs" => self.config.epochs = given.count()?,
            "seed" => self.config.seed = given.whole()?,
            "jobs" => self.jobs = given.count()?,
            "demonstrations" => self.config.demonstrations = Some(given.count()?),
            _ => return Err(given.unknown()),
        }
        Ok(())
    }

    /// A model that knows the seed lexicon; `default` when none was given.
    pub(super) fn seed(&self, default: &str) -> Result<Model, Failure> {
        let own = self.lexicon.as_deref().map(text).transpose()?;
        let place = self.lexicon.as_ref().map(|path| path.display().to_string());
        seed_model(own.as_deref().unwrap_or(default)).map_err(|e| {
            Failure::Usage(format!("{}: {e}", place.as_deref().unwrap_or("the lexicon")))
        })
    }

    /// The text of the seed lexicon, if one was given.
    pub(super) fn lexicon_text(&self) -> Result<Option<String>, Failure> {
        self.lexicon.as_deref().map(text).transpose()
    }

    /// The rows of files, rejected ones among them; which of these count is still to be said.
    pub(super) fn all_rows(&mut self, files: &[PathBuf]) -> Result<Vec<Example>, Failure> {
        let Loaded { examples, rows, .. } = examples(files, Admit::All)?;
        self.rows.add(rows);
        Ok(examples)
    }

    /// The rows of files.
    pub(super) fn rows(&mut self, files: &[PathBuf]) -> Result<Arc<[Example]>, Failure> {
        let Loaded { examples, rows, .. } =
            examples(files, Admit::with_rejected(self.with_rejected))?;
        self.rows.add(rows);
        Ok(Arc::from(examples))
    }

    /// The rows of files, with what each says under a key, which one of them has to say.
    pub(super) fn keyed(
        &mut self,
        files: &[PathBuf],
        key: &str,
    ) -> Result<(Arc<[Example]>, Vec<String>), Failure> {
        let Loaded { examples, rows, values } =
            keyed(files, Admit::with_rejected(self.with_rejected), key)?;
        self.rows.add(rows);
        if values.iter().all(Option::is_none) {
            let names = By::ALL.map(|(name, _)| name).join(", ");
            return Err(Failure::Usage(format!(
                "--by `{key}`: use one of {names}, or a key of the rows: none has this one"
            )));
        }
        Ok((Arc::from(examples), values.into_iter().map(Option::unwrap_or_default).collect()))
    }

    /// What the rows of files say under a key; nothing where they do not.
    pub(super) fn values(&self, files: &[PathBuf], key: &str) -> Result<Vec<String>, Failure> {
        let Loaded { values, .. } = keyed(files, Admit::with_rejected(self.with_rejected), key)?;
        Ok(values.into_iter().map(Option::unwrap_or_default).collect())
    }

    /// A report as JSON, with what became of the rows.
    pub(super) fn report(&self, mut report: Value) -> String {
        self.rows.put(&mut report);
        report.to_string()
    }

    /// A report for a person, with the same.
    pub(super) fn told(&self, report: &str) -> String {
        format!("{}\n{report}", self.rows)
    }
}
