//! What page and engines say to each other: plain data in an [`Envelope`] that carries the protocol's version. No id of
//! an arena crosses (invariant 6).

mod learning;
mod message;
mod planning;
mod reading;
mod wire;

pub use learning::{
    Check, Confused, CorpusFile, CorpusReport, Experiment, ExperimentProgress, ExperimentReport,
    Figures, Fit, Judgement, Lesson, MOST_TAUGHT, Meaning, PairText, Problem, Progress, Refusal,
    RowSummary, RunPart, RunReport, SeedLexicon, TaskFigures, TeachReport, Told, TrainReport,
    TrainSettings, What,
};
pub use message::{Envelope, Event, Program, Request, VERSION, Wanted};
pub use planning::{
    Answer, CellValue, MOST_RUNS, PlanProgress, PlanText, Runs, ValueMap, WorldRules,
};
pub use reading::{Fate, Node, Phrase, Piece, Reading, Referent, Refers, Study, Taken, Word};
pub use wire::{WireError, decode, encode};

// What comes from further down and crosses as it is.
pub use crate::ccg::closed::Kind as Closed;
pub use crate::ccg::{EntryText, Explanation, Part};
pub use crate::ground::{Article, Claim, Description, Noun, Shade};
pub use crate::plan::Why;
