//! Studies in the learner: pairs are drawn, and answers judged, in steps.

use super::job::{Job, Step};
use super::protocol::{Event, StudyAsk, StudySaid};
use crate::ccg::Model;
use crate::study::judge::Judging;
use crate::study::make::Making;
use crate::study::{Study, TASKS, merge, read_tasks};

/// Begins what is asked.
///
/// # Errors
/// In words: what is wrong with the texts.
pub(super) fn begin<R>(ask: StudyAsk) -> Result<Job<R>, String> {
    match ask {
        StudyAsk::Make { study, tasks, pairs } => make(&study, &tasks, pairs),
        StudyAsk::Judge { model, answers } => judge(&model, &answers),
    }
}

fn make<R>(study: &str, tasks: &str, pairs: u32) -> Result<Job<R>, String> {
    let study: Study = serde_json::from_str(study)
        .map_err(|error| format!("The study cannot be read: {error}."))?;
    let tasks = if tasks.trim().is_empty() { TASKS } else { tasks };
    let tasks = read_tasks(tasks).map_err(|error| format!("The tasks cannot be read: {error}."))?;
    let mut making = Making::new(study, tasks, pairs as usize);
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

fn judge<R>(model: &str, answers: &str) -> Result<Job<R>, String> {
    let model =
        Model::read(model).map_err(|error| format!("The model cannot be read: {error}."))?;
    let merged = merge([("", answers)]);
    let mut judging = Some(Judging::new(model, merged.answers));
    Ok(Box::new(move |_| {
        let Some(work) = &mut judging else { return Step::Over(Event::Cancelled) };
        if work.step() {
            let (done, of) = work.progress();
            let said = StudySaid::Judging(done as u32, of as u32);
            return Step::Working((done.is_multiple_of(8)).then_some(Event::Study(said)));
        }
        let verdicts = judging.take().map(Judging::end).unwrap_or_default();
        Step::Over(Event::Study(StudySaid::Judged(verdicts)))
    }))
}
