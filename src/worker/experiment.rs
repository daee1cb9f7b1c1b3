//! An experiment in the engine: its test file is read, its runs follow each other, and, for the demonstration, the
//! command that was never heard is answered; all in bounded steps.

use super::ask::{Asked, Asking};
use super::job::Step;
use super::progress::{CorpusReading, progress};
use super::protocol::{
    Confused, Event, Experiment, ExperimentProgress, ExperimentReport, Figures, Judgement,
    MappedFile, Mapping, Problem, RunPart, RunReport, TaskFigures, WorldRules,
};
use crate::ccg::Model;
use crate::corpus::Example;
use crate::learn::experiment::{
    self as learning, Outcome, Run, Selection, cross, table_2, table_3,
};
use crate::learn::{CLEANUP_LEXICON, Config, DEMONSTRATION_LEXICON, Report, Ties, seed_model};
use std::sync::Arc;

/// The most parts that a corpus is cut into.
const MAX_FOLDS: u32 = 1_000;

/// An experiment at work.
pub(super) struct Experimenting {
    experiment: Experiment,
    train: Arc<[Example]>,
    config: Config,
    seed: Model,
    problems: Vec<Problem>,
    stage: Stage,
}

enum Stage {
    /// The test file is read.
    Read(Box<CorpusReading>),
    /// The runs follow each other.
    Run(Box<Runs>),
    /// The command is answered.
    Ask { asking: Box<Asking>, model: Box<Model>, report: Box<ExperimentReport> },
    /// All is said.
    Over,
}

struct Runs {
    experiment: learning::Experiment,
    runs: Vec<Run>,
    reports: Vec<RunReport>,
    all: Report,
}

/// The end of an experiment. A report always has a JSON form: it has no maps, and its floats are finite.
fn experimented(report: &ExperimentReport) -> Event {
    Event::Experimented { report: serde_json::to_string(report).unwrap_or_default() }
}

impl Experimenting {
    /// An experiment that begins, or why it cannot.
    pub(super) fn new(
        experiment: Experiment,
        corpus: Selection,
        config: Config,
    ) -> Result<Self, String> {
        let lexicon = match experiment {
            Experiment::Demonstration { .. } => DEMONSTRATION_LEXICON,
            _ => CLEANUP_LEXICON,
        };
        let seed = seed_model(lexicon)
            .map_err(|error| format!("The seed lexicon cannot be read: {error}."))?;
        let train: Arc<[Example]> = corpus.into_shared();
        let all = Selection::all(&train);
        let stage = match &experiment {
            Experiment::Table2 { test, .. } | Experiment::Table3 { test, .. } => {
                let files = vec![MappedFile { file: test.clone(), mapping: Mapping::default() }];
                Stage::Read(Box::new(CorpusReading::new(files, false)))
            }
            Experiment::Demonstration { .. } => {
                let name = "demonstration".to_owned();
                let config = config.clone();
                let run = Run { name, train: all.clone(), test: all, config, paper_f1: None };
                Stage::begin(&seed, vec![run])
            }
            Experiment::Cross { folds, by } => {
                let most = MAX_FOLDS.min(u32::try_from(train.len()).unwrap_or(MAX_FOLDS));
                if !(2..=most).contains(folds) {
                    return Err(format!("The folds must be between 2 and {most}."));
                }
                Stage::begin(&seed, cross(&train, *folds, *by, &config))
            }
        };
        Ok(Experimenting { experiment, train, config, seed, problems: Vec::new(), stage })
    }

    /// Does a bounded part.
    pub(super) fn step(&mut self) -> Step {
        let said = match std::mem::replace(&mut self.stage, Stage::Over) {
            Stage::Read(reading) => self.read_on(reading),
            Stage::Run(runs) => self.run_on(runs),
            Stage::Ask { mut asking, mut model, mut report } => match asking.step(&mut model) {
                Asked::Working(_) => {
                    self.stage = Stage::Ask { asking, model, report };
                    None
                }
                Asked::Answered(answer, _) => {
                    report.answer = Some(*answer);
                    Some(experimented(&report))
                }
                Asked::Failed(error) => Some(Event::Refused { message: error.to_string() }),
            },
            Stage::Over => None,
        };
        match (said, &self.stage) {
            (said, Stage::Over) => Step::Over(said.unwrap_or(Event::Cancelled)),
            (said, _) => Step::Working(said),
        }
    }

    fn read_on(&mut self, mut reading: Box<CorpusReading>) -> Option<Event> {
        let Some(read) = reading.step() else {
            self.stage = Stage::Read(reading);
            return None;
        };
        self.problems = read.problems(1);
        self.begin(read.examples)
    }

    /// The test file is read: the runs begin, if it has anything to be judged on.
    fn begin(&mut self, test: Vec<Example>) -> Option<Event> {
        if test.is_empty() {
            let why = self.problems.first().map_or("it has no rows", |first| &first.message);
            let message = format!("No row of the test file can be used: {why}.");
            return Some(Event::Refused { message });
        }
        let (train, test) = (Selection::all(&self.train), Selection::all(&Arc::from(test)));
        let runs = match &self.experiment {
            Experiment::Table2 { set, .. } => table_2(set, &train, &test, &self.config),
            Experiment::Table3 { budget, .. } => {
                table_3(&train, &test, &self.config, *budget, &[true])
            }
            Experiment::Demonstration { .. } | Experiment::Cross { .. } => Vec::new(),
        };
        self.stage = Stage::begin(&self.seed, runs);
        None
    }

    fn run_on(&mut self, mut runs: Box<Runs>) -> Option<Event> {
        let Some((at, event)) = runs.experiment.step() else {
            self.stage = Stage::Run(runs);
            return None;
        };
        let run = runs.runs.get(at)?;
        let part = match event {
            learning::Event::Trained(done, examples) => {
                RunPart::Learning(progress(done, run.config.passes(), examples))
            }
            learning::Event::Judged(scores, commands) => {
                RunPart::Judging { judged: scores.total, commands }
            }
            learning::Event::Ended { outcome, model } => {
                runs.reports.push(run_report(run, &outcome));
                runs.all.add(outcome.report);
                return self.end_run(runs, model);
            }
        };
        let (name, n_runs) = (run.name.clone(), runs.runs.len());
        self.stage = Stage::Run(runs);
        Some(Event::Experimenting(ExperimentProgress { run: at, runs: n_runs, name, part }))
    }

    /// A run has ended: the next one, or what all of them found.
    fn end_run(&mut self, runs: Box<Runs>, model: Box<Model>) -> Option<Event> {
        if !runs.experiment.is_over() {
            self.stage = Stage::Run(runs);
            return None;
        }
        let is_cross = matches!(self.experiment, Experiment::Cross { .. });
        let report = Box::new(ExperimentReport {
            all: is_cross.then(|| judgement(&runs.all)),
            runs: runs.reports,
            answer: None,
            problems: std::mem::take(&mut self.problems),
        });
        if let Experiment::Demonstration { command, state } = &self.experiment {
            let asking =
                Box::new(Asking::new(command.clone(), state.clone(), WorldRules::default()));
            self.stage = Stage::Ask { asking, model, report };
            return None;
        }
        Some(experimented(&report))
    }
}

impl Stage {
    fn begin(seed: &Model, runs: Vec<Run>) -> Stage {
        let experiment = learning::Experiment::new(seed.clone(), runs.clone());
        Stage::Run(Box::new(Runs { experiment, runs, reports: Vec::new(), all: Report::default() }))
    }
}

fn run_report(run: &Run, outcome: &Outcome) -> RunReport {
    RunReport {
        name: run.name.clone(),
        examples: outcome.examples,
        valid: outcome.last.valid,
        entries: outcome.last.entries,
        paper_f1: run.paper_f1,
        planner: outcome.planner,
        judgement: judgement(&outcome.report),
    }
}

pub(super) fn judgement(report: &Report) -> Judgement {
    let scores = report.scores(Ties::Abstain);
    let resolved = report.scores(Ties::Refer);
    let [p, r, f, skipping_p, skipping_r, skipping_f] = report.intervals(Ties::Abstain);
    let figures = |score: crate::learn::Score, intervals: [(f64, f64); 3]| {
        let [p, r, f] = score.figures(scores.total);
        let [(p_low, p_high), (r_low, r_high), (f_low, f_high)] = intervals;
        Figures {
            answered: score.answered,
            correct: score.correct,
            precision: [p, p_low, p_high],
            recall: [r, r_low, r_high],
            f1: [f, f_low, f_high],
        }
    };
    let name = |name: Option<&str>| name.map(str::to_owned);
    let tasks = report.tasks(Ties::Abstain).into_iter().map(|(task, scores)| TaskFigures {
        task: name(task),
        total: scores.total,
        answered: scores.skipping.answered,
        correct: scores.skipping.correct,
    });
    let cells = report.confusion.cells();
    let cells =
        cells.map(|(task, does, count)| Confused { task: name(task), does: name(does), count });
    Judgement {
        total: scores.total,
        plain: figures(scores.plain, [p, r, f]),
        skipping: figures(scores.skipping, [skipping_p, skipping_r, skipping_f]),
        resolved_f1: resolved.skipping.f1(scores.total),
        tasks: tasks.collect(),
        confusion: cells.collect(),
    }
}
