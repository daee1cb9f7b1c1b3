//! A training run in the engine: it learns example by example, is judged on what is held out after every epoch, and can
//! be looked at, stopped and gone on with from a checkpoint at any time.

use super::demonstration::judgement;
use super::job::{Rest, Step};
use super::progress::progress;
use super::protocol::{Checkpoint, Event};
use super::talker::report;
use crate::ccg::{ChartConfig, Model};
use crate::corpus::Example;
use crate::learn::inspect::Origins;
use crate::learn::{Judge, Look, Progress, Trainer};
use std::collections::VecDeque;

/// A run, at work or stopped.
pub(super) struct Training {
    /// Nothing once it is over.
    trainer: Option<Trainer>,
    held_out: Vec<Example>,
    judging: Option<Judging>,
    /// What there is to say before the work goes on.
    said: VecDeque<Event>,
    /// How far it was when it was last between two commands.
    at: Option<Progress>,
    /// The model that the run ended with, and the commands that its entries came from.
    ended: Option<(Model, Vec<String>)>,
    /// Where it ended.
    end: Option<Checkpoint>,
}

/// A model that is judged between two epochs.
struct Judging {
    epoch: u32,
    model: Model,
    judge: Judge,
    /// Whether it is the one that the run ends with.
    is_last: bool,
}

impl Training {
    pub(super) fn new(trainer: Trainer, held_out: Vec<Example>) -> Training {
        let (judging, said) = (None, VecDeque::new());
        let at = Some(trainer.progress());
        let trainer = Some(trainer);
        Training { trainer, held_out, judging, said, at, ended: None, end: None }
    }

    /// Does a bounded part.
    pub(super) fn step(&mut self) -> Step {
        if let Some(event) = self.said.pop_front() {
            let is_last = matches!(event, Event::Trained(_));
            return if is_last { Step::Over(event) } else { Step::Working(Some(event)) };
        }
        if let Some(judging) = &mut self.judging {
            let asked = judging.judge.scores().total;
            if let Some(example) = self.held_out.get(asked) {
                judging.judge.ask(&mut judging.model, example);
                return Step::Working(None);
            }
            return self.end_judging();
        }
        match &mut self.trainer {
            Some(trainer) if !trainer.is_done() => {
                let done = trainer.step();
                Step::Working(done.map(|done| self.progressed(done)))
            }
            _ => self.end(),
        }
    }

    /// An example was seen.
    fn progressed(&mut self, done: Progress) -> Event {
        self.at = Some(done);
        let Some(trainer) = &self.trainer else { return Event::Cancelled };
        let (config, examples) = (trainer.config(), trainer.n_examples());
        let is_epoch = done.example == examples && done.epoch <= config.epochs;
        let event = Event::Progress(progress(done, config.passes(), examples));
        // The model that a run ends with is judged by itself.
        if is_epoch && done.epoch < config.passes() && !self.held_out.is_empty() {
            let model = trainer.averaged();
            self.judge(model, done.epoch, false);
        }
        event
    }

    fn judge(&mut self, model: Model, epoch: u32, is_last: bool) {
        let judge = Judge::new(&self.held_out, ChartConfig::of(&model));
        self.judging = Some(Judging { epoch, model, judge, is_last });
    }

    fn end_judging(&mut self) -> Step {
        let Some(Judging { epoch, model, mut judge, is_last }) = self.judging.take() else {
            return Step::Working(None);
        };
        let judgement = Box::new(judgement(&judge.take_report()));
        if is_last {
            self.said.extend([Event::Trained(report(&model, model.print()))]);
            self.ended = self.ended.take().map(|(_, origins)| (model, origins));
        }
        Step::Working(Some(Event::HeldOut { epoch, judgement }))
    }

    /// The run is over: its model is judged, if there is something to judge it on, and told.
    fn end(&mut self) -> Step {
        if let Some(trainer) = self.trainer.take() {
            self.end = Some(self.checkpoint_of(&trainer));
            let (origins, passes) = (trainer.origins(), trainer.config().passes());
            let model = trainer.end();
            if self.held_out.is_empty() {
                self.said.push_back(Event::Trained(report(&model, model.print())));
                self.ended = Some((model, origins));
            } else {
                self.ended = Some((Model::default(), origins));
                self.judge(model, passes, true);
            }
            return Step::Working(None);
        }
        Step::Over(Event::Cancelled)
    }

    /// Where it may rest: between two commands, or while it is judged.
    pub(super) fn rest(&self) -> Rest {
        let Some(trainer) = self.trainer.as_ref().filter(|_| self.judging.is_none()) else {
            return Rest::Example;
        };
        let is_epoch = self.at.is_some_and(|at| at.example == trainer.n_examples());
        match (trainer.is_between(), is_epoch) {
            (false, _) => Rest::Nowhere,
            (true, true) => Rest::Epoch,
            (true, false) => Rest::Example,
        }
    }

    /// What was learned last.
    pub(super) fn look(&self) -> Option<Look> {
        self.trainer.as_ref()?.look()
    }

    /// Goes on to the end of the command at work, of which progress is told later.
    fn between(&mut self) {
        while let Some(trainer) = self.trainer.as_mut().filter(|trainer| !trainer.is_between()) {
            if let Some(done) = trainer.step() {
                let event = self.progressed(done);
                self.said.push_back(event);
            }
        }
    }

    /// A checkpoint of it, or of its end.
    pub(super) fn checkpoint(&mut self) -> Option<Checkpoint> {
        self.between();
        self.trainer
            .as_ref()
            .map(|trainer| self.checkpoint_of(trainer))
            .or_else(|| self.end.clone())
    }

    fn checkpoint_of(&self, trainer: &Trainer) -> Checkpoint {
        let (epoch, example) = self.at.map_or((1, 0), |at| (at.epoch, at.example));
        Checkpoint { text: trainer.checkpoint(), epoch, example }
    }

    /// The model so far, or the one that the run ended with.
    pub(super) fn model(&self) -> Option<Model> {
        match (&self.trainer, &self.ended) {
            (Some(trainer), _) => Some(trainer.averaged()),
            (None, Some((model, _))) => Some(model.clone()),
            (None, None) => None,
        }
    }

    /// For entries that were learned the command that each came from.
    pub(super) fn origins(&self) -> Origins {
        match (&self.trainer, &self.ended) {
            (Some(trainer), _) => Origins::new(trainer.model(), &trainer.origins()),
            (None, Some((model, origins))) => Origins::new(model, origins),
            (None, None) => Origins::default(),
        }
    }
}
