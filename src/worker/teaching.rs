//! Lessons at work. Who drives the robot to show something drives a little further than a robot would, or means only where
//! that ends: a run from which a lesson is not learned is cut where everything has come to the room that it stays in, and
//! then taken for its first and last state, unless it has contrasts.

use super::job::{Job, Step};
use super::lesson::{check, is_meant, mean, told};
use super::protocol::{Event, Lesson, MOST_TAUGHT, PairText, RunText, TeachReport};
use super::talker::report;
use crate::ccg::{EntryText, Model};
use crate::corpus::{Cells, Decision, Example, Pair, run};
use crate::domain::straight::arrived;
use crate::domain::{Way, read_letters};
use crate::learn::{Config, Taught, Teaching};

/// What of a run counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Counts {
    /// All of it.
    All,
    /// It, but for what is done in the rooms where it ends.
    Arrival,
    /// Where it begins and where it ends.
    End,
}

/// Lessons that are taught to a model that knows none of them.
struct Lessons {
    base: Model,
    all: Vec<Lesson>,
    /// What counts of the runs of each.
    counts: Vec<Counts>,
    teaching: Option<Teaching>,
}

/// Begins to teach a model.
///
/// # Errors
/// Why it cannot be taught.
pub(super) fn teach<R>(model: &str, all: Vec<Lesson>) -> Result<Job<R>, String> {
    if all.is_empty() || all.len() > MOST_TAUGHT {
        return Err(format!("Teach between 1 and {MOST_TAUGHT} commands at once."));
    }
    let is_bare = |lesson: &&Lesson| !is_shown(lesson) && lesson.means.is_none();
    if let Some(bare) = all.iter().find(is_bare) {
        return Err(format!("Show what to do when one says {:?}.", bare.command));
    }
    let base = Model::read(model).map_err(|error| format!("The model cannot be read: {error}."))?;
    let counts = vec![Counts::All; all.len()];
    let mut lessons = Lessons { base, all, counts, teaching: None };
    lessons.begin()?;
    Ok(Box::new(move |_| lessons.step()))
}

impl Lessons {
    fn begin(&mut self) -> Result<(), String> {
        let shown = self.all.iter().zip(&self.counts).filter(|(lesson, _)| is_shown(lesson));
        let examples = shown.map(|(lesson, &counts)| example(lesson, counts));
        let examples = examples.collect::<Result<Vec<Example>, String>>()?;
        let config = Config { demonstrations: None, ..Config::of(&self.base) };
        let teaching = Teaching::new(self.base.clone(), &examples, config)
            .map_err(|error| format!("The model cannot be taught: {error}."))?;
        self.teaching = Some(teaching);
        Ok(())
    }

    fn step(&mut self) -> Step {
        let Some(done) = self.teaching.take_if(|teaching| teaching.is_done()) else {
            self.teaching.iter_mut().for_each(Teaching::step);
            return Step::Working(None);
        };
        let done = done.end();
        if self.relax(&done.understood) {
            return match self.begin() {
                Ok(()) => Step::Working(None),
                Err(message) => Step::Over(Event::Refused { message }),
            };
        }
        Step::Over(self.taught(done))
    }

    /// Less counts of the runs of lessons that were not learned; whether there are such.
    fn relax(&mut self, understood: &[bool]) -> bool {
        let shown = self.all.iter().zip(&mut self.counts).filter(|(lesson, _)| is_shown(lesson));
        let mut is_less = false;
        for ((lesson, counts), _) in shown.zip(understood).filter(|(_, understood)| !**understood) {
            let has_contrast = lesson.runs.iter().any(|run| !run.contrast.is_empty());
            let less = match counts {
                Counts::All => Counts::Arrival,
                Counts::Arrival if !has_contrast => Counts::End,
                _ => continue,
            };
            if !lesson.runs.is_empty() && lesson.means.is_none() {
                (*counts, is_less) = (less, true);
            }
        }
        is_less
    }

    fn taught(&self, Taught { mut model, mut entries, understood }: Taught) -> Event {
        let mut shown = understood.into_iter();
        let (mut understood, mut refusal) = (Vec::new(), None);
        for lesson in &self.all {
            let as_shown = is_shown(lesson) && shown.next().unwrap_or(false);
            refusal = match mean(&mut model, lesson) {
                Ok(name) => {
                    entries.extend(name);
                    None
                }
                Err(refusal) => Some(refusal),
            };
            let is_meant = refusal.is_none() && is_meant(&mut model, lesson);
            understood.push(if lesson.means.is_some() { is_meant } else { as_shown });
        }
        let last = self.all.last().zip(self.counts.last());
        let last = last.filter(|(last, _)| last.means.is_none());
        let by_end =
            last.is_some_and(|(last, counts)| !last.runs.is_empty() && *counts == Counts::End);
        let last = last.and_then(|(last, &counts)| example(last, counts).ok());
        let check = last.map(|last| check(&mut model, &last));
        let told = entries.iter().map(|&id| told(&mut model, id)).collect();
        let added = entries.into_iter().map(|id| EntryText::of(&model, id)).collect();
        let model = report(&model, model.print());
        let report = TeachReport { model, added, told, understood, check, refusal, by_end };
        Event::Taught(Box::new(report))
    }
}

fn is_shown(lesson: &Lesson) -> bool {
    !lesson.pairs.is_empty() || !lesson.runs.is_empty()
}

fn example(lesson: &Lesson, counts: Counts) -> Result<Example, String> {
    let pairs =
        lesson.pairs.iter().map(|PairText { pre, post }| Pair::of(pre.clone(), post.clone()));
    let mut pairs: Vec<Pair> = pairs.collect();
    for run in &lesson.runs {
        pairs.push(shown(run, counts)?);
    }
    Ok(Example {
        id: "taught".to_owned(),
        line: 0,
        command: lesson.command.clone(),
        task: None,
        worker: None,
        decision: Decision::Open,
        pairs,
        rest: Cells::default(),
        keys: Cells::default(),
    })
}

/// What counts of a run.
fn shown(RunText { start, actions, contrast }: &RunText, counts: Counts) -> Result<Pair, String> {
    let read = |way: &String| {
        read_letters(way).map_err(|letter| format!("No action is called {letter:?}."))
    };
    let contrasts = contrast.iter().map(read).collect::<Result<_, _>>()?;
    let mut way = Way { actions: read(actions)?, contrasts };
    if counts == Counts::Arrival {
        let states = way.states(start).map_err(|error| error.to_string())?;
        let arrived = states.first().map_or(0, |states| arrived(states));
        way.actions = way.actions.iter().take(arrived).copied().collect();
    }
    let pair = run::pair(start.clone(), way).map_err(|wrong| wrong.to_string())?;
    Ok(if counts == Counts::End { Pair::of(pair.pre, pair.post) } else { pair })
}
