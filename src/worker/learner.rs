//! The program that learns: reads corpora, trains, teaches, runs experiments. The page loads it when there is something
//! to be learned; what it learns goes to the talker as a model file.

use super::experiment::Experimenting;
use super::job::{Job, Role, Step, misdirected, say};
use super::progress::{CorpusReading, Read, progress};
use super::protocol::{
    CorpusFile, CorpusReport, Event, Lesson, MOST_TAUGHT, PairText, Program, Request, RowSummary,
    SeedLexicon, TeachReport, TrainSettings,
};
use super::talker::report;
use crate::ccg::{EntryText, Model};
use crate::corpus::{Cells, Corpus, Decision, Example, Options, Pair};
use crate::learn::{
    CLEANUP_LEXICON, Config, DEMONSTRATION_LEXICON, Taught, Teaching, Trainer, seed_model,
};

/// What the learner keeps.
#[derive(Default)]
pub struct Learner {
    corpus: Corpus,
}

impl Role for Learner {
    const PROGRAM: Program = Program::Learner;

    fn begin(&mut self, request: Request) -> Result<Job<Learner>, String> {
        match request {
            Request::ReadCorpus { files, with_rejected } => {
                Ok(read_corpus(files, Options { with_rejected, ..Options::default() }))
            }
            Request::ShowRow { row } => self.show_row(row),
            Request::Train { lexicon, settings } => self.train(lexicon, &settings),
            Request::Teach { model, examples } => teach(&model, examples),
            Request::Experiment { experiment, settings } => {
                let config = self.config(&settings)?;
                let mut work = Experimenting::new(experiment, &self.corpus.examples, config)?;
                Ok(Box::new(move |_| work.step()))
            }
            other => Err(misdirected(&other, Self::PROGRAM)),
        }
    }
}

impl Learner {
    fn keep(&mut self, name: String, Read { corpus, problems }: Read) -> Event {
        let rows = corpus.examples.iter().map(|example| RowSummary {
            command: example.command.clone(),
            task: example.task.clone(),
            pairs: example.pairs.len(),
        });
        let rows = rows.collect();
        let Corpus { rejected, left_out, .. } = corpus;
        let report = CorpusReport { name, rows, rejected, left_out, problems };
        if !corpus.examples.is_empty() {
            self.corpus = corpus;
        }
        Event::Corpus(report)
    }

    fn show_row(&self, row: usize) -> Result<Job<Learner>, String> {
        let example = self.corpus.examples.get(row);
        let example = example.ok_or_else(|| format!("The corpus has no row {row}."))?;
        let pairs = example.pairs.iter();
        let pairs = pairs.map(|p| PairText { pre: p.pre.clone(), post: p.post.clone() });
        say(Event::Row { row, pairs: pairs.collect() })
    }

    fn train(
        &self,
        lexicon: SeedLexicon,
        settings: &TrainSettings,
    ) -> Result<Job<Learner>, String> {
        let config = self.config(settings)?;
        let lexicon = match lexicon {
            SeedLexicon::Demonstration => DEMONSTRATION_LEXICON,
            SeedLexicon::Domain => CLEANUP_LEXICON,
        };
        let seed = seed_model(lexicon)
            .map_err(|error| format!("The seed lexicon cannot be read: {error}."))?;
        let mut run = Some(Trainer::new(seed, &self.corpus.examples, config));
        Ok(Box::new(move |_| match run.take() {
            Some(trainer) if trainer.is_done() => {
                let model = trainer.end();
                Step::Over(Event::Trained(report(&model, model.print())))
            }
            Some(mut trainer) => {
                let said = trainer.step().map(|done| {
                    let (passes, examples) = (trainer.config().passes(), trainer.n_examples());
                    Event::Progress(progress(done, passes, examples))
                });
                run = Some(trainer);
                Step::Working(said)
            }
            None => Step::Working(None),
        }))
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
}

fn read_corpus(files: Vec<CorpusFile>, options: Options) -> Job<Learner> {
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    let name = names.join(", ");
    let mut reading = CorpusReading::new(files, options);
    let mut told = 0;
    Box::new(move |learner| match reading.step() {
        Some(read) => Step::Over(learner.keep(name.clone(), read)),
        None => {
            let (done, of) = reading.progress();
            let is_news = std::mem::replace(&mut told, done) < done && done < of;
            Step::Working(is_news.then_some(Event::Reading { done, of }))
        }
    })
}

fn teach(model: &str, lessons: Vec<Lesson>) -> Result<Job<Learner>, String> {
    if lessons.is_empty() || lessons.len() > MOST_TAUGHT {
        return Err(format!("Teach between 1 and {MOST_TAUGHT} commands at once."));
    }
    if let Some(bare) = lessons.iter().find(|lesson| lesson.pairs.is_empty()) {
        return Err(format!("Show what to do when one says {:?}.", bare.command));
    }
    let model =
        Model::read(model).map_err(|error| format!("The model cannot be read: {error}."))?;
    let examples: Vec<Example> = lessons.into_iter().map(example).collect();
    let config = Config { demonstrations: None, ..Config::of(&model) };
    let teaching = Teaching::new(model, &examples, config)
        .map_err(|error| format!("The model cannot be taught: {error}."))?;
    let mut teaching = Some(teaching);
    Ok(Box::new(move |_| match teaching.take_if(|teaching| teaching.is_done()) {
        Some(done) => Step::Over(taught(done.end())),
        None => {
            teaching.iter_mut().for_each(Teaching::step);
            Step::Working(None)
        }
    }))
}

fn taught(Taught { model, entries, understood }: Taught) -> Event {
    let added = entries.into_iter().map(|id| EntryText::of(&model, id)).collect();
    let model = report(&model, model.print());
    Event::Taught(Box::new(TeachReport { model, added, understood }))
}

fn example(lesson: Lesson) -> Example {
    let pairs = lesson.pairs.into_iter().map(|PairText { pre, post }| Pair { pre, post });
    Example {
        id: "taught".to_owned(),
        line: 0,
        command: lesson.command,
        task: None,
        worker: None,
        decision: Decision::Open,
        pairs: pairs.collect(),
        rest: Cells::default(),
    }
}
