//! Studies in the learner: pairs are drawn for tasks, in steps.

use super::job::{Job, Step};
use super::protocol::{Event, StudySaid};
use crate::domain::misread;
use crate::study::make::Making;
use crate::study::tasks::must;
use crate::study::{Study, TASKS, read_tasks};

/// What a study is to be made of.
pub(super) struct Wanted {
    /// A study without items.
    pub(super) study: String,
    /// The tasks, as a file of them; the corpus's own if it is empty.
    pub(super) tasks: String,
    /// Pairs of each item.
    pub(super) pairs: u32,
    /// Whether the robot's way is shown in their place, whatever the goal.
    pub(super) has_ways: bool,
    /// Tasks that are there to see whether somebody looks, and the words that an answer must have.
    pub(super) checks: Vec<(String, String)>,
}

/// Begins to make a study.
///
/// # Errors
/// In words: what is wrong with the texts.
pub(super) fn make<R>(wanted: Wanted) -> Result<Job<R>, String> {
    let Wanted { study, tasks, pairs, has_ways, checks } = wanted;
    let study: Study =
        misread::read(&study).map_err(|error| format!("The study cannot be read: {error}."))?;
    let tasks = if tasks.trim().is_empty() { TASKS } else { &tasks };
    let mut tasks =
        read_tasks(tasks).map_err(|error| format!("The tasks cannot be read: {error}."))?;
    for (name, words) in &checks {
        let task = tasks.iter_mut().find(|task| task.name == *name);
        let task = task.ok_or_else(|| format!("No task is called {name}, which is to check."))?;
        task.must = must(words).map_err(|error| format!("The task {name}: {error}."))?;
    }
    let making = Making::new(study, tasks, pairs as usize);
    let mut making = if has_ways { making.with_ways() } else { making };
    let mut told = 0;
    Ok(Box::new(move |_| match making.step() {
        Some(Ok(made)) => {
            let study = made.study.write();
            Step::Over(Event::Study(StudySaid::Made { study, open: made.open }))
        }
        Some(Err(error)) => Step::Over(Event::Refused { message: format!("{error}.") }),
        None => {
            let (done, of) = making.progress();
            let is_news = std::mem::replace(&mut told, done) < done;
            let said = StudySaid::Making(done as u32, of as u32);
            Step::Working(is_news.then_some(Event::Study(said)))
        }
    }))
}
