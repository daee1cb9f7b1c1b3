//! The state of training.

use super::action::{Number, Setting};
use super::clock::Clock;
use super::curve::Point;
use crate::ui::train::desk::Desk;
use crate::worker::protocol::{Lexicon, Look, Progress, Settings};
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// All that is known of training.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// The settings of the next run.
    pub settings: Settings,
    /// What is known before, if a person chose it.
    pub lexicon: Option<Lexicon>,
    /// A lexicon of the person's own: the name of its file, and its text.
    pub own: Option<(String, String)>,
    /// The run at work, or the last one.
    pub run: Option<Run>,
    /// A run that was kept and is opened: its corpus is being read.
    pub coming: Option<Run>,
    /// What came of training, when it is not a model.
    pub notice: Option<String>,
    /// Tells the timer that counts.
    pub timer: u32,
}

/// A run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Its settings.
    pub settings: Settings,
    /// The name of its corpus.
    pub corpus: String,
    /// The name that its corpus is kept under.
    pub pack: String,
    /// The name that it is kept under itself; empty as long as it is not.
    pub name: String,
    /// What was decided of the rows when it began, once that is known.
    pub decisions: Option<String>,
    /// What is decided of them now that it works no more, if that is something else; and how much had been done to the
    /// corpus by then.
    pub since: Option<(String, usize)>,
    /// How it goes.
    pub pace: Pace,
    /// How far it is.
    pub progress: Option<Progress>,
    /// What it did, epoch by epoch.
    pub points: Rc<Vec<Point>>,
    /// What it learned last.
    pub look: Option<Rc<Look>>,
    /// Its clock.
    pub clock: Clock,
    /// Where it can go on from, and when that was.
    pub checkpoint: Option<(String, f64)>,
    /// The model that it ended with.
    pub model: Option<Rc<str>>,
    /// Whether a new engine was started for it, and it has not gone on yet.
    pub is_retried: bool,
}

/// How a run goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Pace {
    /// It works.
    Goes,
    /// It is asked to rest.
    Pauses,
    /// It rests.
    Rests,
    /// It was stopped.
    Stopped,
    /// It is over.
    Over,
}

impl Run {
    /// A run that begins.
    pub fn new(settings: Settings, corpus: String, pack: String) -> Run {
        Run {
            settings,
            corpus,
            pack,
            name: String::new(),
            decisions: None,
            since: None,
            model: None,
            pace: Pace::Goes,
            progress: None,
            points: Rc::default(),
            look: None,
            clock: Clock::default(),
            checkpoint: None,
            is_retried: false,
        }
    }

    /// Whether it works no more.
    pub const fn is_still(&self) -> bool {
        matches!(self.pace, Pace::Stopped | Pace::Over)
    }
}

impl State {
    /// The settings of the next run on a corpus that this lexicon suits.
    pub fn settings(&self, suits: Lexicon) -> Settings {
        let lexicon = self.lexicon.clone().unwrap_or(suits);
        Settings { lexicon, ..self.settings.clone() }
    }

    /// Whether the settings are the paper's.
    pub fn is_paper(&self) -> bool {
        self.settings == Settings::default() && self.lexicon.is_none()
    }

    /// The value of a setting.
    pub fn number(&self, number: Number) -> f64 {
        let settings = &self.settings;
        match number {
            Number::Epochs => settings.epochs.into(),
            Number::Beam => settings.beam.into(),
            Number::LexicalBeam => settings.lexical_beam.into(),
            Number::Demonstrations => settings.demonstrations.unwrap_or(0).into(),
            Number::Margin => settings.margin,
            Number::Seed => settings.seed.into(),
            Number::Budget => settings.budget.into(),
            Number::LexicalBudget => settings.lexical_budget.into(),
            Number::Generations => settings.generations.into(),
        }
    }

    /// A setting is this.
    pub fn set(&mut self, setting: Setting) {
        let settings = &mut self.settings;
        match setting {
            Setting::Number(number, value) => {
                // What is no whole number, or out of its range, is the nearest that is.
                let whole = value as u32;
                match number {
                    Number::Epochs => settings.epochs = whole,
                    Number::Beam => settings.beam = whole,
                    Number::LexicalBeam => settings.lexical_beam = whole,
                    Number::Demonstrations => {
                        settings.demonstrations = (whole > 0).then_some(whole);
                    }
                    Number::Margin => settings.margin = value,
                    Number::Seed => settings.seed = whole,
                    Number::Budget => settings.budget = whole,
                    Number::LexicalBudget => settings.lexical_budget = whole,
                    Number::Generations => settings.generations = whole,
                }
            }
            Setting::Idioms(idioms) => settings.idioms = idioms,
            Setting::Without(kind, without) => {
                settings.without.retain(|other| *other != kind);
                if without {
                    settings.without.push(kind);
                    settings.without.sort();
                }
            }
            Setting::Lexicon(lexicon) => self.lexicon = lexicon,
        }
    }

    /// The run at work, if there is one.
    pub fn live(&self) -> Option<&Run> {
        self.run.as_ref().filter(|run| !run.is_still())
    }
}

/// Whether training on so many commands can begin: at once, as a step that is asked for is one of what is at work.
pub fn can_train(desk: &Desk, commands: usize) -> bool {
    commands > 0 && desk.is_ready() && !desk.learner.is_at(|_| true)
}
