//! `train`: corpora in, a model file out.

use super::arguments::Arguments;
use super::command::{Command, Done};
use super::corpora::{Admit, Loaded, mapped, mapping, model, text};
use super::failure::Failure;
use super::figures::scores_json;
use super::output::{Output, outputs, report as say};
use groundling::ccg::{ChartConfig, Doubt, EntryText, Kind};
use groundling::corpus::Example;
use groundling::learn::{CLEANUP_LEXICON, Config, Evaluation, Taught, Trainer, seed_model, teach};
use serde_json::{Value, json};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

pub(crate) const COMMAND: Command = Command {
    name: "train",
    about: "Learn a parser from commands and the states before and after them",
    usage: "[--into MODEL] --corpus FILE… --out MODEL [OPTIONS]",
    details: "  --corpus FILE…        batch-results CSV or JSON, found out by what is in it\n\
              \x20 --out MODEL           where the model goes; - is standard output\n\
              \x20 --mapping FILE        which column says what, where their names do not tell\n\
              \x20 --demonstrations N    look at the first N pairs of each row (all)\n\
              \x20 --with-rejected       use rejected rows too\n\
              \x20 --epochs N            passes over the corpus (15)\n\
              \x20 --beam N              edges per span when parsing (150)\n\
              \x20 --lexical-beam N      edges per span when generating entries (75)\n\
              \x20 --seed N              of the order of examples in each epoch (0)\n\
              \x20 --margin X            by how much a valid reading is to outscore an invalid one (2)\n\
              \x20 --generations N       epochs in which entries are generated (2)\n\
              \x20 --without KIND…       do without features: lexeme, template, entry, rule, pair, conjoined, alone, head\n\
              \x20 --lexicon FILE        the seed lexicon (that of the whole domain)\n\
              \x20 --without-idioms      give no whole command a meaning of its own\n\
              \x20 --without-contrasts   look at no contrasts of runs: at what was done alone\n\
              \x20 --doubt MAP           how far its answers can be trusted, as `calibrate` learned it\n\
              \x20 --held-out FILE…      score every epoch's model on these corpora\n\
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
    held_out: Vec<PathBuf>,
    doubt: Option<PathBuf>,
    checkpoint: Option<PathBuf>,
    resume: Option<PathBuf>,
    into: Option<PathBuf>,
    mapping: Option<PathBuf>,
    with_rejected: bool,
    json: bool,
    config: Config,
}

fn run(arguments: Arguments) -> Result<Done, Failure> {
    let options = read_options(arguments)?;
    let missing = |what: &str| Failure::Usage(format!("{what} is missing"));
    if options.corpus.is_empty() {
        return Err(missing("--corpus FILE"));
    }
    let others = [&options.lexicon, &options.doubt, &options.mapping];
    let inputs = options.corpus.iter().chain(&options.held_out).chain(others.into_iter().flatten());
    let named =
        [("--out", options.out.as_deref()), ("--checkpoint", options.checkpoint.as_deref())];
    // What is gone on from may be replaced: by what it has become.
    let [out, checkpoint] = outputs(named, inputs)?;
    let out = out.ok_or_else(|| missing("--out MODEL"))?;
    let mapping = options.mapping.as_deref().map(mapping).transpose()?.unwrap_or_default();
    let admit = Admit::with_rejected(options.with_rejected);
    let loaded = mapped(&options.corpus, mapping.clone(), admit)?;
    // Standard error may be gone; the work goes on.
    let _ = writeln!(io::stderr(), "{}", loaded.rows);
    if let Some(path) = &options.into {
        return into(path, &loaded, &options, &out);
    }
    let Loaded { examples: training, rows, .. } = loaded;
    let Loaded { examples: held_out, rows: held_out_rows, .. } =
        mapped(&options.held_out, mapping, admit)?;
    if !held_out.is_empty() {
        // Standard error may be gone; the work goes on.
        let _ = writeln!(io::stderr(), "held out: {held_out_rows}");
    }
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
        if let Some(checkpoint) = &checkpoint {
            checkpoint.write(&trainer.checkpoint())?;
        }
    }
    let entries = trainer.model().lexicon.len();
    let mut model = trainer.end();
    model.doubt = doubt;
    out.write(&model.print())?;
    if options.json {
        let mut report = json!({
            "examples": training.len(), "entries": entries, "epochs": epochs,
            "seconds": started.elapsed().as_secs_f64(), "model": out.name(),
        });
        rows.put(&mut report);
        if !held_out.is_empty() {
            report["held_out"] = json!({});
            held_out_rows.put(&mut report["held_out"]);
        }
        say([&out].into_iter().chain(&checkpoint), &report.to_string())?;
    }
    Ok(Done::Well)
}

/// The map of how far answers can be trusted in a file.
fn doubt_of(path: &Path) -> Result<Doubt, Failure> {
    Doubt::read(&text(path)?).map_err(|e| Failure::Usage(format!("{}: {e}", path.display())))
}

/// Teaches a finished model a few examples besides.
fn into(path: &Path, loaded: &Loaded, options: &Options, out: &Output) -> Result<Done, Failure> {
    let Loaded { examples, rows, .. } = loaded;
    let model = model(path)?;
    let started = Instant::now();
    let demonstrations = options.config.demonstrations;
    let config = Config { demonstrations, ..Config::of(&model) };
    let Taught { model, entries, understood } = teach(model, examples, config)
        .map_err(|e| Failure::Usage(format!("{}: {e}", path.display())))?;
    let seconds = started.elapsed().as_secs_f64();
    out.write(&model.print())?;
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
        let mut report = json!({
            "examples": n_examples, "entries": model.lexicon.len(),
            "added": added.collect::<Vec<_>>(), "commands": commands.collect::<Vec<_>>(),
            "seconds": seconds, "model": out.name(),
        });
        rows.put(&mut report);
        say([out], &report.to_string())?;
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

fn read_options(mut arguments: Arguments) -> Result<Options, Failure> {
    use lexopt::Arg::{Long, Value};
    let mut options = Options::default();
    // Which list of files goes on.
    let mut list = None;
    while let Some(argument) = arguments.next()? {
        let held_out = match (&argument, list.take()) {
            (Long("corpus"), _) => Some(false),
            (Long("held-out"), _) => Some(true),
            (Value(_), held_out) => held_out,
            _ => None,
        };
        if let Some(is_held_out) = held_out {
            let file = match argument {
                Value(file) => file,
                _ => arguments.one_more()?,
            };
            let files = if is_held_out { &mut options.held_out } else { &mut options.corpus };
            files.push(file.into());
            list = held_out;
            continue;
        }
        match argument {
            Long("out") => options.out = Some(arguments.file()?),
            Long("lexicon") => options.lexicon = Some(arguments.file()?),
            Long("checkpoint") => options.checkpoint = Some(arguments.file()?),
            Long("into") => options.into = Some(arguments.file()?),
            Long("resume") => options.resume = Some(arguments.file()?),
            Long("with-rejected") => options.with_rejected = true,
            Long("json") => options.json = true,
            Long("demonstrations") => options.config.demonstrations = Some(arguments.count()?),
            Long("epochs") => options.config.epochs = arguments.count()?,
            Long("beam") => options.config.beam = arguments.count()?,
            Long("lexical-beam") => options.config.lexical_beam = arguments.count()?,
            Long("doubt") => options.doubt = Some(arguments.file()?),
            Long("mapping") => options.mapping = Some(arguments.file()?),
            Long("margin") => options.config.margin = arguments.number(0.0..=1_000.0)?,
            Long("generations") => options.config.generations = arguments.whole()?,
            Long("without") => {
                for name in arguments.texts()? {
                    let kind = kind(&name)?;
                    options.config.without = options.config.without.iter().chain([kind]).collect();
                }
            }
            Long("without-idioms") => options.config.idioms = false,
            Long("without-contrasts") => options.config.contrasts = false,
            Long("seed") => options.config.seed = arguments.whole()?,
            other => return Err(other.unexpected().into()),
        }
    }
    Ok(options)
}

fn kind(name: &str) -> Result<Kind, Failure> {
    Kind::named(name).ok_or_else(|| {
        let names = Kind::ALL.map(|(name, _)| name).join(", ");
        Failure::Usage(format!("--without `{name}`: use one of {names}"))
    })
}
