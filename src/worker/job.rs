//! The engine: what it keeps (a corpus, a model) and the one job at work. A job is pumped step by step by whoever
//! owns the engine: the page's worker, tests and benches alike; a step does a bounded amount of work.

use super::ask::{Asked, Asking};
use super::experiment;
use super::plan::{Begun, Planned, Planning};
use super::protocol::{
    CorpusReport, Event, Experiment, Lesson, MOST_RUNS, MOST_TAUGHT, PairText, Problem, Progress,
    Request, RowSummary, SeedLexicon, TeachReport, TrainReport, TrainSettings, WorldRules,
};
use super::read::studies;
use super::watch::{Rolling, Valuing};
use super::world;
use crate::ccg::{EntryText, Model};
use crate::corpus::{Corpus, Example, Flaw, Form, Options, Pair, Rows};
use crate::domain::State;
use crate::ground::Goal;
use crate::learn::{
    self, CLEANUP_LEXICON, Config, DEMONSTRATION_LEXICON, Taught, Teaching, Trainer, seed_model,
};
use crate::logic::{Terms, read};
use std::collections::VecDeque;
use std::io::Cursor;
use std::rc::Rc;

/// Rows that a step reads.
pub(super) const ROWS_A_STEP: usize = 4;

const NO_EXPERIMENTS: &str =
    "This engine runs no experiments: `groundling experiment` on the command line does.";

const NO_PLAN: &str = "There is no plan to go by: ask for something first.";

const NO_MODEL: &str = "There is no model yet: train one, or open a model file.";

/// Work in parts. Every [`Engine::step`] does a bounded part; the job is over when it returns a last event.
enum Job {
    /// Nothing but an answer.
    Say(Event),
    /// A corpus is read.
    Read { name: String, rows: Box<Rows<Cursor<Vec<u8>>>>, corpus: Corpus, flaws: Vec<Flaw> },
    /// A parser is learned.
    Train(Box<Trainer>),
    /// A parser is taught something besides.
    Teach(Box<Teaching>),
    /// A command is answered.
    Ask(Box<Asking>),
    /// A goal is planned for.
    Plan(Box<Planning>),
    /// The cells are valued.
    Value(Box<Valuing>),
    /// A policy is followed many times.
    RollOut(Box<Rolling>),
    /// An experiment is run.
    Experiment(Box<dyn Work>),
}

/// Work that not every program of ours has.
pub(super) trait Work {
    /// Does a bounded part, and says what there is to say of it.
    fn step(&mut self) -> Option<Event>;
    /// Whether all is said.
    fn is_over(&self) -> bool;
}

/// Begins an experiment, or says why it cannot.
type Begin = fn(Experiment, &[Example], Config) -> Result<Box<dyn Work>, String>;

/// What the engine knows and what it is at.
#[derive(Default)]
pub struct Engine {
    corpus: Corpus,
    model: Option<Model>,
    planned: Option<Rc<Planned>>,
    experiments: Option<Begin>,
    work: Option<(u32, Job)>,
    /// What must still be said before the work goes on: answers that take no work, and the ends of requests.
    said: VecDeque<(u32, Event)>,
}

impl Engine {
    /// An engine that knows nothing, and runs no experiments: the page's, which should come soon.
    pub fn new() -> Engine {
        Engine::default()
    }

    /// An engine that runs experiments, too.
    pub fn with_experiments() -> Engine {
        Engine { experiments: Some(experiment::begin), ..Engine::default() }
    }

    /// Takes a request; what was at work is cancelled, and what it would have replaced stays.
    pub fn start(&mut self, id: u32, request: Request) {
        if request == Request::Ping {
            return self.said.push_back((id, Event::Pong));
        }
        self.said.extend(self.work.take().map(|(id, _)| (id, Event::Cancelled)));
        let job = match request {
            Request::ReadCorpus { name, text } => read_corpus(name, text),
            Request::ShowRow { row } => Job::Say(self.show_row(row)),
            Request::Train { lexicon, settings } => self.train(lexicon, &settings),
            Request::Teach { examples } => self.teach(examples),
            Request::OpenModel { text } => Job::Say(self.open_model(text)),
            Request::Ask { command, state, rules } => match &self.model {
                Some(_) => match state.check() {
                    Ok(()) => Job::Ask(Box::new(Asking::new(command, state, rules))),
                    Err(error) => refuse(&error.to_string()),
                },
                None => refuse(NO_MODEL),
            },
            Request::Plan { form, state, rules } => plan(&form, &state, &rules),
            Request::Values { state } => match &self.planned {
                Some(planned) => match Valuing::new(planned.clone(), &state) {
                    Some(valuing) => Job::Value(Box::new(valuing)),
                    None => refuse("The plan that is kept is for another world: plan again."),
                },
                None => refuse(NO_PLAN),
            },
            Request::RollOut { runs, seed } => match &self.planned {
                Some(_) if !(1..=MOST_RUNS).contains(&runs) => {
                    refuse(&format!("Ask for between 1 and {MOST_RUNS} runs."))
                }
                Some(planned) => Job::RollOut(Box::new(Rolling::new(planned.clone(), runs, seed))),
                None => refuse(NO_PLAN),
            },
            Request::Explain { command } => match &mut self.model {
                Some(model) => Job::Say(Event::Explained(studies(model, &command))),
                None => refuse(NO_MODEL),
            },
            Request::Draw { blueprint, seed } => Job::Say(world::draw(&blueprint, seed)),
            Request::ReadWorld { text } => Job::Say(world::read(&text)),
            Request::WriteWorld { state } => Job::Say(world::write(&state)),
            Request::Experiment { experiment, settings } => match self.experiments {
                Some(begin) => {
                    let config = self.config(&settings);
                    match config.and_then(|c| begin(experiment, &self.corpus.examples, c)) {
                        Ok(work) => Job::Experiment(work),
                        Err(message) => refuse(&message),
                    }
                }
                None => refuse(NO_EXPERIMENTS),
            },
            Request::Cancel | Request::Ping => return,
        };
        self.work = Some((id, job));
    }

    /// Whether there is something to step.
    pub fn busy(&self) -> bool {
        !self.said.is_empty() || self.work.is_some()
    }

    /// Does a bounded part of the work; what there is to say of it, with the id of its request.
    pub fn step(&mut self) -> Option<(u32, Event)> {
        if let Some(said) = self.said.pop_front() {
            return Some(said);
        }
        let (id, job) = self.work.take()?;
        let (event, job) = self.advance(job);
        self.work = job.map(|job| (id, job));
        event.map(|event| (id, event))
    }

    /// One step of a job: what it says, and the job if it is not over.
    fn advance(&mut self, job: Job) -> (Option<Event>, Option<Job>) {
        match job {
            Job::Say(event) => {
                // A goal that needed no search has no policy.
                if matches!(event, Event::Planned(_)) {
                    self.planned = None;
                }
                (Some(event), None)
            }
            Job::Read { name, mut rows, mut corpus, mut flaws } => {
                for _ in 0..ROWS_A_STEP {
                    match rows.next() {
                        Some(row) => flaws.extend(corpus.add(row)),
                        None => return (Some(self.keep_corpus(name, corpus, flaws)), None),
                    }
                }
                (None, Some(Job::Read { name, rows, corpus, flaws }))
            }
            Job::Train(mut trainer) => {
                let said = trainer.step().map(|done| {
                    let (epochs, examples) = (trainer.config().epochs, trainer.n_examples());
                    Event::Progress(progress(done, epochs, examples))
                });
                if trainer.is_done() && said.is_none() {
                    return (Some(self.keep_model(*trainer)), None);
                }
                (said, Some(Job::Train(trainer)))
            }
            Job::Teach(mut teaching) => {
                if teaching.is_done() {
                    return (Some(self.keep_taught(teaching.end())), None);
                }
                teaching.step();
                (None, Some(Job::Teach(teaching)))
            }
            Job::Ask(mut asking) => match &mut self.model {
                Some(model) => match asking.step(model) {
                    Asked::Working(progress) => {
                        (progress.map(Event::Planning), Some(Job::Ask(asking)))
                    }
                    Asked::Answered(answer, planned) => {
                        self.planned = planned.map(Rc::new);
                        (Some(Event::Answer(answer)), None)
                    }
                    Asked::Failed(error) => {
                        (Some(Event::Refused { message: error.to_string() }), None)
                    }
                },
                None => (Some(Event::Cancelled), None),
            },
            Job::Plan(mut planning) => match planning.step() {
                Some(plan) => {
                    self.planned = Some(Rc::new(planning.into_planned()));
                    (Some(Event::Planned(Box::new(plan))), None)
                }
                None => (planning.news().map(Event::Planning), Some(Job::Plan(planning))),
            },
            Job::Value(mut valuing) => match valuing.step() {
                Some(map) => (Some(Event::Values(map)), None),
                None => (None, Some(Job::Value(valuing))),
            },
            Job::RollOut(mut rolling) => match rolling.step() {
                Some((runs, true)) => (Some(Event::RolledOut(runs)), None),
                said => (said.map(|s| Event::RollingOut(s.0)), Some(Job::RollOut(rolling))),
            },
            Job::Experiment(mut work) => {
                let said = work.step();
                let over = work.is_over();
                (said, (!over).then_some(Job::Experiment(work)))
            }
        }
    }

    fn keep_corpus(&mut self, name: String, corpus: Corpus, flaws: Vec<Flaw>) -> Event {
        let rows = corpus.examples.iter().map(|example| RowSummary {
            command: example.command.clone(),
            task: example.task.clone(),
            pairs: example.pairs.len(),
        });
        let report = CorpusReport {
            name,
            rows: rows.collect(),
            rejected: corpus.rejected,
            problems: flaws.into_iter().map(problem).collect(),
        };
        if !corpus.examples.is_empty() {
            self.corpus = corpus;
        }
        Event::Corpus(report)
    }

    fn show_row(&self, row: usize) -> Event {
        match self.corpus.examples.get(row) {
            Some(example) => {
                let pairs = example.pairs.iter();
                let pairs = pairs.map(|p| PairText { pre: p.pre.clone(), post: p.post.clone() });
                Event::Row { row, pairs: pairs.collect() }
            }
            None => Event::Refused { message: format!("The corpus has no row {row}.") },
        }
    }

    fn train(&self, lexicon: SeedLexicon, settings: &TrainSettings) -> Job {
        let config = match self.config(settings) {
            Ok(config) => config,
            Err(message) => return refuse(&message),
        };
        let lexicon = match lexicon {
            SeedLexicon::Demonstration => DEMONSTRATION_LEXICON,
            SeedLexicon::Domain => CLEANUP_LEXICON,
        };
        match seed_model(lexicon) {
            Ok(seed) => Job::Train(Box::new(Trainer::new(seed, &self.corpus.examples, config))),
            Err(error) => refuse(&format!("The seed lexicon cannot be read: {error}.")),
        }
    }

    fn teach(&self, lessons: Vec<Lesson>) -> Job {
        let Some(model) = self.model.clone() else { return refuse(NO_MODEL) };
        if lessons.is_empty() || lessons.len() > MOST_TAUGHT {
            return refuse(&format!("Teach between 1 and {MOST_TAUGHT} commands at once."));
        }
        if let Some(bare) = lessons.iter().find(|lesson| lesson.pairs.is_empty()) {
            return refuse(&format!("Show what to do when one says {:?}.", bare.command));
        }
        let examples: Vec<Example> = lessons.into_iter().map(example).collect();
        let config = Config { demonstrations: None, ..Config::of(&model) };
        match Teaching::new(model, &examples, config) {
            Ok(teaching) => Job::Teach(Box::new(teaching)),
            Err(error) => refuse(&format!("The model cannot be taught: {error}.")),
        }
    }

    fn keep_taught(&mut self, taught: Taught) -> Event {
        let Taught { model, entries, understood } = taught;
        let added = entries.into_iter().map(|id| EntryText::of(&model, id)).collect();
        let report = train_report(&model, model.print());
        self.model = Some(model);
        Event::Taught(Box::new(TeachReport { model: report, added, understood }))
    }

    /// The settings of a run on the corpus that is kept, or why there can be none.
    fn config(&self, settings: &TrainSettings) -> Result<Config, String> {
        if self.corpus.examples.is_empty() {
            return Err("There is nothing to learn from: load a corpus first.".to_owned());
        }
        let limits = [
            ("epochs", settings.epochs, 1..=1_000),
            ("beam", settings.beam, 1..=10_000),
            ("lexical beam", settings.lexical_beam, 1..=10_000),
            ("demonstrations", settings.demonstrations.unwrap_or(1), 1..=1_000),
        ];
        for (name, value, range) in limits {
            if !range.contains(&value) {
                let (least, most) = range.into_inner();
                return Err(format!("The {name} must be between {least} and {most}."));
            }
        }
        Ok(Config {
            epochs: settings.epochs,
            beam: settings.beam,
            lexical_beam: settings.lexical_beam,
            demonstrations: settings.demonstrations,
            seed: settings.seed,
            ..Config::default()
        })
    }

    fn keep_model(&mut self, trainer: Trainer) -> Event {
        let model = trainer.averaged();
        let report = train_report(&model, model.print());
        self.model = Some(model);
        Event::Trained(report)
    }

    fn open_model(&mut self, text: String) -> Event {
        match Model::read(&text) {
            Ok(model) => {
                let report = train_report(&model, text);
                self.model = Some(model);
                Event::Opened(report)
            }
            Err(error) => Event::Refused { message: format!("This is no model file: {error}.") },
        }
    }
}

fn read_corpus(name: String, text: String) -> Job {
    let source = Cursor::new(text.into_bytes());
    match Rows::new(Form::of_name(&name), source, Options::default()) {
        Ok(rows) => {
            let corpus = Corpus { columns: rows.columns().to_vec(), ..Corpus::default() };
            Job::Read { name, rows: Box::new(rows), corpus, flaws: Vec::new() }
        }
        Err(flaw) => Job::Say(Event::Corpus(CorpusReport {
            name,
            rows: Vec::new(),
            rejected: 0,
            problems: vec![problem(flaw)],
        })),
    }
}

fn example(lesson: Lesson) -> Example {
    let pairs = lesson.pairs.into_iter().map(|PairText { pre, post }| Pair { pre, post });
    Example {
        id: "taught".to_owned(),
        line: 0,
        command: lesson.command,
        task: None,
        worker: None,
        pairs: pairs.collect(),
        rest: Vec::new(),
    }
}

fn plan(form: &str, state: &State, rules: &WorldRules) -> Job {
    let mut terms = Terms::new();
    let goal = read(&mut terms, form)
        .map_err(|e| e.to_string())
        .and_then(|term| Goal::new(&terms, term, state).map_err(|e| e.to_string()));
    let begun = goal.and_then(|g| Planning::begin(&g, state, rules).map_err(|e| e.to_string()));
    match begun {
        Ok(Begun::Work(planning)) => Job::Plan(planning),
        Ok(Begun::Done(plan)) => Job::Say(Event::Planned(plan)),
        Err(message) => refuse(&message),
    }
}

fn refuse(message: &str) -> Job {
    Job::Say(Event::Refused { message: message.to_owned() })
}

/// What a model says of how it was trained; `text` is its file.
fn train_report(model: &Model, text: String) -> TrainReport {
    let fact = |name: &str| model.facts.get(name).and_then(|text| text.parse().ok()).unwrap_or(0);
    TrainReport {
        model: text,
        examples: fact("examples"),
        valid: fact("valid"),
        entries: model.lexicon.len(),
    }
}

pub(super) fn problem(flaw: Flaw) -> Problem {
    Problem { line: flaw.line, column: flaw.column, message: flaw.message, kept: flaw.kept }
}

/// How far a training run of so many epochs and examples is.
pub(super) fn progress(progress: learn::Progress, epochs: u32, examples: usize) -> Progress {
    Progress {
        epoch: progress.epoch,
        epochs,
        example: progress.example,
        examples,
        valid: progress.so_far.valid,
        updates: progress.so_far.updates,
        entries: progress.so_far.entries,
    }
}
