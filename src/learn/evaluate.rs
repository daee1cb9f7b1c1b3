//! Judging a model on commands with demonstrations: one best form is an answer, tied best forms abstain, no parse
//! is no answer; then the same with the parse that skips words counted (Williams et al., Section VI).

use super::confusion::Observer;
use super::report::Report;
use super::score::{Mark, Scores, Ties, Verdict};
use crate::ccg::chart::ChartConfig;
use crate::ccg::{Model, Parse, Reason, parse, probability};
use crate::corpus::Example;
use crate::ground::{Course, PairId, Validator, forbids_idly};
use crate::logic::{TermId, Terms};

/// What judges a model's answers to the commands of one corpus.
pub struct Judge {
    config: ChartConfig,
    observer: Observer,
    report: Report,
    scores: Scores,
}

impl Judge {
    /// A judge that has heard nothing; `examples` are those that will be asked.
    pub fn new(examples: &[Example], config: ChartConfig) -> Self {
        let (report, scores) = (Report::default(), Scores::default());
        Judge { config, observer: Observer::new(examples), report, scores }
    }

    /// Asks the model one command, and says how all those asked so far were answered.
    pub fn ask(&mut self, model: &mut Model, example: &Example) -> Scores {
        let parse = parse(model, &example.command, self.config);
        let terms = &model.grammar.terms;
        let form = parse.answer().map(|reading| reading.form);
        let doubted = probability(model, &parse);
        let mark = Mark {
            task: example.task.clone(),
            answer: verdict(terms, form, example),
            resolved: verdict(terms, form.or_else(|| resolve(terms, &parse, example)), example),
            skipped: !parse.skipped.is_empty(),
            probability: doubted.map(|(probability, _)| probability),
            asked: doubted.is_some_and(|(_, asks)| {
                asks || form.is_some_and(|form| forbids_idly(terms, form))
            }),
        };
        if let (Verdict::Wrong, Some(form)) = (mark.answer, form) {
            let does = self.observer.recognise(terms, form, example.task.as_deref());
            self.report.confusion.count(example.task.as_deref(), does);
        }
        self.scores.count(&mark, Ties::Abstain);
        self.report.marks.push(mark);
        self.scores
    }

    /// How all those asked so far were answered.
    pub fn scores(&self) -> Scores {
        self.scores
    }

    /// Hands over what was found so far.
    pub fn take_report(&mut self) -> Report {
        std::mem::take(&mut self.report)
    }
}

/// Whether an answer, if there is one, does what an example shows.
pub(super) fn verdict(terms: &Terms, form: Option<TermId>, example: &Example) -> Verdict {
    let mut validator = Validator::new();
    let pairs: Vec<PairId> = example
        .pairs
        .iter()
        .map(|pair| validator.shown(&pair.pre, &pair.post, pair.way.as_deref()))
        .collect();
    match form {
        None => Verdict::Silent,
        Some(form) if validator.valid(terms, form, &pairs) => Verdict::Right,
        Some(_) => Verdict::Wrong,
    }
}

/// The one of the forms tied for best all of whose phrases refer in every state before. Where words were left out, there
/// is none.
fn resolve(terms: &Terms, parse: &Parse, example: &Example) -> Option<TermId> {
    if parse.reason != Some(Reason::Tie) {
        return None;
    }
    let refers = |form: &TermId| {
        example.pairs.iter().all(|pair| {
            let course = Course::new(terms, *form, &pair.pre);
            course.is_ok_and(|course| course.guards().iter().all(|g| g.failures().is_empty()))
        })
    };
    let tied = parse.readings.iter().take(parse.tied()).map(|reading| reading.form);
    let mut refer = tied.filter(refers);
    let first = refer.next()?;
    refer.next().is_none().then_some(first)
}

/// An evaluation, command by command.
pub struct Evaluation<'a> {
    model: &'a mut Model,
    examples: &'a [Example],
    judge: Judge,
}

impl<'a> Evaluation<'a> {
    /// An evaluation of a model on examples.
    pub fn new(model: &'a mut Model, examples: &'a [Example], config: ChartConfig) -> Self {
        Evaluation { model, examples, judge: Judge::new(examples, config) }
    }

    /// Scores the next command; `None` when all are done.
    pub fn step(&mut self) -> Option<Scores> {
        let example = self.examples.get(self.scores().total)?;
        Some(self.judge.ask(self.model, example))
    }

    /// What was found so far.
    pub fn scores(&self) -> Scores {
        self.judge.scores()
    }

    /// All that was found.
    pub fn into_report(mut self) -> Report {
        self.judge.take_report()
    }
}
