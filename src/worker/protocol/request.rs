//! What the page asks of an engine.

use super::learning::{CorpusFile, Lesson};
use super::message::Program;
use super::planning::WorldRules;
use super::sheet::{Form, MappedFile, Split};
use super::study::StudyAsk;
use crate::domain::{Blueprint, State};
use crate::learn::Settings;
use crate::learn::asking::Answered;
use crate::learn::inspect::EntryView;
use crate::learn::runs::Matrix;
use crate::learn::sheet::{Rules, Verdict, View};
use serde::{Deserialize, Serialize};

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
/// it goes, and those that [`Request::is_aside`] tells. First what the talker reads (`talk`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Request {
    /// Stops what is at work → [`Event::Cancelled`](super::Event::Cancelled) for that request's id.
    Cancel,
    /// Asks whether the engine still answers → [`Event::Pong`](super::Event::Pong); replaces nothing.
    Ping,
    /// Opens a model file → [`Event::Opened`](super::Event::Opened).
    OpenModel {
        /// The model file's text.
        text: String,
    },
    /// Understands words that no lexicon knows by a general resource, with whatever model is open, now and later →
    /// [`Event::Words`](super::Event::Words).
    Words {
        /// The resource's text.
        text: String,
    },
    /// Parses and grounds a command that is being typed, and plans nothing → [`Event::Answer`](super::Event::Answer). The policy that is
    /// kept stays.
    Read {
        /// The command as typed.
        command: String,
        /// The state of the world it would be said in.
        state: State,
    },
    /// Parses, grounds and plans a command → [`Event::Planning`](super::Event::Planning) now and then, then [`Event::Answer`](super::Event::Answer). The policy is
    /// kept. Where something was left out, or where it is better to ask first, nothing is planned.
    Ask {
        /// The command as typed.
        command: String,
        /// The state of the world it is said in.
        state: State,
        /// What can happen in that world.
        rules: WorldRules,
    },
    /// Plans for a goal, such as another reading's → [`Event::Planning`](super::Event::Planning) now and then, then [`Event::Planned`](super::Event::Planned). The
    /// policy is kept.
    Plan {
        /// The goal as an s-expression.
        form: String,
        /// The states from where it was said to where it is to be planned from; for a goal of states those two will do.
        run: Vec<State>,
        /// What can happen in that world.
        rules: WorldRules,
    },
    /// What each cell is worth to the robot under the policy that is kept, with all else as it is in a state →
    /// [`Event::Values`](super::Event::Values).
    Values {
        /// A state of the world that the policy is for.
        state: State,
        /// Of a task over time: how many of its steps were done by then.
        done: u8,
    },
    /// Follows the policy that is kept many times → [`Event::RollingOut`](super::Event::RollingOut) after each, then [`Event::RolledOut`](super::Event::RolledOut).
    RollOut {
        /// How often, at most [`MOST_RUNS`](super::MOST_RUNS).
        runs: u32,
        /// The seed of what happens.
        seed: u32,
    },
    /// Takes the readings of a command apart, for those who study them → [`Event::Explained`](super::Event::Explained).
    Explain {
        /// The command as typed.
        command: String,
    },
    /// Looks for a command to try in a world → [`Event::Example`](super::Event::Example). The policy that is kept stays.
    Example {
        /// Of which kind.
        wanted: Wanted,
        /// The state of the world.
        state: State,
        /// What can happen in it.
        rules: WorldRules,
    },
    /// Draws a world by chance → [`Event::World`](super::Event::World).
    Draw {
        /// What is wanted.
        blueprint: Blueprint,
        /// The seed of the rest.
        seed: u32,
    },
    /// Reads a world that is drawn in characters, or its JSON → [`Event::World`](super::Event::World).
    ReadWorld {
        /// The text.
        text: String,
    },
    /// Draws a world in characters → [`Event::WorldText`](super::Event::WorldText).
    WriteWorld {
        /// The world.
        state: State,
    },
    /// Plans as `Plan` does, while the policy that is kept stays → [`Event::Planning`](super::Event::Planning) now and then,
    /// then [`Event::Planned`](super::Event::Planned).
    GoOn {
        /// The goal as an s-expression.
        form: String,
        /// The states from where it was said to where it is to be planned from.
        run: Vec<State>,
        /// What can happen in that world.
        rules: WorldRules,
    },
    /// The states of one row of the sheet → [`Event::Row`](super::Event::Row).
    ShowRow {
        /// Index into the sheet.
        row: usize,
    },
    /// Teaches a model a few examples besides, of which each has a demonstration → [`Event::Taught`](super::Event::Taught). Nothing is kept.
    Teach {
        /// The model file's text.
        model: String,
        /// The examples, at most [`MOST_TAUGHT`](super::MOST_TAUGHT).
        examples: Vec<Lesson>,
    },
    /// The paper's Section VII: learns from the half of the sheet that is learned from, then answers a command that was
    /// never heard → [`Event::Experimenting`](super::Event::Experimenting) after every example, then [`Event::Demonstrated`](super::Event::Demonstrated). Sheet
    /// and model stay as they are.
    Demonstrate {
        /// The command.
        command: String,
        /// The state of the world it is said in.
        state: State,
        /// The settings.
        settings: Box<Settings>,
    },
    /// Looks at the beginning of a file, for a person who maps its columns → [`Event::Previewed`](super::Event::Previewed).
    Preview {
        /// The file.
        file: CorpusFile,
    },
    /// Reads corpus files, rejected rows among them, and keeps them as one sheet if each has a good row →
    /// [`Event::Reading`](super::Event::Reading) now and then, then [`Event::Sheet`](super::Event::Sheet).
    OpenSheet {
        /// The files.
        files: Vec<MappedFile>,
        /// Whether rejected rows are learned from and judged on all the same.
        with_rejected: bool,
    },
    /// Some lines of a view of the sheet → [`Event::Window`](super::Event::Window).
    Window {
        /// Which rows, in which order.
        view: View,
        /// The first line's place among them.
        offset: u32,
        /// How many lines, at most [`MOST_LINES`](crate::learn::sheet::view::MOST_LINES).
        count: u32,
    },
    /// What there is to filter by → [`Event::Facets`](super::Event::Facets).
    Facets,
    /// What the model that was audited makes of a row → [`Event::RowReading`](super::Event::RowReading).
    ReadRow {
        /// The row.
        row: u32,
    },
    /// How the sheet stands → [`Event::Care`](super::Event::Care).
    Care,
    /// Decides something of rows → [`Event::Care`](super::Event::Care).
    Decide {
        /// The rows.
        rows: Vec<u32>,
        /// What.
        verdict: Verdict,
    },
    /// Decides something of all rows of a view → [`Event::Care`](super::Event::Care).
    DecideAll {
        /// Which rows.
        view: View,
        /// What.
        verdict: Verdict,
    },
    /// Parts the sheet → [`Event::Care`](super::Event::Care).
    Divide {
        /// How.
        split: Split,
    },
    /// What was decided of all rows → [`Event::Decisions`](super::Event::Decisions).
    Decisions,
    /// Decides of all rows what such a text says → [`Event::Care`](super::Event::Care).
    TakeDecisions {
        /// The text.
        text: String,
    },
    /// Undoes the last change of the sheet → [`Event::Care`](super::Event::Care).
    Undo,
    /// Does again what was undone last → [`Event::Care`](super::Event::Care).
    Redo,
    /// Marks rows by rules → [`Event::Care`](super::Event::Care).
    Mark {
        /// How strict.
        rules: Rules,
    },
    /// Asks a model the command of every row, and marks rows by rules → [`Event::Auditing`](super::Event::Auditing) now and then, then
    /// [`Event::Care`](super::Event::Care). The model is kept for [`Request::ReadRow`], [`Request::Errors`] and those about its lexicon.
    Audit {
        /// The model file's text; nothing for the one that is kept, or was trained last.
        model: Option<String>,
        /// How strict.
        rules: Rules,
        /// What other engines have found of commands: these are not asked again.
        known: Vec<Answered>,
    },
    /// Asks a model a part of the commands of the sheet, for an engine that has the same rows →
    /// [`Event::Auditing`](super::Event::Auditing) now and then, then [`Event::Answered`](super::Event::Answered).
    AskPart {
        /// The model file's text.
        model: String,
        /// The number of the part, from 0.
        part: u32,
        /// How many parts there are.
        of: u32,
    },
    /// Where the model that was audited errs, as far as it is → [`Event::Errors`](super::Event::Errors).
    Errors,
    /// The good rows of a file as a file, with what was decided of them → [`Event::Saved`](super::Event::Saved).
    SaveSheet {
        /// The number of the file.
        file: u32,
        /// In which form; nothing for its own.
        form: Option<Form>,
    },
    /// The bad rows of a file that was read last, as they stand there → [`Event::Saved`](super::Event::Saved).
    SaveBadRows {
        /// The number of the file.
        file: u32,
    },
    /// Trains on the half of the sheet that is learned from → [`Event::Progress`](super::Event::Progress) after every example,
    /// [`Event::HeldOut`](super::Event::HeldOut) after every epoch if there is something held out, then [`Event::Trained`](super::Event::Trained).
    Learn {
        /// The settings.
        settings: Box<Settings>,
        /// A checkpoint of a run with the same settings and rows to go on from.
        resume: Option<String>,
    },
    /// Takes a run that is over up again, on the rows that it learned from, for what it learned; it is not judged again →
    /// [`Event::Trained`](super::Event::Trained).
    Recall {
        /// Its settings.
        settings: Box<Settings>,
        /// What was decided of the rows when it began.
        decisions: String,
        /// Its last checkpoint.
        checkpoint: String,
    },
    /// What was learned last → [`Event::Look`](super::Event::Look).
    Look,
    /// A checkpoint of the run at work, of one that was stopped, or of the end of one that is over → [`Event::Checkpoint`](super::Event::Checkpoint).
    Checkpoint,
    /// The model as the run at work, or one that was stopped, has it so far → [`Event::Trained`](super::Event::Trained).
    ModelSoFar,
    /// Some entries of the model that was audited, or else trained last → [`Event::Entries`](super::Event::Entries).
    Entries {
        /// Which, in which order.
        view: EntryView,
        /// The first line's place among them.
        offset: u32,
        /// How many lines.
        count: u32,
    },
    /// The same model without some entries → [`Event::Trained`](super::Event::Trained); an audit of it shows what that changes.
    Without {
        /// Their places in its lexicon.
        places: Vec<u32>,
    },
    /// What tells two models apart → [`Event::Difference`](super::Event::Difference).
    Compare {
        /// A model file's text.
        first: String,
        /// Another's.
        second: String,
    },
    /// The plan of some runs on the sheet as it is parted now → [`Event::Plan`](super::Event::Plan).
    PlanRuns {
        /// Which runs.
        matrix: Matrix,
        /// The settings that they have in common.
        settings: Box<Settings>,
    },
    /// Runs some of a plan's runs on the sheet's rows → [`Event::Experimenting`](super::Event::Experimenting) after every example, then
    /// [`Event::Shard`](super::Event::Shard). Engines with the same rows share a plan out so; sheet and model stay as they are.
    RunShard {
        /// The plan's text.
        plan: String,
        /// The numbers of the runs, from 0.
        runs: Vec<u32>,
    },
    /// Joins what all shards of a plan found, in the plan's order → [`Event::Joined`](super::Event::Joined).
    JoinRuns {
        /// The plan's text.
        plan: String,
        /// What the shards handed back, in any order.
        shards: Vec<String>,
    },
    /// Keeps a model for the requests about its lexicon, as long as none is audited or trained → [`Event::Heard`](super::Event::Heard).
    KeepModel {
        /// The model file's text.
        text: String,
    },
    /// What is at work rests as soon as it can → [`Event::Heard`](super::Event::Heard), then [`Event::Paused`](super::Event::Paused) of what rests.
    Pause,
    /// What rests goes on → [`Event::Heard`](super::Event::Heard).
    Resume,
    /// What rests goes on by one example → as for `Pause`.
    StepExample,
    /// What rests goes on to the end of an epoch → as for `Pause`.
    StepEpoch,
    /// Something is to be done about a study → [`Event::Study`](super::Event::Study).
    Study(StudyAsk),
}

impl Request {
    /// The program that it is for; nothing where any will do.
    pub fn program(&self) -> Option<Program> {
        match self {
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
            | Request::WriteWorld { .. }
            | Request::GoOn { .. } => Some(Program::Talker),
            Request::Pause
            | Request::Resume
            | Request::StepExample
            | Request::StepEpoch
            | Request::Cancel
            | Request::Ping => None,
            _ => Some(Program::Learner),
        }
    }

    /// Whether it is answered at once and replaces nothing.
    pub const fn is_aside(&self) -> bool {
        if let Request::Study(ask) = self {
            return ask.is_aside();
        }
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
                | Request::Decisions
                | Request::TakeDecisions { .. }
                | Request::Undo
                | Request::Redo
                | Request::Mark { .. }
                | Request::Errors
                | Request::SaveSheet { .. }
                | Request::SaveBadRows { .. }
                | Request::Look
                | Request::Checkpoint
                | Request::ModelSoFar
                | Request::PlanRuns { .. }
                | Request::JoinRuns { .. }
                | Request::Entries { .. }
                | Request::Without { .. }
                | Request::Compare { .. }
                | Request::KeepModel { .. }
        )
    }
}
