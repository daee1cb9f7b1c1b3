//! The command line: one table of commands, one file a command in `groundling/`. Results go to standard
//! output, everything else to standard error; exit 0 when all went well, 2 on bad arguments or input.
//! To add a command, write its file and put its `COMMAND` into [`COMMANDS`].

#[path = "groundling/failure.rs"]
mod failure;
#[path = "groundling/arguments.rs"]
mod arguments;
#[path = "groundling/command.rs"]
mod command;
#[path = "groundling/corpora.rs"]
mod corpora;
#[path = "groundling/identity.rs"]
mod identity;
#[path = "groundling/output.rs"]
mod output;
#[path = "groundling/figures.rs"]
mod figures;
#[path = "groundling/parallel.rs"]
mod parallel;
#[path = "groundling/train.rs"]
mod train;
#[path = "groundling/calibrate.rs"]
mod calibrate;
#[path = "groundling/evaluate.rs"]
mod evaluate;
#[path = "groundling/compare.rs"]
mod compare;
#[path = "groundling/parse.rs"]
mod parse;
#[path = "groundling/holds.rs"]
mod holds;
#[path = "groundling/equivalent.rs"]
mod equivalent;
#[path = "groundling/plan.rs"]
mod plan;
#[path = "groundling/reduce.rs"]
mod reduce;
#[path = "groundling/experiment.rs"]
mod experiment;
#[path = "groundling/study.rs"]
mod study;
#[path = "groundling/generate.rs"]
mod generate;
#[path = "groundling/review.rs"]
mod review;

use arguments::Arguments;
use command::{Command, Done};
use failure::Failure;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

/// Every command, in the order of the help.
const COMMANDS: &[Command] = &[
    train::COMMAND,
    calibrate::COMMAND,
    evaluate::COMMAND,
    compare::COMMAND,
    parse::COMMAND,
    holds::COMMAND,
    equivalent::COMMAND,
    plan::COMMAND,
    reduce::COMMAND,
    experiment::COMMAND,
    generate::COMMAND,
    review::COMMAND,
];

fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    let name = arguments.first().map(|a| a.to_string_lossy().into_owned()).unwrap_or_default();
    let rest = arguments.get(1..).unwrap_or_default();
    let (place, outcome) = match COMMANDS.iter().find(|c| c.name == name) {
        Some(command) if asks_for_help(rest) => (command.name, say(&command.help())),
        Some(command) => (command.name, (command.run)(Arguments::new(rest))),
        None => ("", without_command(&name)),
    };
    let message = match outcome {
        Ok(Done::Well) => return ExitCode::SUCCESS,
        Ok(Done::WithBadLines) => return ExitCode::from(2),
        // Whoever reads us has seen enough.
        Err(Failure::Output(e)) if e.kind() == io::ErrorKind::BrokenPipe => {
            return ExitCode::SUCCESS;
        }
        Err(failure) => failure.to_string(),
    };
    let line = message.split_whitespace().collect::<Vec<_>>().join(" ");
    let place = if place.is_empty() { String::new() } else { format!(" {place}") };
    // When standard error is gone too, the exit code has to say it all.
    let _ = writeln!(io::stderr(), "groundling{place}: {line}");
    ExitCode::from(2)
}

/// Help, the version, or what is wrong with the first word.
fn without_command(name: &str) -> Result<Done, Failure> {
    match name {
        "-h" | "--help" | "help" => say(&overview()),
        "-V" | "--version" => say(concat!("groundling ", env!("CARGO_PKG_VERSION"), "\n")),
        "" => Err(Failure::Usage("no command given; `groundling --help` lists them".into())),
        _ => {
            let all: Vec<&str> = COMMANDS.iter().map(|c| c.name).collect();
            Err(Failure::Usage(format!("no command `{name}`: use one of {}", all.join(", "))))
        }
    }
}

/// Whether `-h` or `--help` stands among the arguments before a `--`.
fn asks_for_help(arguments: &[OsString]) -> bool {
    arguments.iter().take_while(|a| *a != "--").any(|a| a == "-h" || a == "--help")
}

/// All commands, a line each.
fn overview() -> String {
    let mut text = String::from(
        "From a sentence to a moving robot: parse, ground, plan.\n\n\
         Usage: groundling COMMAND [OPTIONS]\n\nCommands:\n",
    );
    for command in COMMANDS {
        text.push_str(&format!("  {:<10}  {}\n", command.name, command.about));
    }
    text.push_str("\n`groundling COMMAND --help` shows a command's options.\n");
    text
}

/// Writes to standard output.
fn say(text: &str) -> Result<Done, Failure> {
    io::stdout().write_all(text.as_bytes()).map_err(Failure::Output)?;
    Ok(Done::Well)
}
