//! The paper's demonstration in the engine (Williams et al., Section VII): learns, then answers a command that was never
//! heard; all in bounded steps. And reports of runs as the protocol has them.

use super::ask::{Asked, Asking};
use super::job::Step;
use super::progress::progress;
use super::protocol::{
    Confused, Demonstrated, Event, ExperimentProgress, Figures, Judgement, RunPart, RunReport,
    TaskFigures, WorldRules,
};
use crate::ccg::Model;
use crate::domain::State;
use crate::learn::experiment::{self as learning, Outcome, Run, Running, Selection};
use crate::learn::{Config, Report, Ties};

/// The demonstration at work.
pub(super) struct Demonstrating {
    command: String,
    state: State,
    run: Run,
    stage: Stage,
}

enum Stage {
    /// It learns, and is asked what it has heard.
    Learn(Box<Running>),
    /// The command is answered.
    Ask { asking: Box<Asking>, model: Box<Model>, run: Box<RunReport> },
    /// All is said.
    Over,
}

impl Demonstrating {
    /// The beginning: what is known beforehand, what is learned from, and the settings.
    pub(super) fn new(
        command: String,
        state: State,
        (seed, all, config): (Model, Selection, Config),
    ) -> Self {
        let name = "demonstration".to_owned();
        let run = Run { name, train: all.clone(), test: all, config, paper_f1: None };
        let stage = Stage::Learn(Box::new(Running::new(run.clone(), seed)));
        Demonstrating { command, state, run, stage }
    }

    /// Does a bounded part.
    pub(super) fn step(&mut self) -> Step {
        match std::mem::replace(&mut self.stage, Stage::Over) {
            Stage::Learn(running) => Step::Working(self.learn_on(running)),
            Stage::Ask { mut asking, mut model, run } => match asking.step(&mut model) {
                Asked::Working(_) => {
                    self.stage = Stage::Ask { asking, model, run };
                    Step::Working(None)
                }
                Asked::Answered(answer, _) => {
                    let found = Demonstrated { run: *run, answer: *answer };
                    Step::Over(Event::Demonstrated(Box::new(found)))
                }
                Asked::Failed(error) => Step::Over(Event::Refused { message: error.to_string() }),
            },
            Stage::Over => Step::Over(Event::Cancelled),
        }
    }

    fn learn_on(&mut self, mut running: Box<Running>) -> Option<Event> {
        let part = match running.step() {
            None => None,
            Some(learning::Event::Trained(done, examples)) => {
                Some(RunPart::Learning(progress(done, self.run.config.passes(), examples)))
            }
            Some(learning::Event::Judged(scores, commands)) => {
                Some(RunPart::Judging { judged: scores.total, commands })
            }
            Some(learning::Event::Ended { outcome, model }) => {
                let (command, state) = (self.command.clone(), self.state.clone());
                let asking = Box::new(Asking::new(command, state, WorldRules::default()));
                let run = Box::new(run_report(&self.run, &outcome));
                self.stage = Stage::Ask { asking, model, run };
                return None;
            }
        };
        self.stage = Stage::Learn(running);
        let name = self.run.name.clone();
        part.map(|part| Event::Experimenting(ExperimentProgress { run: 0, runs: 1, name, part }))
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
