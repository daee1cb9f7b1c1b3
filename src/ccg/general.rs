//! A general resource: what words that the lexicon does not know may stand for, at a price. Its targets are words of
//! a seed lexicon ("armchair" is a chair), or measures ("violet"), which have frames of their own, since no lexicon
//! lists them. What the lexicon knows of a word, above all what was learned, goes before.

use super::syntax::Syntaxes;
use crate::logic::{Terms, read};
use rustc_hash::FxHashMap;

/// What stands for a measure in a frame.
const HOLE: &str = "?:<e,n>";

/// Words and what they may stand for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct General {
    frames: Vec<Frame>,
    words: FxHashMap<Box<str>, Box<[Near]>>,
    longest: usize,
}

/// A category of measures, as text: the hole stands for the measure.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Frame {
    syntax: Box<str>,
    meaning: Box<str>,
}

/// Something that words may stand for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Near {
    /// What it is.
    pub target: Target,
    /// How far it is from what the words mean, in steps, at least one.
    pub price: u8,
}

/// What words may stand for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// A word of the lexicon.
    Word(Box<str>),
    /// A measure, by its constant `name:<e,n>`.
    Measure(Box<str>),
}

/// What is wrong with a general resource's text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {reason}")]
pub struct GeneralError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub reason: &'static str,
}

impl General {
    /// Reads a resource: frames `* :- SYNTAX : meaning`, then words, a tab and targets, each a word or a constant,
    /// with `=price` behind it if that is not 1; or a word alone, one of its own, which stands for nothing else; `#`
    /// begins a comment.
    ///
    /// # Errors
    /// With the line and what is wrong there.
    pub fn read(text: &str) -> Result<General, GeneralError> {
        let mut general = General::default();
        for (line, content) in (1..).zip(text.lines()) {
            if content.is_empty() || content.starts_with('#') {
                continue;
            }
            general.read_line(content).map_err(|reason| GeneralError { line, reason })?;
        }
        Ok(general)
    }

    fn read_line(&mut self, line: &str) -> Result<(), &'static str> {
        if let Some(category) = line.strip_prefix("* :- ") {
            self.frames.push(read_frame(category)?);
            return Ok(());
        }
        let (words, near) = match line.split_once('\t') {
            Some((words, targets)) => (words, targets.split(' ').map(read_near).collect()),
            None if line.contains(' ') => return Err("between words and targets is a tab"),
            None => (line, Ok(Box::default())),
        };
        self.longest = self.longest.max(words.split(' ').count());
        match self.words.insert(words.into(), near?) {
            Some(_) => Err("these words have a line already"),
            None => Ok(()),
        }
    }

    /// What the words, parted by spaces, may stand for, the nearest first.
    pub fn near(&self, words: &str) -> &[Near] {
        self.words.get(words).map_or(&[], |near| near)
    }

    /// Whether it knows the word at all.
    pub fn is_word(&self, word: &str) -> bool {
        self.words.contains_key(word)
    }

    /// The most words that stand for something together.
    pub fn longest(&self) -> usize {
        self.longest
    }

    /// How a measure's constant can be used: syntax and meaning, as text.
    pub fn categories(&self, constant: &str) -> impl Iterator<Item = (&str, String)> {
        let meaning = |frame: &Frame| frame.meaning.replace(HOLE, constant);
        self.frames.iter().map(move |frame| (&*frame.syntax, meaning(frame)))
    }
}

fn read_frame(text: &str) -> Result<Frame, &'static str> {
    let (syntax, meaning) =
        text.split_once(" : ").ok_or("between category and meaning stands a colon")?;
    Syntaxes::default().read(syntax).ok_or("a frame has a syntactic category")?;
    read(&mut Terms::new(), meaning).map_err(|_| "a frame's meaning is a term")?;
    if !meaning.contains(HOLE) {
        return Err("a frame has a hole ?:<e,n>");
    }
    Ok(Frame { syntax: syntax.into(), meaning: meaning.into() })
}

fn read_near(text: &str) -> Result<Near, &'static str> {
    let (target, price) = text.split_once('=').unwrap_or((text, "1"));
    let price =
        price.parse().ok().filter(|&price| price > 0).ok_or("a price is a number from 1")?;
    let target = match target.split_once(':') {
        _ if target.is_empty() => return Err("a target is a word, or name:<e,n>"),
        None => Target::Word(target.into()),
        Some((_, "<e,n>")) => Target::Measure(target.into()),
        Some(_) => return Err("a measure has type <e,n>"),
    };
    Ok(Near { target, price })
}
