//! The state of the page that asks.

use super::action::Trouble;
use super::effect::Effect;
use super::outbox::Ending;
use crate::study::ends::Source;
use crate::study::journal::{Note, Sitting};
use crate::study::rehearse::Script;
use crate::study::{Care, Link, Study};
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Preferences;
use std::collections::{BTreeMap, BTreeSet};

/// All that the page knows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// The link that it was opened by.
    pub link: Link,
    /// The language that it is in.
    pub language: Language,
    /// What the person prefers.
    pub preferences: Preferences,
    /// Why there is no study.
    pub trouble: Option<Trouble>,
    /// The study, and where it came from.
    pub study: Option<(Box<Study>, Source)>,
    /// The study's fingerprint.
    pub fingerprint: String,
    /// The person's name: the link's, or a pseudonym.
    pub worker: Option<String>,
    /// What a participant that is simulated does.
    pub script: Option<Script>,
    /// How this tab has the sitting.
    pub hold: Hold,
    /// Whether an earlier visit was broken off where the study does not let it go on.
    pub is_refused: bool,
    /// The sitting, once it has begun.
    pub sitting: Option<Sitting>,
    /// How many notes were kept.
    pub notes: u32,
    /// The note that is being kept, before which nothing goes on.
    pub keeping: Option<Note>,
    /// The note that follows it.
    pub next: Option<Note>,
    /// What leaves the page, once the note before it is kept.
    pub leaving: Option<Effect>,
    /// Why something is not kept.
    pub fault: Option<Fault>,
    /// What is in the box, and how carefully it came there.
    pub text: String,
    /// How carefully.
    pub care: Care,
    /// The showings of which one sees what changed.
    pub pointed: Vec<usize>,
    /// The runs on view that were begun.
    pub runs: Runs,
    /// How the end at hand stands.
    pub ending: Ending,
    /// Whether the person was asked whether they are sure to withdraw.
    pub leaves: bool,
    /// How it is over, if it is.
    pub over: Option<Over>,
    /// The place that is gone to when all is erased.
    pub way_back: Option<String>,
}

/// The runs that were begun, by the places of their showings.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Runs {
    /// How many steps each has gone.
    pub gone: BTreeMap<usize, usize>,
    /// The one that is played.
    pub playing: Option<usize>,
    /// Those that were watched to their end.
    pub watched: BTreeSet<usize>,
}

/// How this tab has the sitting.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// It is being asked for.
    #[default]
    Waiting,
    /// It has it.
    Held,
    /// Another tab has it.
    Elsewhere,
}

/// How it is over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Over {
    /// All was handed over; the code, where there is one.
    Done(Option<String>),
    /// The person has withdrawn.
    Withdrawn,
}

/// What is on view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Something is still to come.
    Loading,
    /// There is no study.
    Trouble,
    /// Another tab has the sitting.
    Elsewhere,
    /// An earlier visit was broken off, and the study does not let it go on.
    Refused,
    /// What it is about, and consent.
    Welcome,
    /// What is to be done, and a worked example.
    Instructions,
    /// A turn, from 0.
    Turn(usize),
    /// An end, by its place in the study.
    End(usize),
    /// It is over.
    Over,
}

impl State {
    /// What is on view.
    pub fn stage(&self) -> Stage {
        let Some((study, _)) = &self.study else {
            return if self.trouble.is_some() { Stage::Trouble } else { Stage::Loading };
        };
        match (&self.sitting, self.hold) {
            _ if self.over.is_some() => Stage::Over,
            (_, Hold::Waiting) => Stage::Loading,
            (_, Hold::Elsewhere) => Stage::Elsewhere,
            _ if self.is_refused => Stage::Refused,
            (None, Hold::Held) => Stage::Welcome,
            (Some(sitting), Hold::Held) if !sitting.is_ready => Stage::Instructions,
            (Some(sitting), Hold::Held) => match (sitting.turn(), sitting.end(study)) {
                (Some(turn), _) => Stage::Turn(turn),
                (None, Some(end)) => Stage::End(end),
                (None, None) => Stage::Over,
            },
        }
    }

    /// Whether anything is kept and sent at all.
    pub fn is_preview(&self) -> bool {
        self.link.is_preview
    }

    /// The language of the page: what the link wants, or else the study's.
    pub fn language_of(&self, study: &Study) -> Language {
        let wanted = self.link.language.as_deref().and_then(Language::of);
        wanted.or_else(|| Language::of(&study.language)).unwrap_or(self.language)
    }
}
