//! `train`: corpora in, a model file out.

use super::command::{Command, Done, Failure};
use super::corpora::{examples, model, text, write};
use super::figures::scores_json;
use groundling::ccg::{ChartConfig, Doubt, EntryText};
use groundling::corpus::Example;
use groundling::learn::{CLEANUP_LEXICON, Config, Evaluation, Taught, Trainer, seed_model, teach};
use lexopt::ValueExt;
use serde_json::{Value, json};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

pub(crate) const COMMAND: Command = Command {
    name: "train",
    about: "Learn a parser from commands and the states before and after them",
    usage: "[--into MODEL] --corpus FILE… --out MODEL [OPTIONS]",
    details: "  --corpus FILE…        batch-results CSV or JSON lines (.jsonl)\n\
              \x20 --out MODEL           where the model goes\n\
              \x20 --demonstrations N    look at the first N pairs of each row (all)\n\
              \x20 --with-rejected       use rejected rows too\n\
              \x20 --epochs N            passes over the corpus (15)\n\
              \x20 --beam N              edges per span when parsing (150)\n\
              \x20 --lexical-beam N      edges per span when generating entries (75)\n\
              \x20 --seed N              of the order of examples in each epoch (0)\n\
              \x20 --lexicon FILE        the seed lexicon (that of the whole domain)\n\
              \x20 --without-idioms      give no whole command a meaning of its own\n\
              \x20 --doubt MAP           how far its answers can be trusted, as `calibrate` learned it\n\
              \x20 --held-out FILE       score every epoch's model on this corpus\n\
              \x20 --checkpoint FILE     keep a file to go on from, after each epoch\n\
              \x20 --resume FILE         go on from such a file, with the same corpus and settings\n\
              \x20 --into MODEL          teach a finished model these few examples besides, with its own settings:\n\
              \x20                       of the options above only --demonstrations and --with-rejected count\n\
              \x20 --json                print a report as one JSON object",
    run,
};

#[derive(Default)]
struct Options {
    corpus: Vec<PathBuf>,
    out: Option<PathBuf>,
    lexicon: Option<PathBuf>,
    held_out: Option<PathBuf>,
    doubt: Option<PathBuf>,
    checkpoint: Option<PathBuf>,
    resume: Option<PathBuf>,
    into: Option<PathBuf>,
    with_rejected: bool,
    json: bool,
    config: Config,
}

fn run(arguments: lexopt::Parser) -> Result<Done, Failure> {
    let mut options = read_options(arguments)?;
    let missing = |what: &str| Failure::Usage(format!("{what} is missing"));
    let out = options.out.take().ok_or_else(|| missing("--out MODEL"))?;
    if options.corpus.is_empty() {
        return Err(missing("--corpus FILE"));
    }
    let training = examples(&options.corpus, options.with_rejected)?;
    if let Some(path) = &options.into {
        return into(path, &training, &options, &out);
    }
    let held_out = match &options.held_out {
        Some(path) => examples(std::slice::from_ref(path), options.with_rejected)?,
        None => Vec::new(),
    };
    let doubt = options.doubt.as_deref().map(doubt_of).transpose()?;
    let started = Instant::now();
    let mut trainer = match &options.resume {
        Some(path) => Trainer::resume(model(path)?, &training, options.config.clone())
            .map_err(|e| Failure::Usage(format!("{}: {e}", path.display())))?,
        None => {
            let own = options.lexicon.as_deref().map(text).transpose()?;
            let lexicon = own.as_deref().unwrap_or(CLEANUP_LEXICON);
            let place =
                options.lexicon.map_or("the lexicon".into(), |path| path.display().to_string());
            let seed = seed_model(lexicon).map_err(|e| Failure::Usage(format!("{place}: {e}")))?;
            Trainer::new(seed, &training, options.config.clone())
        }
    };
    let mut epochs = Vec::new();
    while !trainer.is_done() {
        let Some(progress) = trainer.step() else { continue };
        if progress.example < trainer.n_examples() || progress.epoch > options.config.epochs {
            continue;
        }
        let seconds = started.elapsed().as_secs_f64();
        let epoch = progress.so_far;
        // Standard error may be gone; the work goes on.
        let _ = writeln!(
            io::stderr(),
            "epoch {} of {}: {} of {} commands have a valid parse, {} updates, {} entries, {seconds:.1} s",
            progress.epoch,
            options.config.epochs,
            epoch.valid,
            progress.example,
            epoch.updates,
            epoch.entries,
        );
        let mut report = json!({
            "epoch": progress.epoch, "valid": epoch.valid, "updates": epoch.updates,
            "entries": epoch.entries, "over_budget": epoch.over_budget, "seconds": seconds,
        });
        if !held_out.is_empty() {
            report["held_out"] = held_out_scores(&trainer, &held_out);
        }
        epochs.push(report);
        if let Some(path) = &options.checkpoint {
            write(path, &trainer.checkpoint())?;
        }
    }
    let entries = trainer.model().lexicon.len();
    let mut model = trainer.end();
    model.doubt = doubt;
    write(&out, &model.print())?;
    if options.json {
        let report = json!({
            "examples": training.len(), "entries": entries, "epochs": epochs,
            "seconds": started.elapsed().as_secs_f64(), "model": out.display().to_string(),
        });
        writeln!(io::stdout(), "{report}").map_err(Failure::Output)?;
    }
    Ok(Done::Well)
}

/// The map of how far answers can be trusted in a file.
fn doubt_of(path: &Path) -> Result<Doubt, Failure> {
    Doubt::read(&text(path)?).map_err(|e| Failure::Usage(format!("{}: {e}", path.display())))
}

/// Teaches a finished model a few examples besides.
fn into(path: &Path, examples: &[Example], options: &Options, out: &Path) -> Result<Done, Failure> {
    let model = model(path)?;
    let started = Instant::now();
    let demonstrations = options.config.demonstrations;
    let config = Config { demonstrations, ..Config::of(&model) };
    let Taught { model, entries, understood } = teach(model, examples, config)
        .map_err(|e| Failure::Usage(format!("{}: {e}", path.display())))?;
    let seconds = started.elapsed().as_secs_f64();
    write(out, &model.print())?;
    let n_understood = understood.iter().filter(|&&understood| understood).count();
    let (n_examples, n_entries) = (examples.len(), entries.len());
    let _ = writeln!(
        io::stderr(),
        "{n_understood} of {n_examples} commands are understood, {n_entries} entries are new, {seconds:.1} s",
    );
    if options.json {
        let added = entries.iter().map(|&id| EntryText::of(&model, id));
        let commands = examples.iter().zip(&understood).map(
            |(example, understood)| json!({ "command": example.command, "understood": understood }),
        );
        let report = json!({
            "examples": n_examples, "entries": model.lexicon.len(),
            "added": added.collect::<Vec<_>>(), "commands": commands.collect::<Vec<_>>(),
            "seconds": seconds, "model": out.display().to_string(),
        });
        writeln!(io::stdout(), "{report}").map_err(Failure::Output)?;
    }
    Ok(Done::Well)
}

/// Scores the model as it is on held-out commands; training does not notice.
fn held_out_scores(trainer: &Trainer, examples: &[Example]) -> Value {
    let mut model = trainer.averaged();
    let config = ChartConfig::of(&model);
    let mut evaluation = Evaluation::new(&mut model, examples, config);
    while evaluation.step().is_some() {}
    scores_json(evaluation.scores())
}

fn read_options(mut arguments: lexopt::Parser) -> Result<Options, Failure> {
    use lexopt::Arg::{Long, Value};
    let mut options = Options::default();
    let mut in_corpus = false;
    while let Some(argument) = arguments.next()? {
        let was_in_corpus = std::mem::take(&mut in_corpus);
        match argument {
            Long("corpus") => {
                options.corpus.push(arguments.value()?.into());
                in_corpus = true;
            }
            Value(file) if was_in_corpus => {
                options.corpus.push(file.into());
                in_corpus = true;
            }
            Long("out") => options.out = Some(arguments.value()?.into()),
            Long("lexicon") => options.lexicon = Some(arguments.value()?.into()),
            Long("held-out") => options.held_out = Some(arguments.value()?.into()),
            Long("checkpoint") => options.checkpoint = Some(arguments.value()?.into()),
            Long("into") => options.into = Some(arguments.value()?.into()),
            Long("resume") => options.resume = Some(arguments.value()?.into()),
            Long("with-rejected") => options.with_rejected = true,
            Long("json") => options.json = true,
            Long("demonstrations") => {
                options.config.demonstrations =
                    Some(at_least_one(&mut arguments, "--demonstrations")?);
            }
            Long("epochs") => options.config.epochs = at_least_one(&mut arguments, "--epochs")?,
            Long("beam") => options.config.beam = at_least_one(&mut arguments, "--beam")?,
            Long("lexical-beam") => {
                options.config.lexical_beam = at_least_one(&mut arguments, "--lexical-beam")?;
            }
            Long("doubt") => options.doubt = Some(arguments.value()?.into()),
            Long("without-idioms") => options.config.idioms = false,
            Long("seed") => options.config.seed = arguments.value()?.parse()?,
            other => return Err(other.unexpected().into()),
        }
    }
    Ok(options)
}

pub(crate) fn at_least_one(arguments: &mut lexopt::Parser, name: &str) -> Result<u32, Failure> {
    match arguments.value()?.parse()? {
        0 => Err(Failure::Usage(format!("{name} must be at least 1"))),
        n => Ok(n),
    }
}
