//! `generate`: tasks in, demonstrations out, pairs of states or runs, or a whole study; or worlds from a blueprint.

use super::arguments::Arguments;
use super::command::{Command, Done};
use super::corpora::text;
use super::failure::Failure;
use super::study::{self, Wanted};
use groundling::corpus::{Cells, Corpus, Decision, Example, jsonl, limits::MAX_PAIRS, table};
use groundling::domain::Blueprint;
use groundling::study::{StudyTask, TASKS, draw, read_tasks};
use std::ffi::{OsStr, OsString};
use std::io::{self, BufWriter, Write};

pub(crate) const COMMAND: Command = Command {
    name: "generate",
    about: "Draw pairs of states or runs for the tasks of a study, or worlds",
    usage: "--tasks FILE|all [--pairs N] | --goal FORM [--runs N] | --study NAME [OPTIONS] | --worlds N [OPTIONS]",
    details: "  --tasks FILE|all  a file of tasks, or the 23 of the corpus\n\
              \x20 --pairs N         pairs for each command, or runs where its goal is a task over time (3)\n\
              \x20 --goal FORM       one task: a row with runs if it speaks of time, with pairs otherwise\n\
              \x20 --runs N          runs of the row, the same as --pairs (3)\n\
              \x20 --seed N          of everything that is drawn (0)\n\
              \x20 --json            JSON lines instead of batch-results CSV\n\
              \n\
              A row a command: its task's name, the voice, its own pairs. Where a task has no voices, one way to say it\n\
              stands in the command's column, until people have said theirs (for a goal, the form). A run has contrasts:\n\
              what a robot would do without one of the task's steps or constraints, where that is not the task. What\n\
              the demonstrations of a row leave open, and runs without a contrast, are told on standard error.\n\
              \n\
              \x20 --study NAME      a study as one file instead, for collect.html: an item a task, 5 pairs each\n\
              \x20 --from CORPUS…    an item a row of a corpus instead, with the row's own pairs\n\
              \x20 --rehearsed       keep what was said of each row, rejected rows among them, for ?simulate=SEED\n\
              \x20 --ways            show the robot's way in every item, in place of what is before and after\n\
              \x20 --settings FILE   JSON of what else a study says: language, shown, asked, order, again, words, hosts,\n\
              \x20                   ends, pay, care\n\
              \n\
              \x20 --worlds N        instead of pairs: a world a line, as JSON, by the seeds from --seed on\n\
              \x20 --style STYLE     cuts, rows, or hall: rooms along a corridor (cuts)\n\
              \x20 --rooms N         3 to 12 (3)\n\
              \x20 --columns N       cells from west to east, 7 to 32 (9)\n\
              \x20 --rows N          cells from south to north, 7 to 32 (9)\n\
              \x20 --objects N       up to 8 (1)\n\
              \x20 --lock LOCK       of every door: unlocked, locked or unknown (unlocked)\n\
              \x20 --divided         two parts with no door between them",
    run,
};

#[derive(Default)]
struct Options {
    tasks: Option<OsString>,
    goal: Option<String>,
    worlds: Option<u64>,
    pairs: Option<usize>,
    /// What their number was called.
    shown: &'static str,
    seed: u64,
    json: bool,
    study: Wanted,
    blueprint: Blueprint,
}

fn run(mut arguments: Arguments) -> Result<Done, Failure> {
    let mut options = Options::default();
    // The last option that only worlds have, or only pairs.
    let (mut of_worlds, mut of_pairs) = (None, None);
    while let Some(name) = arguments.option()? {
        let blueprint = &mut options.blueprint;
        match name.as_str() {
            "seed" => options.seed = arguments.whole()?,
            "tasks" => options.tasks = Some(arguments.value()?),
            "goal" => options.goal = Some(arguments.text()?),
            "pairs" | "runs" => {
                if options.pairs.replace(arguments.whole()?).is_some() && options.shown != name {
                    let both = "--pairs and --runs are the same: leave one out";
                    return Err(Failure::Usage(both.into()));
                }
                options.shown = if name == "runs" { "runs" } else { "pairs" };
            }
            "json" => options.json = true,
            "study" => options.study.name = Some(arguments.text()?),
            "from" => options.study.corpus.extend(arguments.files()?),
            "rehearsed" => options.study.rehearsed = true,
            "ways" => options.study.ways = true,
            "settings" => options.study.settings = Some(arguments.file()?),
            "worlds" => options.worlds = Some(arguments.whole()?),
            "style" => blueprint.style = arguments.named()?,
            "rooms" => blueprint.rooms = arguments.whole()?,
            "columns" => blueprint.columns = arguments.whole()?,
            "rows" => blueprint.rows = arguments.whole()?,
            "objects" => blueprint.objects = arguments.whole()?,
            "lock" => blueprint.lock = arguments.named()?,
            "divided" => blueprint.connected = false,
            _ => return Err(arguments.unknown()),
        }
        match name.as_str() {
            "seed" | "json" => {}
            "tasks" | "goal" | "pairs" | "runs" | "study" | "from" | "rehearsed" | "ways"
            | "settings" => {
                of_pairs = Some(name);
            }
            _ => of_worlds = Some(name),
        }
    }
    match (of_pairs, of_worlds) {
        (Some(pairs), Some(worlds)) => Err(Failure::Usage(format!(
            "--{pairs} is for pairs of states and --{worlds} for worlds: leave one out"
        ))),
        (_, Some(_)) => worlds(&options),
        (_, None) if options.study.is_wanted() => {
            let tasks = options.tasks.as_ref().map(|file| tasks(file)).transpose()?;
            study::write(&options.study, tasks, options.pairs, options.seed)
        }
        (_, None) => pairs(&options),
    }
}

/// The tasks of a file, or all.
fn tasks(file: &OsStr) -> Result<Vec<StudyTask>, Failure> {
    let own = if file == "all" { None } else { Some(text(file.as_ref())?) };
    read_tasks(own.as_deref().unwrap_or(TASKS))
        .map_err(|e| Failure::Usage(format!("{}: {e}", file.to_string_lossy())))
}

/// Pairs for the tasks of a study.
fn pairs(options: &Options) -> Result<Done, Failure> {
    let n = options.pairs.unwrap_or(3);
    if !(1..=MAX_PAIRS).contains(&n) {
        return Err(Failure::Usage(format!("--{} {n}: use 1 to {MAX_PAIRS}", options.shown)));
    }
    let (place, tasks) = match (&options.tasks, &options.goal) {
        (Some(file), None) => (file.to_string_lossy(), tasks(file)?),
        (None, Some(goal)) => {
            let task = StudyTask::of(goal).map_err(|e| Failure::Usage(format!("--goal: {e}")))?;
            ("--goal".into(), vec![task])
        }
        (Some(_), Some(_)) => {
            return Err(Failure::Usage("--tasks and --goal: leave one out".into()));
        }
        (None, None) => {
            let missing = "--tasks FILE|all is missing, or --goal FORM, or --worlds N";
            return Err(Failure::Usage(missing.into()));
        }
    };
    let mut corpus = Corpus::default();
    let mut error = io::stderr();
    for task in &tasks {
        // Every command has pairs of its own.
        for (number, saying) in (0..).zip(&task.says) {
            let drawn = draw(&tasks, &task.name, n, options.seed.wrapping_add(number))
                .map_err(|e| Failure::Usage(format!("{place}: {e}")))?;
            let id = match saying.voice {
                Some(_) => format!("{}-{}", task.name, number + 1),
                None => task.name.clone(),
            };
            if !drawn.open.is_empty() {
                // Nobody may be listening there; the pairs are good all the same.
                let open = drawn.open.join(", ");
                let _ = writeln!(error, "{id}: with {n} a task this stays open: {open}");
            }
            for (number, pair) in (1..).zip(&drawn.pairs) {
                if pair.way.as_ref().is_some_and(|way| way.contrasts.is_empty()) {
                    let _ = writeln!(error, "{id}: run {number} has no contrast");
                }
            }
            corpus.examples.push(Example {
                id,
                line: 0,
                command: saying.words.clone(),
                task: Some(task.name.clone()),
                worker: saying.voice.clone(),
                decision: Decision::Open,
                pairs: drawn.pairs,
                rest: Cells::default(),
                keys: Cells::default(),
            });
        }
    }
    let out = BufWriter::new(io::stdout().lock());
    if options.json { jsonl::write(&corpus, out) } else { table::write(&corpus, out) }
        .map_err(Failure::Output)?;
    Ok(Done::Well)
}

/// Worlds from a blueprint, a line each.
fn worlds(options: &Options) -> Result<Done, Failure> {
    let n = options.worlds.ok_or_else(|| Failure::Usage("--worlds N is missing".into()))?;
    let mut out = BufWriter::new(io::stdout().lock());
    for seed in (0..n).map(|i| options.seed.wrapping_add(i)) {
        let state = options
            .blueprint
            .build(seed)
            .map_err(|e| Failure::Usage(format!("the world of seed {seed}: {e}")))?;
        writeln!(out, "{}", state.write()).map_err(Failure::Output)?;
    }
    out.flush().map_err(Failure::Output)?;
    Ok(Done::Well)
}
