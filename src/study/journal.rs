//! What is kept of a sitting while it lasts: notes, one after another, each written when something has happened. To go on
//! is to read them again. Invariant: notes that were cut off behind any one of them make a sitting that can go on, and
//! reading one twice changes nothing.

use super::answer::{Answer, Care, FORMAT, code, short};
use super::file::Study;
use super::plan::Turn;
use serde::{Deserialize, Serialize};

/// Who takes part.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Who {
    /// Their name, or a pseudonym.
    pub worker: String,
    /// What the platform calls this turn of theirs.
    pub assignment: Option<String>,
    /// What the platform calls the whole.
    pub hit: Option<String>,
    /// Whether they are simulated; if so, whether they are careless.
    pub simulated: Option<bool>,
}

impl Who {
    /// The name of their sitting in a study: who comes again by the same link comes back to it.
    pub fn sitting(&self, study: &str) -> String {
        short(&[study, &self.worker, self.assignment.as_deref().unwrap_or_default()])
    }
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Note {
    /// Somebody agreed, and it began.
    Begun {
        /// The study's fingerprint.
        study: String,
        /// Who it is.
        who: Who,
        /// What they are asked.
        turns: Vec<Turn>,
        /// When, in milliseconds since 1970.
        at: f64,
    },
    /// The instructions and the example were read.
    Ready,
    /// Something was typed, and then nothing for a moment.
    Typed {
        /// The turn, from 0.
        turn: usize,
        /// What stands there.
        text: String,
        /// How carefully.
        care: Care,
    },
    /// A turn was answered.
    Answered {
        /// The turn, from 0.
        turn: usize,
        /// The words.
        text: String,
        /// How carefully.
        care: Care,
        /// When, in milliseconds since 1970.
        at: f64,
    },
    /// One of the study's ends was done with.
    Handed {
        /// Its place among them.
        end: usize,
    },
}

/// What was said in a turn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Said {
    /// The words.
    pub text: String,
    /// How carefully.
    pub care: Care,
    /// When it was answered, in milliseconds since 1970.
    pub at: f64,
}

/// A sitting, as its notes tell it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sitting {
    /// The study's fingerprint.
    pub study: String,
    /// Who it is.
    pub who: Who,
    /// What they are asked.
    pub turns: Vec<Turn>,
    /// Whether the instructions were read.
    pub is_ready: bool,
    /// What was answered, by turn.
    pub answers: Vec<Option<Said>>,
    /// What stands in the box of the turn at hand.
    pub draft: Said,
    /// The ends that were done with.
    pub handed: Vec<usize>,
}

impl Sitting {
    /// The sitting that notes tell; nothing before it began.
    pub fn of<'a>(notes: impl IntoIterator<Item = &'a Note>) -> Option<Sitting> {
        let mut sitting = None;
        for note in notes {
            match (note, &mut sitting) {
                (Note::Begun { study, who, turns, .. }, None) => {
                    let answers = vec![None; turns.len()];
                    let (study, who, turns) = (study.clone(), who.clone(), turns.clone());
                    sitting = Some(Sitting { study, who, turns, answers, ..Sitting::default() });
                }
                (note, Some(sitting)) => sitting.take(note),
                (_, None) => {}
            }
        }
        sitting
    }

    /// Takes in another note.
    pub fn take(&mut self, note: &Note) {
        match note {
            Note::Begun { .. } => {}
            Note::Ready => self.is_ready = true,
            Note::Typed { turn, text, care } if Some(*turn) == self.turn() => {
                self.draft = Said { text: text.clone(), care: care.clone(), at: 0.0 };
            }
            Note::Typed { .. } => {}
            Note::Answered { turn, text, care, at } => {
                if let Some(answer @ None) = self.answers.get_mut(*turn) {
                    *answer = Some(Said { text: text.clone(), care: care.clone(), at: *at });
                    self.draft = Said::default();
                }
            }
            Note::Handed { end } if !self.handed.contains(end) => self.handed.push(*end),
            Note::Handed { .. } => {}
        }
    }

    /// The first turn that is not answered.
    pub fn turn(&self) -> Option<usize> {
        self.answers.iter().position(Option::is_none)
    }

    /// Its name.
    pub fn name(&self) -> String {
        self.who.sitting(&self.study)
    }

    /// The answers so far.
    pub fn answers(&self, study: &Study) -> Vec<Answer> {
        let name = self.name();
        let all = self.turns.iter().zip(&self.answers).enumerate();
        let answer = |(at, (turn, said)): (usize, (&Turn, &Option<Said>))| {
            let (item, said) = (study.items.get(turn.item)?, said.as_ref()?);
            let shows = turn.shows.iter().filter_map(|&at| item.shows.get(at).cloned());
            let (runs, pairs) = shows.partition(|showing| showing.steps().is_some());
            Some(Answer {
                format: FORMAT.to_owned(),
                id: format!("{name}-{}", at + 1),
                command: said.text.clone(),
                task: item.task.clone(),
                worker: self.who.worker.clone(),
                pairs,
                runs,
                study: self.study.clone(),
                item: item.id.clone(),
                turn: [at + 1, self.turns.len()],
                assignment: self.who.assignment.clone(),
                hit: self.who.hit.clone(),
                at: said.at,
                care: said.care.clone(),
                simulated: self.who.simulated,
            })
        };
        all.filter_map(answer).collect()
    }

    /// The completion code, which is derived from the answers.
    pub fn code(&self, study: &Study) -> String {
        code(&self.study, &self.answers(study))
    }

    /// The first end that is still to come.
    pub fn end(&self, study: &Study) -> Option<usize> {
        (0..study.ends.len()).find(|end| !self.handed.contains(end))
    }
}
