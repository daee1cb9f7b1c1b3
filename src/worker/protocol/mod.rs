//! What page and engines say to each other: plain data in an [`Envelope`] that carries the protocol's version. No id of
//! an arena crosses (invariant 6).

mod learning;
mod message;
mod request;
mod event;
mod planning;
mod reading;
mod sheet;
mod study;
mod wire;
mod talk;
mod beyond;

pub use beyond::{Beyond, beyond, lost};
pub use event::Event;
pub use learning::{
    Check, Confused, CorpusFile, Demonstrated, ExperimentProgress, Figures, Fit, Judgement, Lesson,
    MOST_TAUGHT, Meaning, PairText, Progress, Refusal, RunPart, RunReport, RunText, Shown,
    TaskFigures, TeachReport, Told, TrainReport, What,
};
pub use message::{Envelope, Program, VERSION};
pub use planning::{
    Answer, CellValue, Instead, MOST_RUNS, PlanProgress, PlanText, Runs, ValueMap, WorldRules,
};
pub use reading::{Fate, Node, Phrase, Piece, Reading, Referent, Refers, Study, Taken, Word};
pub use request::{Request, Wanted};
pub use sheet::{
    Checkpoint, Fault, FileReport, Form, Joined, MappedFile, RowReading, SheetReport, Split,
};
pub use study::{AnswerLine, Reviewed, Sheet, StudyAsk, StudySaid};
pub use talk::{decode_asked, decode_said};
pub use wire::{Reader, WireError, decode, encode};

// What comes from further down and crosses as it is.
pub use crate::ccg::closed::Kind as Closed;
pub use crate::ccg::{EntryText, Explanation, Kind as FeatureKind, Part};
pub use crate::corpus::{Decision, Mapping, Preview, States};
pub use crate::ground::{Article, Claim, Description, Noun, Shade};
pub use crate::learn::asking::Answered;
pub use crate::learn::audit::{Errors, Rows};
pub use crate::learn::experiment::By;
pub use crate::learn::inspect::{Difference, EntryLine, EntrySort, EntryView, EntryWindow};
pub use crate::learn::look::Look;
pub use crate::learn::runs::Matrix;
pub use crate::learn::settings::{Lexicon, SeedLexicon, Settings};
pub use crate::learn::sheet::{
    Care, Deed, Done, Facet, Facets, Half, Line, Outcome, Rule, Rules, Sort, Status, Verdict, View,
    Window,
};
pub use crate::plan::Why;
pub use crate::study::Flag;
pub use crate::study::coverage::Coverage;
pub use crate::study::survey::SurveyMapping;
