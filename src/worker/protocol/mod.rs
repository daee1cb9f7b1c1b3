//! What page and engine say to each other. Every message is one JSON text in an [`Envelope`] that carries
//! the protocol's version; no id of an arena crosses (invariant 6), only text and plain data. A body is its
//! kind's name, or `{kind: content}`: a tag inside the content would cost both programs a tenth of their size.

mod learning;
mod message;
mod planning;
mod reading;

pub use learning::{
    Confused, CorpusReport, CorpusText, Experiment, ExperimentProgress, ExperimentReport, Figures,
    Judgement, Lesson, MOST_TAUGHT, PairText, Problem, Progress, RowSummary, RunPart, RunReport,
    SeedLexicon, TaskFigures, TeachReport, TrainReport, TrainSettings,
};
pub use message::{Envelope, Event, Program, Request, VERSION};
pub use planning::{
    Answer, CellValue, MOST_RUNS, PlanProgress, PlanText, Runs, ValueMap, WorldRules,
};
pub use reading::{Fate, Node, Phrase, Piece, Reading, Referent, Refers, Study, Word};

// What comes from further down and crosses as it is.
pub use crate::ccg::{EntryText, Explanation, Part};
pub use crate::ground::{Article, Claim, Description, Noun};
pub use crate::plan::Why;
