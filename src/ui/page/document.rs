//! What undo and redo go through, a link carries and a restart keeps: the world, its rules, what was said in it and
//! what it came to, the model and what it was taught. Parts that do not change are shared.

use super::world::{self, WORLDS};
use crate::domain::State as World;
use crate::domain::way::MOST_ACTIONS;
use crate::worker::protocol::{
    Answer, Lesson, PairText, PlanText, Reading, RunText, TrainReport, WorldRules,
};
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// The document.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The world, but for a plan that is being played.
    pub world: World,
    /// The world as it was opened: what a reset goes back to.
    pub origin: Rc<World>,
    /// Which of [`WORLDS`] it was opened as, if it was one.
    pub preset: Option<usize>,
    /// What can happen in it.
    pub rules: WorldRules,
    /// What was said last and what came of it.
    pub said: Option<Said>,
    /// The demonstration in preparation.
    pub draft: Option<Draft>,
    /// The model before anything was taught.
    pub base: Option<Model>,
    /// What it was taught, in order.
    pub lessons: Rc<Vec<Taught>>,
    /// The model with all that.
    pub model: Option<Model>,
}

/// A command with its answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// The world it was said in.
    pub world: Rc<World>,
    /// The answer.
    pub answer: Rc<Answer>,
    /// Which reading was chosen.
    pub chosen: usize,
    /// The plan for that reading, or why there is none.
    pub plan: Option<Rc<PlanText>>,
}

impl Said {
    /// Whether nothing is done of it before the person says so: there is a question, or something was left out.
    pub fn asks_first(&self) -> bool {
        !self.answer.asks.is_empty() || self.answer.reason.is_some()
    }
}

/// A model, and where it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// What the engine says of it.
    pub report: Rc<TrainReport>,
    /// Where it came from.
    pub origin: Origin,
}

/// Where a model came from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It comes with the page.
    Shipped,
    /// It was trained here on this corpus.
    Trained(String),
    /// It was opened from a file.
    File,
}

/// A demonstration in preparation: the robot and the objects are taken to where the command should get them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Draft {
    /// Before.
    pub before: World,
    /// After, as far as it is shown.
    pub after: World,
    /// How one came to the other, a letter an action, while the robot is driven all the way.
    pub way: Option<String>,
    /// Ways from before that are not what is meant.
    pub contrasts: Vec<String>,
}

/// A command that was taught.
#[derive(Clone, Debug, PartialEq)]
pub struct Taught {
    /// The command, with its demonstration.
    pub lesson: Lesson,
    /// Whether the model understands it now.
    pub understood: bool,
}

impl Document {
    /// The document that the page opens with.
    pub fn new() -> Document {
        let world = WORLDS.first().and_then(world::Choice::open).unwrap_or_else(world::empty);
        Document {
            origin: Rc::new(world.clone()),
            world,
            preset: Some(0),
            rules: WorldRules::default(),
            said: None,
            draft: None,
            base: None,
            lessons: Rc::new(Vec::new()),
            model: None,
        }
    }

    /// Opens another world: nothing was said in it yet.
    pub fn open(&mut self, world: World, preset: Option<usize>) {
        self.origin = Rc::new(world.clone());
        self.preset = preset;
        self.change(world);
        self.draft = None;
    }

    /// The world becomes another: what was said of the one before holds no more.
    pub fn change(&mut self, world: World) {
        self.world = world;
        self.said = None;
    }

    /// The demonstration in preparation; one that begins in this world, if there is none yet.
    pub fn draft(&mut self) -> &mut Draft {
        self.draft.get_or_insert_with(|| Draft::new(self.world.clone()))
    }

    /// What it was taught, as lessons to teach again.
    pub fn taught(&self) -> Vec<Lesson> {
        self.lessons.iter().map(|taught| taught.lesson.clone()).collect()
    }

    /// The reading that was chosen.
    pub fn reading(&self) -> Option<&Reading> {
        let said = self.said.as_ref()?;
        said.answer.readings.get(said.chosen)
    }

    /// The plan for it.
    pub fn plan(&self) -> Option<&Rc<PlanText>> {
        self.said.as_ref()?.plan.as_ref()
    }
}

impl Default for Document {
    fn default() -> Document {
        Document::new()
    }
}

impl Draft {
    /// A demonstration that begins in a world.
    pub fn new(before: World) -> Draft {
        let way = Some(String::new());
        Draft { after: before.clone(), before, way, contrasts: Vec::new() }
    }

    /// Whether something is shown: a command that changes nothing means nothing.
    pub fn shows(&self) -> bool {
        self.before != self.after
    }

    /// Another world is shown; by these steps, where the robot was driven.
    pub fn show(&mut self, world: World, steps: Option<&str>) {
        self.after = world;
        let way = self.way.take().zip(steps).map(|(way, steps)| way + steps);
        self.way = way.filter(|way| way.len() <= MOST_ACTIONS);
    }

    /// Begins anew; what is not meant stays.
    pub fn clear(&mut self) {
        self.after = self.before.clone();
        self.way = Some(String::new());
    }

    /// The demonstration as a lesson.
    pub fn lesson(&self, command: String) -> Lesson {
        let (mut pairs, mut runs) = (Vec::new(), Vec::new());
        let (start, contrast) = (self.before.clone(), self.contrasts.clone());
        match self.way.clone() {
            Some(actions) => runs.push(RunText { start, actions, contrast }),
            None => pairs.push(PairText { pre: start, post: self.after.clone() }),
        }
        Lesson { command, pairs, runs, means: None }
    }
}
