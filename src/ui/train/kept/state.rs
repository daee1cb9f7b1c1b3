//! The state of what the workbench keeps.

use super::ask::Ask;
use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::copies::Item;
use crate::ui::page::keep::fault::Fault;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use std::rc::Rc;

/// The kinds of what the workbench keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Files with what was decided of their rows.
    Corpus,
    /// A training run.
    Run,
    /// What the runs of an experiment found.
    Experiment,
    /// A model.
    Model,
}

impl Kind {
    /// All of them, in order.
    pub const ALL: [Kind; 4] = [Kind::Corpus, Kind::Run, Kind::Experiment, Kind::Model];

    /// Its name in the store.
    pub const fn name(self) -> &'static str {
        match self {
            Kind::Corpus => "corpus",
            Kind::Run => "run",
            Kind::Experiment => "experiment",
            Kind::Model => "model",
        }
    }

    /// The kind of what is at a place, if it is of the workbench.
    pub fn of(place: &Place) -> Option<Kind> {
        Kind::ALL.into_iter().find(|kind| kind.name() == place.kind)
    }

    /// A place of this kind.
    pub fn place(self, name: &str) -> Place {
        Place::new(self.name(), name)
    }
}

/// All that is known of what is kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// How far the store is.
    pub stage: Stage,
    /// Why nothing is kept, or what could not be.
    pub fault: Option<Fault>,
    /// What is kept, the latest first.
    pub items: Rc<Vec<Item>>,
    /// The name of what is kept next.
    pub name: String,
    /// That a run came back, as long as that is told.
    pub came_back: Option<String>,
    /// What came of what was wanted last.
    pub notice: Option<String>,
    /// What is being read, and what for.
    pub reads: Vec<(Place, Purpose)>,
    /// A corpus that is kept under this name as soon as it is known what was decided of its rows.
    pub waits: Option<String>,
    /// What is being written.
    pub writes: Vec<Place>,
    /// How the run at work was kept last: its name, how often it was kept, and what of it.
    pub run: Option<Stamp>,
    /// The run that is open and works no more, if a person deleted it: it is not kept again by itself.
    pub deleted: Option<String>,
    /// How far it is kept, for words: the pass, and the command in it.
    pub reached: Option<(u32, usize)>,
}

/// How far the store is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stage {
    /// Nobody asked for it.
    #[default]
    Closed,
    /// It is being opened, or cannot be.
    Opening,
    /// It is open; what there is to go on with is looked for.
    Looking,
    /// Another tab keeps runs.
    Watching,
    /// This tab keeps runs.
    Keeping,
}

/// What something is read for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To go on with it, if it was at work when the page was left.
    GoOn,
    /// Since a person opens it.
    Open,
    /// Since it is seen where it was found.
    Show,
    /// As the corpus of the run that is being opened.
    Run,
    /// As that of the run that comes back by itself.
    Back,
    /// To save it as a file.
    Save,
}

/// What tells a run as it is kept from the same run later.
#[derive(Clone, Debug, PartialEq)]
pub struct Stamp {
    /// The name that it is kept under.
    pub name: String,
    /// When its checkpoint was taken.
    pub at: Option<f64>,
    /// Whether it has a model; whether it works.
    pub is_over: (bool, bool),
    /// How much had been done to its corpus when it was asked last what is decided of the rows.
    pub since: Option<usize>,
}

impl State {
    /// Has the store do something.
    pub fn ask(&mut self, desk: &mut Desk, ask: Ask) {
        desk.want(Effect::Store(ask));
    }

    /// Reads what is at a place.
    pub fn read(&mut self, desk: &mut Desk, place: Place, purpose: Purpose) {
        self.reads.push((place.clone(), purpose));
        self.ask(desk, Ask::Read(place));
    }

    /// Keeps bytes at a place.
    pub fn write(&mut self, desk: &mut Desk, place: Place, bytes: Vec<u8>) {
        self.writes.push(place.clone());
        self.ask(desk, Ask::Write(place, bytes.into()));
    }

    /// Whether something is kept at a place, or will be.
    pub fn has(&self, place: &Place) -> bool {
        let is_it = |item: &Item| item.kind == place.kind && item.name == place.name;
        self.items.iter().any(is_it) || self.writes.contains(place)
    }

    /// A name that nothing of a kind is kept under, for what is called so.
    pub fn free_name(&self, kind: Kind, called: &str) -> String {
        let mut number = 1;
        loop {
            let name = format!("{called}, {number}");
            if !self.has(&kind.place(&name)) {
                return name;
            }
            number += 1;
        }
    }

    /// What is kept of the workbench's kinds.
    pub fn own(&self) -> impl Iterator<Item = (Kind, &Item)> {
        let kind = |item: &Item| Kind::of(&Place::new(&item.kind, &item.name));
        self.items.iter().filter_map(move |item| Some((kind(item)?, item)))
    }
}
