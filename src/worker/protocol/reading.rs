//! A reading of a command in parts that a page can point at: what it says, how it was put together, what its phrases
//! refer to. Every part knows the words that carried it, as places in [`Answer::words`](super::Answer::words).

use crate::ccg;
use crate::ccg::closed::Kind as Closed;
use crate::domain::{Color, Shape, Size};
use crate::ground::{Claim, Noun, Shade};
use serde::{Deserialize, Serialize};

/// A word of a command as the parser took it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Word {
    /// The word.
    pub text: String,
    /// The known word that it was heard as, where it was taken for a misspelling of that.
    pub heard: Option<String>,
    /// What became of it in the best reading.
    pub fate: Fate,
    /// What it does, if the sentence would not mean the same without it.
    pub closed: Option<Closed>,
    /// For an unknown word: known words that are spelt nearly alike, nearest first.
    pub near: Vec<String>,
}

/// Words that were taken for another.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Taken {
    /// The place of the first, and one past the last.
    pub words: (usize, usize),
    /// The word of the lexicon that they were taken for.
    pub name: String,
}

/// What became of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fate {
    /// It has a meaning.
    Meant,
    /// It is known to mean nothing, such as "please".
    Empty,
    /// It was left out so that the rest could be understood; without a reading, what would have to be.
    Skipped,
    /// The lexicon has never seen it, and it was left out, or nothing was understood.
    Unknown,
    /// It is known, but nothing was understood.
    Idle,
}

/// One reading of a command.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reading {
    /// The goal as an s-expression.
    pub form: String,
    /// The goal as a person writes logic.
    pub formula: Vec<Piece>,
    /// What the goal says, for plain words.
    pub claim: Claim,
    /// Its score.
    pub score: f64,
    /// Its derivation: parts before what was made of them, the whole last.
    pub nodes: Vec<Node>,
    /// Its derivation as text, as the field prints it.
    pub derivation: String,
    /// The phrases that stand for something in the world, in the order of the goal, inner ones first.
    pub phrases: Vec<Phrase>,
    /// Where the thing that the goal says to move could stand, all else as it is, for the goal to hold: cells of
    /// column and row. Empty where there is no single such thing, or too much to look through.
    pub cells: Vec<(i32, i32)>,
    /// Where the robot may not stand on the way, all else as it is.
    pub forbidden: Vec<(i32, i32)>,
}

/// A piece of a formula, and the places of the words that it came from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Piece {
    /// As printed; all pieces together are the formula.
    pub text: String,
    /// The place of the words' first and one past their last; nothing for brackets and the grammar's own.
    pub words: Option<(usize, usize)>,
}

/// A constituent of a derivation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Node {
    /// The first word, and one past the last.
    pub words: (usize, usize),
    /// The rule that made it; empty for one from the lexicon.
    pub rule: String,
    /// Its syntactic category.
    pub category: String,
    /// Its meaning as a person writes logic.
    pub meaning: Vec<Piece>,
    /// Places of its parts among the nodes, from left to right.
    pub parts: Vec<usize>,
}

/// A phrase that stands for something in the world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Phrase {
    /// What it says.
    pub noun: Noun,
    /// The places of the words that carried it, in order.
    pub words: Vec<usize>,
    /// Whether it refers.
    pub refers: Refers,
    /// What it refers to; for one that fails, the things in question.
    pub referents: Vec<Referent>,
    /// For a phrase that names a shade and refers: the shade, and the colour that was taken for it.
    pub taken: Option<(Shade, Color)>,
}

/// Whether a phrase refers to exactly one thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Refers {
    /// To one thing.
    One,
    /// Nothing fits.
    None,
    /// Several things fit.
    Several,
    /// Several things are equally large, or small.
    Tie,
    /// A superlative of one thing.
    Single,
    /// A superlative of things that cannot be compared.
    Mixed,
    /// A phrase inside it does not refer.
    Inner,
}

/// A thing of the world as a person sees it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Referent {
    /// `agent`, `room`, `door` or `object`.
    pub class: String,
    /// The colour of a room or an object.
    pub color: Option<Color>,
    /// The shape of an object.
    pub shape: Option<Shape>,
    /// The size of an object that has one.
    pub size: Option<Size>,
    /// The cells that it takes up: those inside a room.
    pub cells: Vec<(i32, i32)>,
}

/// A reading explained for those who study it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Study {
    /// What its score is made of.
    pub explanation: ccg::Explanation,
    /// How the meaning of each node came about, as [`Reading::nodes`] has them: from the parts put together to the
    /// normal form, one β-step a line, each as a person writes logic. A line alone for what the lexicon gives.
    pub reductions: Vec<Vec<String>>,
}
