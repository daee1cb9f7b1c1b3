//! Why a command gives up, told in one line for a person: where and why.

use std::io;
use std::path::{Path, PathBuf};

/// Why a command gave up. Its `Display` is one line for a person: where and why.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The arguments are wrong.
    #[error("{0}")]
    Usage(String),
    /// A file cannot be read.
    #[error("cannot read {}: {source}", name(path))]
    Input {
        /// Which file; empty for standard input.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Standard output cannot be written.
    #[error("cannot write the results: {0}")]
    Output(io::Error),
}

impl From<lexopt::Error> for Failure {
    fn from(error: lexopt::Error) -> Self {
        Self::Usage(format!("{error} (see --help)"))
    }
}

/// What an input is called; one without a name is standard input.
pub(crate) fn name(path: &Path) -> String {
    if path.as_os_str().is_empty() { "standard input".into() } else { path.display().to_string() }
}
