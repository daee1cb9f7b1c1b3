//! What a person can do with the corpus.

use super::mapping::Column;
use crate::ui::page::files::Offered;
use crate::worker::protocol::{Form, Half, Outcome, Rule, Sort, Split, Status};

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Files were chosen or dropped: corpora, or something for the robot.
    Offered(Vec<Offered>),
    /// Go back to the page's own six sentences.
    OpenDemo,
    /// Use the rows that were rejected, or no more.
    UseRejected,
    /// Stop what is at work on the corpus.
    Stop,
    /// Save the corpus, with what was decided, in this form or its own.
    SaveCorpus(Option<Form>),
    /// Save the bad rows of a file.
    SaveBadRows(u32),
    /// Look at rows.
    Look(Look),
    /// Decide something of rows.
    Care(Care),
    /// Map columns by hand.
    Map(Map),
}

/// Looking at rows.
#[derive(Clone, Debug, PartialEq)]
pub enum Look {
    /// For these words.
    Text(String),
    /// Of a task.
    Task(Option<String>),
    /// Of a person.
    Worker(Option<String>),
    /// With this decision.
    Status(Option<Status>),
    /// Of which the model makes this.
    Outcome(Option<Outcome>),
    /// That a rule marks.
    Rule(Option<Rule>),
    /// In this half.
    Half(Option<Half>),
    /// All of them.
    All,
    /// Sorted so; the same once more turns the order round.
    Sort(Sort),
    /// These are in sight: the first, and how many.
    Scrolled(u32, u32),
    /// The keyboard goes so many rows on.
    Move(i64),
    /// The keyboard goes to the first or the last row.
    End(bool),
    /// Open the row at a place of the view, or close it.
    Open(u32),
    /// Open the row that the keyboard is at, or close it.
    OpenHere,
    /// Pick the row that the keyboard is at, or no more.
    PickHere,
    /// Open this row, whatever was looked at before.
    Row(u32),
    /// Close the row that is open.
    Close,
    /// Pick a row, or no more.
    Pick(u32, bool),
    /// Pick none.
    PickNone,
}

/// Deciding something of rows.
#[derive(Clone, Debug, PartialEq)]
pub enum Care {
    /// They are good.
    Approve,
    /// They are not to be used, for a reason.
    Reject(String),
    /// As if nobody had looked at them.
    Reopen,
    /// They are in this half.
    Put(Half),
    /// Part the corpus.
    Divide(Split),
    /// Hold out all of a file.
    HoldOut(u32),
    /// Take the last change back.
    Undo,
    /// Do what was undone again.
    Redo,
    /// Mark rows by rules that need no model.
    Mark,
    /// Ask the robot's model about every row, and mark rows by all rules.
    Audit,
}

/// Mapping columns by hand.
#[derive(Clone, Debug, PartialEq)]
pub enum Map {
    /// Begin: with the files that were refused, or those that are open.
    Begin,
    /// A column is this.
    Choose(usize, Column),
    /// Read the files so.
    Use,
    /// Save the mapping as a file.
    Save,
    /// Leave it.
    Leave,
}
