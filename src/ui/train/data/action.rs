//! What a person can do with the corpus.

use crate::ui::page::files::Offered;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Files were chosen or dropped: corpora, or something for the robot.
    Offered(Vec<Offered>),
    /// Go back to the page's own six sentences.
    OpenDemo,
    /// Read the files again, with the rows that were rejected.
    UseRejected,
    /// Stop reading files.
    StopReading,
    /// Open or close a row of the corpus.
    ToggleRow(usize),
    /// Show more rows of the corpus.
    MoreRows,
    /// Save the corpus as a file.
    SaveCorpus,
}
