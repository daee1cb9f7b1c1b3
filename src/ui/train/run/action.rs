//! What a person can do about training.

use crate::ui::page::files::Offered;
use crate::worker::protocol::{FeatureKind, Lexicon};

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Train on the corpus that is open, or go on with the run that rests.
    Go,
    /// Let the run rest as soon as it can.
    Pause,
    /// Do one more example, and rest.
    StepExample,
    /// Go to the end of the epoch, and rest.
    StepEpoch,
    /// Stop training.
    Stop,
    /// Go on with the run that was stopped.
    GoOn,
    /// Use the model as the run has it so far.
    UseSoFar,
    /// A setting is this.
    Set(Setting),
    /// What is known before is what a file says.
    OwnLexicon(Vec<Offered>),
    /// Save the curves of the run as a picture.
    SaveCurves,
    /// The paper's settings.
    Paper,
    /// Save the model that the robot uses as a file.
    SaveModel,
    /// Time for the next look at what is learned.
    Rang(u32),
}

/// A setting of a run.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "as of `Settings`")]
pub enum Setting {
    Number(Number, f64),
    Idioms(bool),
    Without(FeatureKind, bool),
    /// Nothing for what suits the corpus.
    Lexicon(Option<Lexicon>),
}

/// A setting that is a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "as of `Settings`")]
pub enum Number {
    Epochs,
    Beam,
    LexicalBeam,
    /// 0 for all.
    Demonstrations,
    Margin,
    Seed,
    Budget,
    LexicalBudget,
    Generations,
}

impl Number {
    /// All of them, each with the least and the most that it can be.
    pub const ALL: [(Number, f64, f64); 9] = [
        (Number::Epochs, 1.0, 1_000.0),
        (Number::Beam, 1.0, 10_000.0),
        (Number::LexicalBeam, 1.0, 10_000.0),
        (Number::Demonstrations, 0.0, 1_000.0),
        (Number::Margin, 0.0, 1_000.0),
        (Number::Seed, 0.0, 4_294_967_295.0),
        (Number::Budget, 1.0, 10_000_000.0),
        (Number::LexicalBudget, 1.0, 10_000_000.0),
        (Number::Generations, 0.0, 1_000.0),
    ];
}
