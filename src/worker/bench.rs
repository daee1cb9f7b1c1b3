//! What the learner answers at once, whatever is at work: windows of the sheet, decisions and how they are undone, what a
//! model makes of a row, files to save.

use super::learner::Learner;
use super::protocol::{Event, Form, PairText, Request, RowReading, RunText, Shown, Split};
use super::read::{parsed, reading, shown, words};
use super::review;
use super::shard;
use super::talker::report;
use super::training::Training;
use crate::ccg::{Model, probability};
use crate::corpus::{Example, Pair, jsonl, preview, share, table};
use crate::domain::{State, Way, letters};
use crate::ground::{PairId, Validator};
use crate::learn::audit::{Audit, Rows};
use crate::learn::inspect::{EntryView, difference, entries, without};
use crate::learn::sheet::{Half, Sheet, decided};
use crate::logic::read as read_term;
use std::io::Cursor;

/// Sentences that are told of an entry.
const MOST_SENTENCES: usize = 2;

impl Learner {
    /// Answers a request that is its own and replaces nothing.
    pub(super) fn answer_aside(&mut self, request: Request) -> Result<Event, String> {
        let sheet = &mut self.sheet;
        Ok(match request {
            Request::Study(ask) => review::answer(&mut self.review, ask)?,
            Request::ShowRow { row } => {
                let example = example(sheet, row)?;
                Event::Row { row, pairs: pairs(example) }
            }
            Request::Preview { file } => match preview(Cursor::new(&file.bytes[..])) {
                Ok(found) => Event::Previewed(Box::new(found)),
                Err(flaw) => return Err(format!("{}: {flaw}.", file.name)),
            },
            Request::Window { view, offset, count } => {
                Event::Window(Box::new(sheet.window(&view, offset, count)))
            }
            Request::Facets => Event::Facets(Box::new(sheet.facets())),
            Request::Care => Event::Care(sheet.care(None)),
            Request::Decide { rows, verdict } => Event::Care(sheet.decide(&rows, &verdict)),
            Request::DecideAll { view, verdict } => {
                let rows = sheet.seen_rows(&view).to_vec();
                Event::Care(sheet.decide(&rows, &verdict))
            }
            Request::Divide { split } => {
                let halves = halves(sheet, &split)?;
                Event::Care(sheet.divide(&halves))
            }
            Request::Decisions => Event::Decisions { text: decided::write(sheet) },
            Request::TakeDecisions { text } => {
                decided::take(sheet, &text)
                    .map_err(|wrong| format!("The decisions cannot be read: {wrong}."))?;
                Event::Care(sheet.care(None))
            }
            Request::Undo => Event::Care(sheet.turn(true)),
            Request::Redo => Event::Care(sheet.turn(false)),
            Request::Mark { rules } => {
                sheet.mark(rules);
                Event::Care(sheet.care(None))
            }
            Request::SaveSheet { file, form } => save(sheet, file as usize, form)?,
            Request::SaveBadRows { file } => self.save_bad_rows(file as usize)?,
            Request::ReadRow { row } => self.read_row(row)?,
            Request::Errors => {
                let audit = self.audit.as_ref().ok_or("No model was asked about the rows yet.")?;
                Event::Errors(Box::new(audit.errors()))
            }
            Request::Look => {
                let look = self.training.as_ref().and_then(|training| training.look());
                Event::Look(look.map(Box::new))
            }
            Request::Checkpoint => {
                let checkpoint = self.training.as_mut().and_then(|training| training.checkpoint());
                Event::Checkpoint(checkpoint.ok_or("No run is at work.")?)
            }
            Request::ModelSoFar => {
                let model = self.training.as_ref().and_then(|training| training.model());
                let model = model.ok_or("Nothing was trained yet.")?;
                Event::Trained(report(&model, model.print()))
            }
            Request::PlanRuns { matrix, settings } => shard::plan(sheet, &matrix, &settings)?,
            Request::JoinRuns { plan, shards } => shard::joined(&plan, &shards)?,
            Request::Entries { view, offset, count } => self.entries(&view, offset, count)?,
            Request::Without { places } => {
                let model = without(&self.model()?, &places);
                Event::Trained(report(&model, model.print()))
            }
            Request::KeepModel { text } => {
                let model = Model::read(&text)
                    .map_err(|error| format!("The model cannot be read: {error}."))?;
                self.given = Some(model);
                Event::Heard
            }
            Request::Compare { first, second } => {
                let [first, second] =
                    [(first, "first"), (second, "second")].map(|(text, which)| {
                        Model::read(&text)
                            .map_err(|error| format!("The {which} model cannot be read: {error}."))
                    });
                Event::Difference(Box::new(difference(&first?, &second?)))
            }
            other => {
                return Err(super::job::misdirected(&other, super::protocol::Program::Learner));
            }
        })
    }

    /// The model that was audited or trained last, or else given.
    fn model(&self) -> Result<Model, String> {
        let audited = self.fresh_audit().map(|audit| audit.model().clone());
        let trained = || self.training.as_ref().and_then(Training::model);
        let model = audited.or_else(trained).or_else(|| self.given.clone());
        model.ok_or_else(|| "There is no model yet: train one, or open one.".to_owned())
    }

    /// The audit, unless a model was trained behind it.
    fn fresh_audit(&self) -> Option<&Audit> {
        self.audit.as_ref().filter(|_| !self.is_audit_old)
    }

    fn entries(&mut self, view: &EntryView, offset: u32, count: u32) -> Result<Event, String> {
        let origins = self.training.as_ref().map(Training::origins).unwrap_or_default();
        let asked = (view, offset, count);
        let mut window = match self.fresh_audit() {
            Some(audit) => entries(audit.model(), asked, &origins, |id| audit.uses(id)),
            None => entries(&self.model()?, asked, &origins, |_| Rows::default()),
        };
        let named =
            window.lines.iter().flat_map(|line| line.uses.first.iter().take(MOST_SENTENCES));
        let mut rows: Vec<u32> = named.copied().collect();
        rows.sort_unstable();
        rows.dedup();
        let said = |row: u32| Some((row, self.sheet.examples().get(row as usize)?.command.clone()));
        window.sentences = rows.into_iter().filter_map(said).collect();
        Ok(Event::Entries(Box::new(window)))
    }

    /// What the model that was audited makes of a row.
    fn read_row(&mut self, row: u32) -> Result<Event, String> {
        let example = example(&self.sheet, row as usize)?.clone();
        let audit = self.audit.as_mut().ok_or("No model was asked about the rows yet.")?;
        let model = audit.model_mut();
        let parse = parsed(model, &example.command);
        let mut validator = Validator::new();
        let ids: Vec<PairId> = example
            .pairs
            .iter()
            .map(|pair| validator.shown(&pair.pre, &pair.post, pair.way.as_deref()))
            .collect();
        let before = example.pairs.first().map(|pair| pair.pre.clone());
        let readings = before.iter().flat_map(|before| {
            let some: Vec<_> = shown(&parse).collect();
            some.into_iter().map(|one| reading(model, &parse, one, before)).collect::<Vec<_>>()
        });
        let readings: Vec<_> = readings.collect();
        let mut valid = |form: &str| -> Vec<bool> {
            let Ok(form) = read_term(&mut model.grammar.terms, form) else { return Vec::new() };
            ids.iter().map(|&id| validator.valid(&model.grammar.terms, form, &[id])).collect()
        };
        let readings: Vec<_> = readings
            .into_iter()
            .map(|one| (valid(&one.form), one))
            .map(|(v, one)| (one, v))
            .collect();
        Ok(Event::RowReading(Box::new(RowReading {
            row,
            words: words(model, &parse, before.as_ref()),
            readings,
            n_readings: parse.readings.len(),
            reason: parse.reason.map(|reason| reason.name().to_owned()),
            probability: probability(model, &parse).map(|(probability, _)| probability),
            pairs: pairs(&example),
        })))
    }

    fn save_bad_rows(&self, file: usize) -> Result<Event, String> {
        let source = self.read.get(file).ok_or_else(|| format!("There is no file {file}."))?;
        if source.bad.kept == 0 {
            return Err(format!("{} has no bad rows.", source.name));
        }
        let name = name(&source.name, "bad", if source.is_json { "jsonl" } else { "csv" });
        Ok(Event::Saved { name, bytes: source.bad.text.clone() })
    }
}

fn example(sheet: &Sheet, row: usize) -> Result<&Example, String> {
    sheet.examples().get(row).ok_or_else(|| format!("The corpus has no row {row}."))
}

fn pairs(example: &Example) -> Vec<Shown> {
    let run = |start: &State, way: &Way| {
        let contrast = way.contrasts.iter().map(|contrast| letters(contrast)).collect();
        RunText { start: start.clone(), actions: letters(&way.actions), contrast }
    };
    let shown = |Pair { pre, post, way }: &Pair| Shown {
        pair: PairText { pre: pre.clone(), post: post.clone() },
        run: way.as_deref().map(|way| run(pre, way)),
    };
    example.pairs.iter().map(shown).collect()
}

/// The half of each row when a sheet is parted so.
fn halves(sheet: &Sheet, split: &Split) -> Result<Vec<Half>, String> {
    let examples = sheet.examples();
    let held_out: Vec<u32> = match split {
        Split::None => Vec::new(),
        Split::Share { percent, .. } if !(1..=99).contains(percent) => {
            return Err("The share that is held out must be between 1 and 99 percent.".to_owned());
        }
        Split::Share { by, percent, seed } => share(&by.keys(examples), *percent, *seed).test,
        Split::Named { workers, names } => {
            let is_named = |(row, example): (u32, &Example)| {
                let own = if *workers { &example.worker } else { &example.task };
                let own = own.as_deref().unwrap_or("");
                names.iter().any(|name| name == own).then_some(row)
            };
            (0..).zip(examples.iter()).filter_map(is_named).collect()
        }
    };
    let mut halves = vec![Half::Train; sheet.len()];
    held_out.into_iter().for_each(|row| halves[row as usize] = Half::HeldOut);
    Ok(halves)
}

/// The good rows of a file with what was decided of them.
fn save(sheet: &Sheet, file: usize, form: Option<Form>) -> Result<Event, String> {
    let source = sheet.sources().get(file).ok_or_else(|| format!("There is no file {file}."))?;
    let rows = sheet.rows_of(file);
    let own = if source.is_json { Form::JsonLines } else { Form::Csv };
    let form = form.unwrap_or(own);
    let examples = sheet.examples().get(rows.clone()).unwrap_or_default();
    let decisions = sheet.decisions().get(rows).unwrap_or_default();
    let rows = examples.iter().zip(decisions);
    let mut bytes = Vec::new();
    let (written, ending) = match form {
        Form::Csv => (table::write_rows(&source.columns, &source.mapping, rows, &mut bytes), "csv"),
        Form::JsonLines => (jsonl::write_rows(rows, &mut bytes), "jsonl"),
    };
    written.map_err(|error| format!("{} cannot be written: {error}.", source.name))?;
    Ok(Event::Saved { name: name(&source.name, "decided", ending), bytes })
}

/// The name of a file that is made of another.
fn name(from: &str, what: &str, ending: &str) -> String {
    let stem = from.strip_suffix(".gz").unwrap_or(from);
    let stem = stem.rsplit_once('.').map_or(stem, |(stem, _)| stem);
    format!("{stem}-{what}.{ending}")
}
