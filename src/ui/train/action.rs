//! What a person can do on the Train page, and what the page wants that is not its own to do. Plain data.

use crate::ui::page::files::Offered;
use crate::worker::protocol::TrainReport;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Files were chosen: corpora, or something else.
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
    /// Train on the corpus that is open.
    Train,
    /// Stop training.
    CancelTraining,
    /// Save the model as a file.
    SaveModel,
}

/// What the page wants done elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// Open files, whatever they are.
    Open(Vec<Offered>),
    /// Use the model that was trained on the corpus of this name.
    Use(TrainReport, String),
}
