//! `generate`: tasks in, pairs of states out, for a study.

use super::command::{Command, Done, Failure};
use super::corpora::text;
use groundling::corpus::{Corpus, Example, example::MAX_PAIRS, jsonl, mturk};
use groundling::study::{TASKS, draw, read_tasks};
use lexopt::ValueExt;
use std::io::{self, BufWriter, Write};

pub(crate) const COMMAND: Command = Command {
    name: "generate",
    about: "Draw pairs of states, before and after, for the tasks of a study",
    usage: "--tasks FILE|all [--pairs N] [--seed N] [--json]",
    details: "  --tasks FILE|all  a file of tasks, or the 23 of the corpus\n\
              \x20 --pairs N         pairs for each task (3)\n\
              \x20 --seed N          of everything that is drawn (0)\n\
              \x20 --json            JSON lines instead of batch-results CSV\n\
              \n\
              A row a task: its name, its pairs, and in the command's column one way to say it, until people have\n\
              said theirs. What the pairs of a task leave open is told on standard error.",
    run,
};

fn run(mut arguments: lexopt::Parser) -> Result<Done, Failure> {
    let (mut file, mut n, mut seed, mut json) = (None, 3_usize, 0_u64, false);
    while let Some(argument) = arguments.next()? {
        match argument {
            lexopt::Arg::Long("tasks") => file = Some(arguments.value()?),
            lexopt::Arg::Long("pairs") => n = arguments.value()?.parse()?,
            lexopt::Arg::Long("seed") => seed = arguments.value()?.parse()?,
            lexopt::Arg::Long("json") => json = true,
            other => return Err(other.unexpected().into()),
        }
    }
    let file = file.ok_or_else(|| Failure::Usage("--tasks FILE|all is missing".into()))?;
    if !(1..=MAX_PAIRS).contains(&n) {
        return Err(Failure::Usage(format!("--pairs {n}: use 1 to {MAX_PAIRS}")));
    }
    let own = if file == "all" { None } else { Some(text(file.as_ref())?) };
    let place = file.to_string_lossy();
    let tasks = read_tasks(own.as_deref().unwrap_or(TASKS))
        .map_err(|e| Failure::Usage(format!("{place}: {e}")))?;
    let mut corpus = Corpus::default();
    let mut error = io::stderr();
    for task in &tasks {
        let drawn = draw(&tasks, &task.name, n, seed)
            .map_err(|e| Failure::Usage(format!("{place}: {e}")))?;
        if !drawn.open.is_empty() {
            // Nobody may be listening there; the pairs are good all the same.
            let open = drawn.open.join(", ");
            let _ = writeln!(error, "{}: with {n} a task this stays open: {open}", task.name);
        }
        corpus.examples.push(Example {
            id: task.name.clone(),
            line: 0,
            command: task.says.clone(),
            task: Some(task.name.clone()),
            worker: None,
            pairs: drawn.pairs,
            rest: Vec::new(),
        });
    }
    let out = BufWriter::new(io::stdout().lock());
    if json { jsonl::write(&corpus, out) } else { mturk::write(&corpus, out) }
        .map_err(Failure::Output)?;
    Ok(Done::Well)
}
