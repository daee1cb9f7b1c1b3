//! The program that talks: opens a model, answers commands, plans, and is asked about what it found. It is what the
//! page loads first, so it knows nothing of corpora and learning.

use super::ask::{Asked, Asking, answer};
use super::examples::Looking;
use super::job::{Job, Role, Step, misdirected, say};
use super::plan::{Begun, Planned, Planning};
use super::protocol::{
    Event, MOST_RUNS, PlanText, Program, Reader, Request, TrainReport, WorldRules, decode_asked,
};
use super::read::{parsed, studies};
use super::watch::{Rolling, Valuing};
use super::world;
use crate::ccg::{General, Model};
use crate::domain::State;
use std::rc::Rc;
use std::sync::Arc;

const NO_PLAN: &str = "There is no plan to go by: ask for something first.";

const OTHER_WORLD: &str = "The plan that is kept is for another world: plan again.";

const NO_MODEL: &str = "There is no model yet: train one, or open a model file.";

/// What the talker keeps.
#[derive(Default)]
pub struct Talker {
    model: Option<Model>,
    words: Option<Arc<General>>,
    planned: Option<Rc<Planned>>,
}

impl Role for Talker {
    const PROGRAM: Program = Program::Talker;
    const READ: Reader<Request> = decode_asked;

    fn begin(&mut self, request: Request) -> Result<Job<Talker>, String> {
        match request {
            Request::OpenModel { text } => Ok(open_model(text)),
            Request::Words { text } => {
                let words = General::read(&text).map_err(|error| error.to_string())?;
                self.words = Some(Arc::new(words));
                self.attach();
                say(Event::Words)
            }
            Request::Read { command, state } => {
                let model = self.model.as_mut().ok_or(NO_MODEL)?;
                state.check().map_err(|error| error.to_string())?;
                let parse = parsed(model, &command);
                say(Event::Answer(Box::new(answer(model, &parse, &command, &state))))
            }
            Request::Ask { command, state, rules } => {
                self.model.as_ref().ok_or(NO_MODEL)?;
                state.check().map_err(|error| error.to_string())?;
                Ok(ask(Asking::new(command, state, rules)))
            }
            Request::Plan { form, run, rules } => plan(&form, &run, &rules),
            Request::Values { state, done } => {
                let planned = self.planned.clone().ok_or(NO_PLAN)?;
                let mut valuing = Valuing::new(planned, &state, done).ok_or(OTHER_WORLD)?;
                Ok(Box::new(move |_| match valuing.step() {
                    Some(map) => Step::Over(Event::Values(map)),
                    None => Step::Working(None),
                }))
            }
            Request::GoOn { form, run, rules } => {
                let begun = Planning::begin(&form, &run, &rules, false);
                Ok(match begun.map_err(|error| error.to_string())? {
                    Begun::Done(plan) => return say(Event::Planned(plan)),
                    Begun::Work(mut planning) => Box::new(move |_| match planning.step() {
                        Some(plan) => Step::Over(Event::Planned(Box::new(plan))),
                        None => Step::Working(planning.news().map(Event::Planning)),
                    }),
                })
            }
            Request::RollOut { runs, seed } => {
                let planned = self.planned.clone().ok_or(NO_PLAN)?;
                if !(1..=MOST_RUNS).contains(&runs) {
                    return Err(format!("Ask for between 1 and {MOST_RUNS} runs."));
                }
                let mut rolling = Rolling::new(planned, runs, seed);
                Ok(Box::new(move |_| match rolling.step() {
                    Some((runs, true)) => Step::Over(Event::RolledOut(runs)),
                    said => Step::Working(said.map(|(runs, _)| Event::RollingOut(runs))),
                }))
            }
            Request::Explain { command } => {
                let model = self.model.as_mut().ok_or(NO_MODEL)?;
                say(Event::Explained(studies(model, &command)))
            }
            Request::Example { wanted, state, rules } => {
                self.model.as_ref().ok_or(NO_MODEL)?;
                state.check().map_err(|error| error.to_string())?;
                let mut looking = Looking::new(wanted, state, rules);
                Ok(Box::new(move |talker| {
                    let Some(model) = &mut talker.model else {
                        return Step::Over(Event::Cancelled);
                    };
                    looking.step(model).map_or(Step::Working(None), Step::Over)
                }))
            }
            Request::Draw { blueprint, seed } => say(world::draw(&blueprint, seed)),
            Request::ReadWorld { text } => say(world::read(&text)),
            Request::WriteWorld { state } => say(world::write(&state)),
            other => Err(misdirected(&other, Self::PROGRAM)),
        }
    }
}

fn open_model(text: String) -> Job<Talker> {
    Box::new(move |talker| {
        Step::Over(match Model::read(&text) {
            Ok(model) => {
                let report = report(&model, text.clone());
                talker.model = Some(model);
                talker.attach();
                Event::Opened(report)
            }
            Err(error) => Event::Refused { message: format!("This is no model file: {error}.") },
        })
    })
}

/// What a model says of how it was trained; `text` is its file.
pub(super) fn report(model: &Model, text: String) -> TrainReport {
    let fact = |name: &str| model.facts.get(name).and_then(|text| text.parse().ok()).unwrap_or(0);
    TrainReport {
        model: text,
        examples: fact("examples"),
        valid: fact("valid"),
        entries: model.lexicon.len(),
    }
}

fn ask(mut asking: Asking) -> Job<Talker> {
    Box::new(move |talker| {
        let Some(model) = &mut talker.model else { return Step::Over(Event::Cancelled) };
        match asking.step(model) {
            Asked::Working(progress) => Step::Working(progress.map(Event::Planning)),
            Asked::Answered(answer, planned) => {
                talker.planned = planned;
                Step::Over(Event::Answer(answer))
            }
            Asked::Failed(error) => Step::Over(Event::Refused { message: error.to_string() }),
        }
    })
}

fn plan(form: &str, run: &[State], rules: &WorldRules) -> Result<Job<Talker>, String> {
    let begun = Planning::begin(form, run, rules, false).map_err(|error| error.to_string())?;
    let mut planning = match begun {
        Begun::Work(planning) => Some(planning),
        Begun::Done(plan) => {
            let mut plan = Some(plan);
            return Ok(Box::new(move |talker| match plan.take() {
                Some(plan) => talker.keep(plan, None),
                None => Step::Working(None),
            }));
        }
    };
    Ok(Box::new(move |talker| {
        let Some(at_work) = &mut planning else { return Step::Working(None) };
        match at_work.step() {
            Some(plan) => talker.keep(Box::new(plan), planning.take()),
            None => Step::Working(at_work.news().map(Event::Planning)),
        }
    }))
}

impl Talker {
    /// The model that is open understands what the general resource knows, as far as both are there.
    fn attach(&mut self) {
        if let (Some(model), Some(words)) = (&mut self.model, &self.words) {
            model.attach(words.clone());
        }
    }

    /// Keeps the policy that was found, and says what it does; a goal that needed no search has none.
    fn keep(&mut self, plan: Box<PlanText>, found: Option<Box<Planning>>) -> Step {
        self.planned = found.map(|planning| planning.into_planned());
        Step::Over(Event::Planned(plan))
    }
}
