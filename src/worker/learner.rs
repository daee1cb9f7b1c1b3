//! The program that learns: reads corpora, trains, teaches, runs experiments. The page loads it when there is something
//! to be learned; what it learns goes to the talker as a model file.

use super::demonstration::Demonstrating;
use super::job::{Job, Rest, Role, Step, misdirected};
use super::progress::{CorpusReading, Read};
use super::protocol::{
    Event, FileReport, MappedFile, Program, Request, Rules, Settings, SheetReport, StudyAsk,
};
use super::review::{self, Reviewing};
use super::shard;
use super::study;
use super::teaching::teach;
use super::training::Training;
use crate::ccg::Model;
use crate::corpus::Example;
use crate::learn::asking::{Answered, Asking};
use crate::learn::audit::Audit;
use crate::learn::experiment::Selection;
use crate::learn::fingerprint::fingerprint;
use crate::learn::sheet::{Half, Sheet, Source, decided};
use crate::learn::{Config, Trainer};

/// What the learner keeps.
#[derive(Default)]
pub struct Learner {
    pub(super) sheet: Sheet,
    /// The files that were read last, good or not.
    pub(super) read: Vec<Source>,
    /// The run at work, or the last one.
    pub(super) training: Option<Training>,
    /// The model that was asked about the rows.
    pub(super) audit: Option<Audit>,
    /// Whether something was learned behind that.
    pub(super) is_audit_old: bool,
    /// A model that was given for what it knows.
    pub(super) given: Option<Model>,
    /// Answers to a study.
    pub(super) review: Reviewing,
    /// Whether it is the run that is at work.
    is_training: bool,
}

impl Role for Learner {
    const PROGRAM: Program = Program::Learner;

    fn begin(&mut self, request: Request) -> Result<Job<Learner>, String> {
        self.is_training = matches!(request, Request::Learn { .. } | Request::Recall { .. });
        match request {
            Request::OpenSheet { files, with_rejected } => Ok(open_sheet(files, with_rejected)),
            Request::Learn { settings, resume } => self.learn(&settings, resume.as_deref()),
            Request::Recall { settings, decisions, checkpoint } => {
                self.recall(&settings, &decisions, &checkpoint)
            }
            Request::Audit { model, rules, known } => self.audit(model.as_deref(), rules, known),
            Request::AskPart { model, part, of } => ask_part(&self.sheet, &model, part, of),
            Request::RunShard { plan, runs } => shard::run(&self.sheet, &plan, runs),
            Request::Study(StudyAsk::Make { study, tasks, pairs, has_ways, checks }) => {
                study::make(study::Wanted { study, tasks, pairs, has_ways, checks })
            }
            Request::Study(ask) => review::begin(self, ask),
            Request::Teach { model, examples } => teach(&model, examples),
            Request::Demonstrate { command, state, settings } => {
                let config = self.config(&settings)?;
                let (seed, corpus) = (settings.seed_model()?, selection(&self.sheet, Half::Train));
                let mut work = Demonstrating::new(command, state, (seed, corpus, config));
                Ok(Box::new(move |_| work.step()))
            }
            other => Err(misdirected(&other, Self::PROGRAM)),
        }
    }

    fn answer(&mut self, request: Request) -> Result<Event, String> {
        self.answer_aside(request)
    }

    fn rest(&self) -> Rest {
        let training = self.training.as_ref().filter(|_| self.is_training);
        training.map_or(Rest::Example, Training::rest)
    }
}

impl AsMut<Reviewing> for Learner {
    fn as_mut(&mut self) -> &mut Reviewing {
        &mut self.review
    }
}

impl Learner {
    /// Keeps what was read, if there is anything.
    fn keep(&mut self, read: Read, with_rejected: bool) {
        self.read.clone_from(&read.sources);
        if !read.examples.is_empty() {
            self.sheet = Sheet::new(read.sources, read.examples, with_rejected);
            (self.training, self.audit) = (None, None);
        }
    }

    fn learn(&mut self, settings: &Settings, resume: Option<&str>) -> Result<Job<Learner>, String> {
        let config = self.config(settings)?;
        let train = selection(&self.sheet, Half::Train).examples();
        let trainer = match resume {
            None => Trainer::new(settings.seed_model()?, &train, config),
            Some(text) => resumed(text, &train, config)?,
        };
        let held_out = selection(&self.sheet, Half::HeldOut).examples();
        Ok(self.train(Training::new(trainer, held_out)))
    }

    /// A run that is over, on the rows that it learned from: those of the sheet may be others by now.
    fn recall(
        &mut self,
        settings: &Settings,
        decisions: &str,
        checkpoint: &str,
    ) -> Result<Job<Learner>, String> {
        let mut sheet = self.sheet.clone();
        decided::take(&mut sheet, decisions)
            .map_err(|wrong| format!("The decisions cannot be read: {wrong}."))?;
        let train = selection(&sheet, Half::Train).examples();
        let trainer = resumed(checkpoint, &train, settings.config()?)?;
        Ok(self.train(Training::new(trainer, Vec::new())))
    }

    /// Has a run be at work.
    fn train(&mut self, training: Training) -> Job<Learner> {
        (self.training, self.is_audit_old) = (Some(training), true);
        Box::new(|learner| match &mut learner.training {
            Some(training) => training.step(),
            None => Step::Over(Event::Cancelled),
        })
    }

    fn audit(
        &mut self,
        model: Option<&str>,
        rules: Rules,
        known: Vec<Answered>,
    ) -> Result<Job<Learner>, String> {
        let model = match model {
            Some(text) => read(text)?,
            None => {
                let trained = self.training.as_ref().and_then(Training::model);
                let known = || self.audit.as_ref().map(|audit| audit.model().clone());
                trained.or_else(known).ok_or("There is no model yet: train one, or open one.")?
            }
        };
        let examples = self.sheet.examples().clone();
        self.sheet.forget_outcomes();
        (self.audit, self.is_audit_old) = (Some(Audit::new(model, examples, known)), false);
        Ok(Box::new(move |learner| {
            let Learner { audit: Some(audit), sheet, .. } = learner else {
                return Step::Over(Event::Cancelled);
            };
            if audit.is_over() {
                sheet.mark(rules);
                return Step::Over(Event::Care(sheet.care(None)));
            }
            let Some(Answered { rows, form, .. }) = audit.step() else {
                return Step::Working(None);
            };
            for (row, outcome) in rows {
                sheet.judged(row, outcome, form.as_deref());
            }
            let (done, of) = audit.progress();
            Step::Working(Some(Event::Auditing { done: done as u32, of: of as u32 }))
        }))
    }

    /// The settings of a run on the corpus that is kept, or why there can be none.
    fn config(&self, settings: &Settings) -> Result<Config, String> {
        if self.sheet.is_empty() {
            return Err("There is nothing to learn from: load a corpus first.".to_owned());
        }
        if selection(&self.sheet, Half::Train).is_empty() {
            return Err("There is nothing to learn from: no row is used.".to_owned());
        }
        settings.config()
    }
}

/// The rows of a half that are used.
fn selection(sheet: &Sheet, half: Half) -> Selection {
    let (corpus, rows) = (sheet.examples(), sheet.rows_in(half));
    match rows.len() == corpus.len() {
        true => Selection::all(corpus),
        false => Selection::of(corpus, rows),
    }
}

fn read(model: &str) -> Result<Model, String> {
    Model::read(model).map_err(|error| format!("The model cannot be read: {error}."))
}

/// A model is asked a part of the commands of a sheet.
fn ask_part(sheet: &Sheet, model: &str, part: u32, of: u32) -> Result<Job<Learner>, String> {
    let mut asking = Asking::new(read(model)?, sheet.examples().clone());
    asking.retain(|at| at % of.max(1) == part);
    let (mut commands, mut done, of) = (Vec::new(), 0, asking.n_rows() as u32);
    Ok(Box::new(move |_| {
        if asking.is_over() {
            return Step::Over(Event::Answered { commands: std::mem::take(&mut commands) });
        }
        let Some(answered) = asking.step() else { return Step::Working(None) };
        done += answered.rows.len() as u32;
        commands.push(answered);
        Step::Working(Some(Event::Auditing { done, of }))
    }))
}

/// A run that goes on from a checkpoint.
fn resumed(checkpoint: &str, train: &[Example], config: Config) -> Result<Trainer, String> {
    let model = Model::read(checkpoint)
        .map_err(|error| format!("The checkpoint cannot be read: {error}."))?;
    Trainer::resume(model, train, config).map_err(|error| format!("The run cannot go on: {error}."))
}

fn open_sheet(files: Vec<MappedFile>, with_rejected: bool) -> Job<Learner> {
    let mut reading = CorpusReading::new(files);
    let mut told = 0;
    Box::new(move |learner| match reading.step() {
        Some(read) => Step::Over(opened(learner, read, with_rejected)),
        None => {
            let (done, of) = reading.progress();
            let is_news = std::mem::replace(&mut told, done) < done && done < of;
            Step::Working(is_news.then_some(Event::Reading { done, of }))
        }
    })
}

/// Files were read: they are the sheet, if they have rows.
fn opened(learner: &mut Learner, read: Read, with_rejected: bool) -> Event {
    let files = read.sources.iter().zip(&read.useless);
    let files = files.map(|(source, useless)| FileReport {
        name: source.name.clone(),
        rows: source.rows as u32,
        left_out: source.left_out as u32,
        bad_rows: source.bad.kept as u32,
        mapping: source.mapping.clone(),
        useless: useless.clone(),
    });
    let (files, faults) = (files.collect(), read.faults());
    learner.keep(read, with_rejected);
    let care = learner.sheet.care(None);
    let corpus = fingerprint(learner.sheet.examples());
    Event::Sheet(Box::new(SheetReport { files, faults, care, corpus }))
}
