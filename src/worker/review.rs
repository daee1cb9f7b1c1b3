//! Answers under review in the learner: files are taken in, merged and flagged, judged by a model, decided, and written,
//! while the page keeps a line of each.

use super::job::{Job, Step, say};
use super::protocol::{
    AnswerLine, CorpusFile, Decision, Event, Reviewed, Sheet, StudyAsk, StudySaid,
};
use crate::ccg::Model;
use crate::corpus::text_of;
use crate::study::answer::Decided;
use crate::study::coverage::{coverage, top_up};
use crate::study::export::{Style, write};
use crate::study::gather::Gathering;
use crate::study::judge::Judging;
use crate::study::merge::unite;
use crate::study::survey::trials::paths;
use crate::study::survey::{SurveyMapping, Trials, convert, trials};
use crate::study::{Flag, Review, Row, Study, pay};
use std::collections::BTreeMap;

/// Flaws of files that are told.
const MOST_FLAWS: usize = 100;
/// Bytes of a file between two reports.
const REPORT: usize = 1 << 20;

/// What the learner keeps of a review.
pub(super) struct Reviewing {
    /// The study that answers are held against; one of which nothing is known, if none was given.
    study: Study,
    review: Review,
    /// Answers to other studies.
    others: Vec<Decided>,
    /// Answers that were brought since they were merged last.
    new: Vec<Decided>,
    doubles: usize,
    flaws: Vec<String>,
    /// Files without an answer that were brought since, each with what is wrong with it.
    strange: Vec<(String, String, Vec<String>)>,
    /// Another program's trials.
    trials: Trials,
}

impl Default for Reviewing {
    fn default() -> Reviewing {
        Reviewing {
            study: Study::new("answers", Vec::new()),
            review: Review::default(),
            others: Vec::new(),
            new: Vec::new(),
            doubles: 0,
            flaws: Vec::new(),
            strange: Vec::new(),
            trials: Trials::default(),
        }
    }
}

/// Begins what is asked about a review.
///
/// # Errors
/// In words: what is wrong with a file.
pub(super) fn begin<R: AsMut<Reviewing>>(role: &mut R, ask: StudyAsk) -> Result<Job<R>, String> {
    let reviewing = role.as_mut();
    match ask {
        StudyAsk::Bring(file) => bring(&file),
        StudyAsk::Review(study) => {
            if let Some(file) = study {
                let text = text(&file)?;
                reviewing.study =
                    Study::read(&text).map_err(|error| format!("{}: {error}", file.name))?;
            }
            // A part of its own, so that what waits to be said is said before.
            Ok(Box::new(|role| Step::Over(Event::Study(role.as_mut().merge()))))
        }
        StudyAsk::Convert(mapping) => say(Event::Study(reviewing.convert(&mapping)?)),
        StudyAsk::Judge(model) => judge(&model),
        ask => say(answer(reviewing, ask)?),
    }
}

/// Answers what takes no work.
///
/// # Errors
/// In words: what cannot be written, or is not there.
pub(super) fn answer(reviewing: &mut Reviewing, ask: StudyAsk) -> Result<Event, String> {
    Ok(Event::Study(match ask {
        StudyAsk::Decide(decisions) => reviewing.decide(decisions),
        StudyAsk::Show(id) => reviewing.show(id)?,
        StudyAsk::Write { what, key, approved_only } => {
            let pseudonyms = Some(key).filter(|key| !key.is_empty());
            reviewing.write(what, Style { pseudonyms, approved_only, ..Style::default() })?
        }
        _ => return Err("This is no question about answers.".to_owned()),
    }))
}

/// The text of a file.
fn text(file: &CorpusFile) -> Result<String, String> {
    text_of(file.bytes.to_vec())
        .map_err(|line| format!("{}: line {line} is not UTF-8 text.", file.name))
}

fn bring<R: AsMut<Reviewing>>(file: &CorpusFile) -> Result<Job<R>, String> {
    let (name, text) = (file.name.clone(), text(file)?);
    let mut gathering = Some(Gathering::new(&text));
    let mut told = 0;
    // Where it has no answer it may be another program's.
    let mut text = Some(text);
    Ok(Box::new(move |role| {
        if let Some(work) = &mut gathering
            && work.step()
        {
            let (done, _) = work.progress();
            let is_news = done > told + REPORT;
            told = if is_news { done } else { told };
            let event = Event::Study(StudySaid::Bringing(done as u32));
            return Step::Working(is_news.then_some(event));
        }
        if let (Some(done), Some(text)) = (gathering.take(), text.take()) {
            role.as_mut().take(&name, text, done);
        }
        Step::Over(Event::Study(StudySaid::Brought))
    }))
}

fn judge<R: AsMut<Reviewing>>(model: &str) -> Result<Job<R>, String> {
    let model =
        Model::read(model).map_err(|error| format!("The model cannot be read: {error}."))?;
    let mut judging = Some(Judging::new(model));
    Ok(Box::new(move |role| {
        let reviewing = role.as_mut();
        let Reviewing { review, study, .. } = reviewing;
        let Some(work) = &mut judging else { return Step::Over(Event::Cancelled) };
        let (done, of) = (work.progress(), review.rows.len());
        if let Some(row) = review.rows.get(done) {
            work.step(&row.answer);
            let said = StudySaid::Judging(done as u32 + 1, of as u32);
            return Step::Working(done.is_multiple_of(8).then_some(Event::Study(said)));
        }
        let verdicts = judging.take().map(Judging::end).unwrap_or_default();
        review.judged(study, verdicts);
        Step::Over(Event::Study(reviewing.reviewed()))
    }))
}

impl Reviewing {
    /// Takes in a file that was read.
    fn take(&mut self, name: &str, text: String, done: Gathering) {
        let flaws = done.flaws.iter().take(MOST_FLAWS).map(|flaw| format!("{name}: {flaw}"));
        if done.answers.is_empty() {
            self.strange.push((name.to_owned(), text, flaws.collect()));
        } else {
            self.flaws.extend(flaws);
            self.new.extend(done.answers);
        }
    }

    /// Merges what was brought with what there is; where it was nothing but trials, says so.
    fn merge(&mut self) -> StudySaid {
        let strange = std::mem::take(&mut self.strange);
        if self.new.is_empty() && !strange.is_empty() {
            let found = trials(strange.iter().map(|(name, text, _)| (&**name, &**text)));
            if !found.rows.is_empty() {
                let mapping = SurveyMapping::propose(&found);
                let paths = paths(&found.rows);
                let trials = found.rows.len() as u32;
                self.trials = found;
                return StudySaid::Trials { trials, paths, mapping };
            }
            self.flaws.extend(found.flaws.iter().map(|(name, flaw)| format!("{name}: {flaw}")));
            if found.flaws.is_empty() {
                self.flaws.extend(strange.into_iter().flat_map(|(.., flaws)| flaws));
            }
        } else {
            self.flaws.extend(strange.into_iter().flat_map(|(.., flaws)| flaws));
        }
        let mut all: Vec<Decided> = std::mem::take(&mut self.review).into_answers().collect();
        all.append(&mut self.others);
        all.append(&mut self.new);
        self.doubles += unite(&mut all);
        (self.review, self.others) = Review::new(&self.study, all);
        self.reviewed()
    }

    /// The answers as they stand.
    fn reviewed(&self) -> StudySaid {
        let line = |row: &Row| AnswerLine {
            id: row.answer.id.clone(),
            command: row.answer.command.clone(),
            task: row.answer.task.clone(),
            worker: row.answer.worker.clone(),
            flags: row.flags.clone(),
            decision: row.decision.clone(),
        };
        StudySaid::Reviewed(Box::new(Reviewed {
            rows: self.review.rows.iter().map(line).collect(),
            coverage: coverage(&self.study, &self.review),
            left_out: [self.doubles as u32, self.others.len() as u32],
            flaws: self.flaws.iter().take(MOST_FLAWS).cloned().collect(),
            is_judged: self.review.is_judged(),
        }))
    }

    fn convert(&mut self, mapping: &SurveyMapping) -> Result<StudySaid, String> {
        let found = convert(&self.trials, mapping).map_err(|wrong| wrong.to_string())?;
        let [answers, others, unfinished] =
            [found.answers.len(), found.others, found.unfinished].map(|n| n as u32);
        self.flaws.extend(found.flaws.iter().map(ToString::to_string));
        self.new.extend(found.answers.into_iter().map(|answer| (answer, Decision::Open)));
        self.trials = Trials::default();
        Ok(StudySaid::Converted { answers, others, unfinished })
    }

    fn decide(&mut self, decisions: Vec<(String, Decision)>) -> StudySaid {
        let mut decisions: BTreeMap<String, Decision> = decisions.into_iter().collect();
        for row in &mut self.review.rows {
            if let Some(decision) = decisions.remove(&row.answer.id) {
                row.decision = decision;
            }
        }
        StudySaid::Counted(coverage(&self.study, &self.review))
    }

    fn show(&self, id: String) -> Result<StudySaid, String> {
        let answer = self.review.answers().find(|answer| answer.id == id);
        let answer = answer.ok_or("There is no such answer.")?;
        let shows: Vec<_> = answer.shown().collect();
        // States and letters: JSON can hold them all.
        Ok(StudySaid::Shown { id, shows: serde_json::to_string(&shows).unwrap_or_default() })
    }

    fn write(&self, what: Sheet, style: Style) -> Result<StudySaid, String> {
        let Reviewing { study, review, .. } = self;
        let mut unfit = 0;
        let written = |review: &Review, style: &Style| {
            let mut bytes = Vec::new();
            write(review, style, &mut bytes).map_err(|error| error.to_string())?;
            Ok::<Vec<u8>, String>(bytes)
        };
        let (name, bytes) = match what {
            Sheet::Table => ("answers.csv", written(review, &style)?),
            Sheet::Lines => ("answers.jsonl", written(review, &Style { is_json: true, ..style })?),
            Sheet::Corpus => {
                let style = Style { is_json: true, approved_only: false, fit_only: true, ..style };
                let is_unfit = |row: &&Row| row.flags.contains(&Flag::Unfit);
                unfit = review.rows.iter().filter(is_unfit).count() as u32;
                ("study-answers.jsonl", written(review, &style)?)
            }
            Sheet::Pay => ("pay.csv", pay::sheet(study, review).into_bytes()),
            Sheet::TopUp(wanted) => match top_up(study, review, wanted as usize) {
                Some(more) => ("top-up.json", more.write().into_bytes()),
                None => return Ok(StudySaid::Enough),
            },
        };
        let file = CorpusFile { name: name.to_owned(), bytes: bytes.into() };
        Ok(StudySaid::Written { what, file, unfit })
    }
}
