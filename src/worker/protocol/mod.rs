//! What page and engines say to each other: plain data in an [`Envelope`] that carries the protocol's version. No id of
//! an arena crosses (invariant 6).

mod learning;
mod message;
mod planning;
mod reading;
mod sheet;
mod wire;

pub use learning::{
    Confused, CorpusFile, CorpusReport, Experiment, ExperimentProgress, ExperimentReport, Figures,
    Judgement, Lesson, MOST_TAUGHT, PairText, Problem, Progress, RowSummary, RunPart, RunReport,
    TaskFigures, TeachReport, TrainReport, TrainSettings,
};
pub use message::{Envelope, Event, Program, Request, VERSION, Wanted};
pub use planning::{
    Answer, CellValue, MOST_RUNS, PlanProgress, PlanText, Runs, ValueMap, WorldRules,
};
pub use reading::{Fate, Node, Phrase, Piece, Reading, Referent, Refers, Study, Taken, Word};
pub use sheet::{Checkpoint, Fault, FileReport, Form, MappedFile, RowReading, SheetReport, Split};
pub use wire::{WireError, decode, encode};

// What comes from further down and crosses as it is.
pub use crate::ccg::closed::Kind as Closed;
pub use crate::ccg::{EntryText, Explanation, Part};
pub use crate::corpus::{Decision, Mapping, Preview};
pub use crate::ground::{Article, Claim, Description, Noun, Shade};
pub use crate::learn::audit::{Errors, Rows};
pub use crate::learn::inspect::{Difference, EntryLine, EntrySort, EntryView, EntryWindow};
pub use crate::learn::look::Look;
pub use crate::learn::settings::{Lexicon, SeedLexicon, Settings};
pub use crate::learn::sheet::{
    Care, Facets, Half, Line, Outcome, Rule, Rules, Status, Verdict, View, Window,
};
pub use crate::plan::Why;
