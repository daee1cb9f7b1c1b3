//! The messages themselves: requests of the page, events of the engine, and the envelope around both.

use super::learning::{
    CorpusFile, CorpusReport, Experiment, ExperimentProgress, Judgement, Lesson, PairText,
    Progress, TeachReport, TrainReport, TrainSettings,
};
use super::planning::{Answer, PlanProgress, PlanText, Runs, ValueMap, WorldRules};
use super::reading::Study;
use super::sheet::{Checkpoint, Form, MappedFile, RowReading, SheetReport, Split};
use crate::corpus::Preview;
use crate::domain::{Blueprint, State};
use crate::learn::audit::Errors;
use crate::learn::inspect::{Difference, EntryView, EntryWindow};
use crate::learn::look::Look;
use crate::learn::sheet::{Care, Facets, Rules, Verdict, View, Window};
use crate::learn::{SeedLexicon, Settings};
use serde::{Deserialize, Serialize};

/// The protocol's version; both sides refuse any other.
pub const VERSION: u32 = 8;

/// One message: a request and every event that answers it carry the same `id`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Envelope<T> {
    /// The protocol's version, [`VERSION`]; the first field, by which readers know what follows.
    pub groundling: u32,
    /// Which request this is, or answers; chosen by the page, 0 for what nobody asked for.
    pub id: u32,
    /// The message itself.
    pub body: T,
}

/// The page's programs, each an engine in a worker of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// It answers, plans and says what it found; the page always has it.
    Talker,
    /// It reads corpora, trains, teaches and runs experiments; loaded when there is something to learn.
    Learner,
}

impl Program {
    /// Its name, which is what the page's worker script is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Program::Talker => "talker",
            Program::Learner => "learner",
        }
    }
}

/// A kind of command to try.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Wanted {
    /// This one, if it can be done, or if it is certain that it cannot.
    Said(String),
    /// To go somewhere.
    Go,
    /// To bring something somewhere.
    Bring,
    /// Something that is told by what it is like.
    Describe,
    /// To be, or to bring something, next to something.
    Beside,
    /// With a word that is not known: what there is to teach.
    Unknown,
}

/// What the page asks of an engine. A request replaces the one at work, but for `Cancel`, `Ping`, those that say how fast
/// it goes, and those that [`Request::is_aside`] tells.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Request {
    /// Reads corpus files and keeps them as one corpus, if each has a good row → [`Event::Reading`] now and then, then
    /// [`Event::Corpus`].
    ReadCorpus {
        /// The files.
        files: Vec<CorpusFile>,
        /// Keep rows that were rejected.
        with_rejected: bool,
    },
    /// The states of one row of the corpus that is kept → [`Event::Row`].
    ShowRow {
        /// Index into [`CorpusReport::rows`].
        row: usize,
    },
    /// Trains on the corpus that is kept → [`Event::Progress`] after every example, then [`Event::Trained`].
    Train {
        /// What is known beforehand.
        lexicon: SeedLexicon,
        /// What differs from the paper's settings.
        settings: TrainSettings,
    },
    /// Teaches a model a few examples besides, of which each has a demonstration → [`Event::Taught`]. Nothing is kept.
    Teach {
        /// The model file's text.
        model: String,
        /// The examples, at most [`MOST_TAUGHT`](super::MOST_TAUGHT).
        examples: Vec<Lesson>,
    },
    /// Opens a model file → [`Event::Opened`].
    OpenModel {
        /// The model file's text.
        text: String,
    },
    /// Understands words that no lexicon knows by a general resource, with whatever model is open, now and later →
    /// [`Event::Words`].
    Words {
        /// The resource's text.
        text: String,
    },
    /// Parses and grounds a command that is being typed, and plans nothing → [`Event::Answer`]. The policy that is
    /// kept stays.
    Read {
        /// The command as typed.
        command: String,
        /// The state of the world it would be said in.
        state: State,
    },
    /// Parses, grounds and plans a command → [`Event::Planning`] now and then, then [`Event::Answer`]. The policy is
    /// kept. Where something was left out, or where it is better to ask first, nothing is planned.
    Ask {
        /// The command as typed.
        command: String,
        /// The state of the world it is said in.
        state: State,
        /// What can happen in that world.
        rules: WorldRules,
    },
    /// Plans for a goal, such as another reading's → [`Event::Planning`] now and then, then [`Event::Planned`]. The
    /// policy is kept.
    Plan {
        /// The goal as an s-expression.
        form: String,
        /// The state of the world.
        state: State,
        /// What can happen in that world.
        rules: WorldRules,
    },
    /// What each cell is worth to the robot under the policy that is kept, with all else as it is in a state →
    /// [`Event::Values`].
    Values {
        /// A state of the world that the policy is for.
        state: State,
    },
    /// Follows the policy that is kept many times → [`Event::RollingOut`] after each, then [`Event::RolledOut`].
    RollOut {
        /// How often, at most [`MOST_RUNS`](super::MOST_RUNS).
        runs: u32,
        /// The seed of what happens.
        seed: u32,
    },
    /// Takes the readings of a command apart, for those who study them → [`Event::Explained`].
    Explain {
        /// The command as typed.
        command: String,
    },
    /// Looks for a command to try in a world → [`Event::Example`]. The policy that is kept stays.
    Example {
        /// Of which kind.
        wanted: Wanted,
        /// The state of the world.
        state: State,
        /// What can happen in it.
        rules: WorldRules,
    },
    /// Draws a world by chance → [`Event::World`].
    Draw {
        /// What is wanted.
        blueprint: Blueprint,
        /// The seed of the rest.
        seed: u32,
    },
    /// Reads a world that is drawn in characters, or its JSON → [`Event::World`].
    ReadWorld {
        /// The text.
        text: String,
    },
    /// Draws a world in characters → [`Event::WorldText`].
    WriteWorld {
        /// The world.
        state: State,
    },
    /// Runs an experiment on the corpus that is kept → [`Event::Experimenting`] after every example, then
    /// [`Event::Experimented`]. Corpus and model stay as they are.
    Experiment {
        /// Which.
        experiment: Experiment,
        /// What differs from the paper's settings in every run.
        settings: TrainSettings,
    },
    /// Looks at the beginning of a file, for a person who maps its columns → [`Event::Previewed`].
    Preview {
        /// The file.
        file: CorpusFile,
    },
    /// Reads corpus files, rejected rows among them, and keeps them as one sheet if each has a good row →
    /// [`Event::Reading`] now and then, then [`Event::Sheet`].
    OpenSheet {
        /// The files.
        files: Vec<MappedFile>,
        /// Whether rejected rows are learned from and judged on all the same.
        with_rejected: bool,
    },
    /// Some lines of a view of the sheet → [`Event::Window`].
    Window {
        /// Which rows, in which order.
        view: View,
        /// The first line's place among them.
        offset: u32,
        /// How many lines, at most [`MOST_LINES`](crate::learn::sheet::view::MOST_LINES).
        count: u32,
    },
    /// What there is to filter by → [`Event::Facets`].
    Facets,
    /// What the model that was audited makes of a row → [`Event::RowReading`].
    ReadRow {
        /// The row.
        row: u32,
    },
    /// How the sheet stands → [`Event::Care`].
    Care,
    /// Decides something of rows → [`Event::Care`].
    Decide {
        /// The rows.
        rows: Vec<u32>,
        /// What.
        verdict: Verdict,
    },
    /// Decides something of all rows of a view → [`Event::Care`].
    DecideAll {
        /// Which rows.
        view: View,
        /// What.
        verdict: Verdict,
    },
    /// Parts the sheet → [`Event::Care`].
    Divide {
        /// How.
        split: Split,
    },
    /// Undoes the last change of the sheet → [`Event::Care`].
    Undo,
    /// Does again what was undone last → [`Event::Care`].
    Redo,
    /// Marks rows by rules → [`Event::Care`].
    Mark {
        /// How strict.
        rules: Rules,
    },
    /// Asks a model the command of every row, and marks rows by rules → [`Event::Auditing`] now and then, then
    /// [`Event::Care`]. The model is kept for [`Request::ReadRow`], [`Request::Errors`] and those about its lexicon.
    Audit {
        /// The model file's text; nothing for the one that is kept, or was trained last.
        model: Option<String>,
        /// How strict.
        rules: Rules,
    },
    /// Where the model that was audited errs, as far as it is → [`Event::Errors`].
    Errors,
    /// The good rows of a file as a file, with what was decided of them → [`Event::Saved`].
    SaveSheet {
        /// The number of the file.
        file: u32,
        /// In which form; nothing for its own.
        form: Option<Form>,
    },
    /// The bad rows of a file that was read last, as they stand there → [`Event::Saved`].
    SaveBadRows {
        /// The number of the file.
        file: u32,
    },
    /// Trains on the half of the sheet that is learned from → [`Event::Progress`] after every example,
    /// [`Event::HeldOut`] after every epoch if there is something held out, then [`Event::Trained`].
    Learn {
        /// The settings.
        settings: Box<Settings>,
        /// A checkpoint of a run with the same settings and rows to go on from.
        resume: Option<String>,
    },
    /// What was learned last → [`Event::Look`].
    Look,
    /// A checkpoint of the run at work, or of one that was stopped → [`Event::Checkpoint`].
    Checkpoint,
    /// The model as the run at work, or one that was stopped, has it so far → [`Event::Trained`].
    ModelSoFar,
    /// Some entries of the model that was audited, or else trained last → [`Event::Entries`].
    Entries {
        /// Which, in which order.
        view: EntryView,
        /// The first line's place among them.
        offset: u32,
        /// How many lines.
        count: u32,
    },
    /// The same model without some entries → [`Event::Trained`]; an audit of it shows what that changes.
    Without {
        /// Their places in its lexicon.
        places: Vec<u32>,
    },
    /// What tells two models apart → [`Event::Difference`].
    Compare {
        /// A model file's text.
        first: String,
        /// Another's.
        second: String,
    },
    /// What is at work rests as soon as it can → [`Event::Heard`], then [`Event::Paused`] of what rests.
    Pause,
    /// What rests goes on → [`Event::Heard`].
    Resume,
    /// What rests goes on by one example → as for `Pause`.
    StepExample,
    /// What rests goes on to the end of an epoch → as for `Pause`.
    StepEpoch,
    /// Stops what is at work → [`Event::Cancelled`] for that request's id.
    Cancel,
    /// Asks whether the engine still answers → [`Event::Pong`]; replaces nothing.
    Ping,
}

impl Request {
    /// The program that it is for; nothing where any will do.
    pub fn program(&self) -> Option<Program> {
        match self {
            Request::ReadCorpus { .. }
            | Request::ShowRow { .. }
            | Request::Train { .. }
            | Request::Teach { .. }
            | Request::Experiment { .. }
            | Request::Preview { .. }
            | Request::OpenSheet { .. }
            | Request::Window { .. }
            | Request::Facets
            | Request::ReadRow { .. }
            | Request::Care
            | Request::Decide { .. }
            | Request::DecideAll { .. }
            | Request::Divide { .. }
            | Request::Undo
            | Request::Redo
            | Request::Mark { .. }
            | Request::Audit { .. }
            | Request::Errors
            | Request::SaveSheet { .. }
            | Request::SaveBadRows { .. }
            | Request::Learn { .. }
            | Request::Look
            | Request::Checkpoint
            | Request::ModelSoFar
            | Request::Entries { .. }
            | Request::Without { .. }
            | Request::Compare { .. } => Some(Program::Learner),
            Request::OpenModel { .. }
            | Request::Words { .. }
            | Request::Read { .. }
            | Request::Ask { .. }
            | Request::Plan { .. }
            | Request::Values { .. }
            | Request::RollOut { .. }
            | Request::Explain { .. }
            | Request::Example { .. }
            | Request::Draw { .. }
            | Request::ReadWorld { .. }
            | Request::WriteWorld { .. } => Some(Program::Talker),
            Request::Pause
            | Request::Resume
            | Request::StepExample
            | Request::StepEpoch
            | Request::Cancel
            | Request::Ping => None,
        }
    }

    /// Whether it is answered at once and replaces nothing.
    pub const fn is_aside(&self) -> bool {
        matches!(
            self,
            Request::ShowRow { .. }
                | Request::Preview { .. }
                | Request::Window { .. }
                | Request::Facets
                | Request::ReadRow { .. }
                | Request::Care
                | Request::Decide { .. }
                | Request::DecideAll { .. }
                | Request::Divide { .. }
                | Request::Undo
                | Request::Redo
                | Request::Mark { .. }
                | Request::Errors
                | Request::SaveSheet { .. }
                | Request::SaveBadRows { .. }
                | Request::Look
                | Request::Checkpoint
                | Request::ModelSoFar
                | Request::Entries { .. }
                | Request::Without { .. }
                | Request::Compare { .. }
        )
    }
}

/// What an engine says to the page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Event {
    /// The engine is up.
    Ready,
    /// The engine still answers.
    Pong,
    /// The engine has met an error in the program and can do nothing more.
    Crashed {
        /// The panic's message and place.
        message: String,
    },
    /// A corpus is being read.
    Reading {
        /// Bytes that are read.
        done: u64,
        /// Bytes in all.
        of: u64,
    },
    /// A corpus was read.
    Corpus(CorpusReport),
    /// One row's states.
    Row {
        /// Index into [`CorpusReport::rows`].
        row: usize,
        /// Its demonstrations.
        pairs: Vec<PairText>,
    },
    /// Training has seen one more example.
    Progress(Progress),
    /// There is a model that was learned.
    Trained(TrainReport),
    /// There is a model that was opened.
    Opened(TrainReport),
    /// There is a general resource for words that the lexicon does not know.
    Words,
    /// The model was taught.
    Taught(Box<TeachReport>),
    /// A command was answered.
    Answer(Box<Answer>),
    /// A planner is at work: how far it is.
    Planning(PlanProgress),
    /// There is a plan, or a reason for none.
    Planned(Box<PlanText>),
    /// What the cells are worth.
    Values(ValueMap),
    /// A run has ended; what came of all so far.
    RollingOut(Runs),
    /// All runs have ended.
    RolledOut(Runs),
    /// The readings that an answer shows, in its order.
    Explained(Vec<Study>),
    /// A command to try, if there is one of that kind.
    Example {
        /// The kind.
        wanted: Wanted,
        /// The command.
        command: Option<String>,
    },
    /// A world.
    World(State),
    /// A world as text.
    WorldText {
        /// It is read back by [`Request::ReadWorld`].
        text: String,
    },
    /// An experiment has gone on by one example.
    Experimenting(ExperimentProgress),
    /// An experiment is over.
    Experimented {
        /// An [`ExperimentReport`](super::ExperimentReport) as JSON: a page that only keeps it need not take it apart.
        report: String,
    },
    /// The beginning of a file.
    Previewed(Box<Preview>),
    /// Files were read.
    Sheet(Box<SheetReport>),
    /// Some lines of a view.
    Window(Box<Window>),
    /// What there is to filter by.
    Facets(Box<Facets>),
    /// What a model makes of a row.
    RowReading(Box<RowReading>),
    /// How the sheet stands.
    Care(Care),
    /// Rows are judged.
    Auditing {
        /// Rows that are.
        done: u32,
        /// Rows in all.
        of: u32,
    },
    /// Where a model errs.
    Errors(Box<Errors>),
    /// A file to save.
    Saved {
        /// Its name.
        name: String,
        /// Its bytes.
        #[serde(with = "super::learning::bytes")]
        bytes: Vec<u8>,
    },
    /// The model of a run was judged on what is held out.
    HeldOut {
        /// The epoch that has ended; one past the last for the model that the run ends with.
        epoch: u32,
        /// How it was judged.
        judgement: Box<Judgement>,
    },
    /// What was learned last, if anything was.
    Look(Option<Box<Look>>),
    /// Some entries of a lexicon.
    Entries(Box<EntryWindow>),
    /// What tells two models apart.
    Difference(Box<Difference>),
    /// A run that can go on from here.
    Checkpoint(Checkpoint),
    /// A request that says how fast to go was heard.
    Heard,
    /// What this request began rests.
    Paused,
    /// The request failed; what was loaded before is as it was.
    Refused {
        /// What is wrong, where, and what to do: for a person.
        message: String,
    },
    /// The request was cancelled; what was loaded before is as it was.
    Cancelled,
}
