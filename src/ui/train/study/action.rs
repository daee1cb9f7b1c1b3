//! What a person can do about studies.

use crate::study::Flag;
use crate::study::file::{Again, Order};
use crate::ui::page::files::Offered;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Changed what the study is to be.
    Draft(Change),
    /// Wants it drawn.
    Make,
    /// Wants something saved.
    Save(Saved),
    /// The study was packed into a link, or is too much for one.
    Linked(Option<String>),
    /// Chose one of the usual ways to end.
    Way(Way),
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
    /// Approves an answer, by its name.
    Approve(String),
    /// Rejects an answer.
    Reject(String),
    /// Looks at the pairs of an answer, or no more.
    Look(String),
    /// Takes a decision back.
    Reopen(String),
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
    /// Stops what the engine is doing for studies; files that wait are not read.
    Stop,
}

/// A change of what a study is to be.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "as in a study's file")]
pub enum Change {
    Name(String),
    German(bool),
    Tasks(String),
    Pairs(u32),
    Ways(bool),
    /// The task of a check, by the check's place; nothing for none.
    Check(usize, String),
    /// The words that an answer to it must have.
    Must(usize, String),
    Shown(u32),
    Asked(u32),
    Seed(u32),
    /// What the page says at a place, in words of one's own.
    Says(Place, String),
    Order(Order),
    Again(Again),
    Hosts(String),
    Ends(String),
    Cents(u32),
}

/// Where the page that asks says something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[expect(missing_docs, reason = "as in a study's file")]
pub enum Place {
    Welcome,
    Consent,
    Instructions,
    /// What is said of the worked example, which is drawn.
    Example,
    Thanks,
}

impl Place {
    /// All of them, in the order in which they are read.
    pub const ALL: [Place; 5] =
        [Place::Welcome, Place::Consent, Place::Instructions, Place::Example, Place::Thanks];

    /// The name of its field.
    pub const fn id(self) -> &'static str {
        match self {
            Place::Welcome => "study-welcome",
            Place::Consent => "study-consent",
            Place::Instructions => "study-instructions",
            Place::Example => "study-example",
            Place::Thanks => "study-thanks",
        }
    }
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

/// A usual way to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// A code, and a file to send.
    File,
    /// An endpoint of one's own, and a code.
    Endpoint,
    /// An endpoint of one's own, and the link back to Prolific.
    Prolific,
    /// The form of a frame's platform.
    Frame,
}

impl Way {
    /// All of them.
    pub const ALL: [Way; 4] = [Way::File, Way::Endpoint, Way::Prolific, Way::Frame];

    /// Its ends as JSON, and the hosts that they need.
    pub const fn ends(self) -> [&'static str; 2] {
        match self {
            Way::File => [r#"["code", "file"]"#, ""],
            Way::Endpoint => [
                r#"[{"endpoint": {"url": "https://example.org/answers", "key": ""}}, "code"]"#,
                "https://example.org",
            ],
            Way::Prolific => [
                r#"[{"endpoint": {"url": "https://example.org/answers", "key": ""}}, {"return": {"url": "https://app.prolific.com/submissions/complete?cc={code}"}}]"#,
                "https://example.org",
            ],
            Way::Frame => {
                [r#"[{"form": {}}]"#, "https://www.mturk.com https://workersandbox.mturk.com"]
            }
        }
    }
}
