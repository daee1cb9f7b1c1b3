//! What a person can do about studies.

use crate::study::Flag;
use crate::ui::page::files::Offered;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Changed what the study is to be.
    Draft(Change),
    /// Wants it drawn.
    Make,
    /// Wants it saved, or packed into a link.
    Save(Saved),
    /// Opened a study's file.
    Open(Vec<Offered>),
    /// Opened files of answers.
    Answers(Vec<Offered>),
    /// Opened a file that says which value of another program's trials is what.
    Mapping(Vec<Offered>),
    /// Changed which value is what.
    Map(Value, String),
    /// Takes the trials as answers.
    Convert,
    /// Wants the robot's model asked about every answer.
    Judge,
    /// Wants a model of a file asked.
    JudgeBy(Vec<Offered>),
    /// Looks at the answers from this one on.
    From(usize),
    /// Sees only answers with this flag, or all.
    Only(Option<Flag>),
    /// Approves an answer.
    Approve(usize),
    /// Rejects an answer.
    Reject(usize),
    /// Takes a decision back.
    Reopen(usize),
    /// The reason for rejecting one by one.
    Why(String),
    /// Has the rule reject what has this flag, or not.
    Rule(Flag),
    /// Decides what is open by the rule.
    Decide,
    /// How many answers each task is to have.
    Wanted(u32),
    /// What pseudonyms are made of.
    Key(String),
    /// Leaves out what is not approved, or not.
    ApprovedOnly(bool),
    /// Takes the answers into training.
    Train,
}

/// A change of what a study is to be.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "as in a study's file")]
pub enum Change {
    Name(String),
    German(bool),
    Tasks(String),
    Pairs(u32),
    Shown(u32),
    Asked(u32),
    Seed(u32),
    Consent(String),
    Hosts(String),
    Ends(String),
    Cents(u32),
}

/// What is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Saved {
    /// The study's file.
    Study,
    /// The answers as batch results.
    Table,
    /// The answers as lines of JSON.
    Lines,
    /// The pay sheet.
    Pay,
    /// A study of what is missing.
    TopUp,
    /// The mapping of another program's trials.
    Mapping,
}

/// A value of another program's trials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it; pairs count from 0")]
pub enum Value {
    Command,
    Worker,
    Task,
    Pre(usize),
    Post(usize),
}
