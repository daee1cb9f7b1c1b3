//! What all experiments are given alike.

use crate::command::{Failure, once};
use crate::corpora::{Loaded, Rows, examples, keyed, text};
use crate::parallel::default_jobs;
use crate::train::at_least_one;
use groundling::ccg::Model;
use groundling::corpus::Example;
use groundling::learn::experiment::By;
use groundling::learn::{Config, seed_model};
use lexopt::{Arg, ValueExt};
use serde_json::Value;
use std::error::Error;
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::Arc;

/// What follows an experiment's name.
pub(super) struct Given(pub(super) lexopt::Parser);

impl Given {
    /// The name of the next option; its values are still to be taken.
    pub(super) fn next(&mut self) -> Result<Option<String>, Failure> {
        match self.0.next()? {
            None => Ok(None),
            Some(Arg::Long(name)) => Ok(Some(name.to_owned())),
            Some(other) => Err(other.unexpected().into()),
        }
    }

    /// The one value of an option.
    pub(super) fn value<T>(&mut self) -> Result<T, Failure>
    where
        T: FromStr,
        T::Err: Into<Box<dyn Error + Send + Sync>>,
    {
        Ok(self.0.value()?.parse()?)
    }

    /// The values of an option, at least one.
    pub(super) fn values<T>(&mut self) -> Result<Vec<T>, Failure>
    where
        T: FromStr,
        T::Err: Into<Box<dyn Error + Send + Sync>>,
    {
        Ok(self.0.values()?.map(|value| value.parse()).collect::<Result<_, _>>()?)
    }

    /// The files that an option names, at least one.
    pub(super) fn files(&mut self) -> Result<Vec<PathBuf>, Failure> {
        Ok(self.0.values()?.map(PathBuf::from).collect())
    }
}

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
    rows: Rows,
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
    pub(super) fn take(&mut self, name: &str, given: &mut Given) -> Result<(), Failure> {
        let arguments = &mut given.0;
        match name {
            "json" => self.json = true,
            "with-rejected" => self.with_rejected = true,
            "lexicon" => once(&mut self.lexicon, "--lexicon", arguments)?,
            "without-idioms" => self.config.idioms = false,
            "without-contrasts" => self.config.contrasts = false,
            "epochs" => self.config.epochs = at_least_one(arguments, "--epochs")?,
            "seed" => self.config.seed = arguments.value()?.parse()?,
            "jobs" => self.jobs = at_least_one(arguments, "--jobs")? as usize,
            "demonstrations" => {
                self.config.demonstrations = Some(at_least_one(arguments, "--demonstrations")?);
            }
            _ => return Err(Failure::Usage(format!("invalid option '--{name}' (see --help)"))),
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

    /// The rows of files, rejected ones among them.
    pub(super) fn all_rows(&mut self, files: &[PathBuf]) -> Result<Vec<Example>, Failure> {
        Ok(examples(files, true)?.examples)
    }

    /// The rows of files.
    pub(super) fn rows(&mut self, files: &[PathBuf]) -> Result<Arc<[Example]>, Failure> {
        let Loaded { examples, rows, .. } = examples(files, self.with_rejected)?;
        self.rows.add(rows);
        Ok(Arc::from(examples))
    }

    /// The rows of files, with what each says under a key, which one of them has to say.
    pub(super) fn keyed(
        &mut self,
        files: &[PathBuf],
        key: &str,
    ) -> Result<(Arc<[Example]>, Vec<String>), Failure> {
        let Loaded { examples, rows, values } = keyed(files, self.with_rejected, key)?;
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
        let Loaded { values, .. } = keyed(files, self.with_rejected, key)?;
        Ok(values.into_iter().map(Option::unwrap_or_default).collect())
    }

    /// A report as text, with what became of the rows.
    pub(super) fn report(&self, mut report: Value) -> String {
        self.rows.put(&mut report);
        report.to_string()
    }
}
