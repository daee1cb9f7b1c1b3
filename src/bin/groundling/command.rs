//! What the commands share: their row in the table, their ends, and a stream of lines in which a bad line
//! is answered in its place and the rest goes on.

use super::arguments::Arguments;
use super::failure::{Failure, name};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};

/// One row of the table of commands.
pub(crate) struct Command {
    /// The word that calls it.
    pub(crate) name: &'static str,
    /// What it does, in a line.
    pub(crate) about: &'static str,
    /// What may follow the name.
    pub(crate) usage: &'static str,
    /// Input, output and options, in lines.
    pub(crate) details: &'static str,
    /// Runs it on what follows its name.
    pub(crate) run: fn(Arguments) -> Result<Done, Failure>,
}

impl Command {
    /// The text of `--help`.
    pub(crate) fn help(&self) -> String {
        let Self { name, about, usage, details, .. } = self;
        format!("{about}\n\nUsage: groundling {name} {usage}\n\n{details}\n")
    }
}

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Done {
    /// Everything was answered.
    Well,
    /// Some lines of the input were bad, and answered so.
    WithBadLines,
}

/// Writes a result to standard output, as a line or lines of its own.
pub(crate) fn print(text: &str) -> Result<Done, Failure> {
    writeln!(io::stdout(), "{text}").map_err(Failure::Output)?;
    Ok(Done::Well)
}

/// Longest line that is read, in bytes: far above any state or command.
const MAX_LINE: u64 = 16 << 20;

/// Reads the arguments of a command that takes files and nothing else (`--json` is what it does anyway).
pub(crate) fn only_files(mut arguments: Arguments) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    while let Some(argument) = arguments.next()? {
        match argument {
            lexopt::Arg::Value(file) => files.push(file.into()),
            lexopt::Arg::Long("json") => {}
            other => return Err(other.unexpected().into()),
        }
    }
    Ok(files)
}

/// What a blank line in a stream is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Blank {
    /// An input like any other.
    IsALine,
    /// A mistake, but at the very end, where it is nothing.
    IsAMistake,
}

/// Answers every line of the files (standard input when there are none; `-` names it too) with a line on
/// standard output; a line that `answer` refuses, with `{"error", "line"}`.
pub(crate) fn answer_lines(
    files: &[PathBuf],
    blank: Blank,
    mut answer: impl FnMut(&str) -> Result<String, String>,
) -> Result<Done, Failure> {
    let standard = [PathBuf::new()];
    let mut done = Done::Well;
    for path in if files.is_empty() { &standard } else { files } {
        let failed = |source| Failure::Input { path: path.clone(), source };
        let mut input = open(path).map_err(failed)?;
        let prefix = if files.len() > 1 { format!("{}: ", name(path)) } else { String::new() };
        let (mut number, mut empty) = (0, 0);
        while let Some(line) = next_line(&mut *input, number == 0).map_err(failed)? {
            number += 1;
            let is_blank = matches!(&line, Ok(text) if text.trim().is_empty());
            if is_blank && blank == Blank::IsAMistake {
                empty += 1;
                continue;
            }
            for at in number - empty..number {
                done = refuse(&format!("{prefix}the line is empty"), at)?;
            }
            empty = 0;
            match line.and_then(|text| answer(&text)) {
                Ok(text) => writeln!(io::stdout(), "{text}").map_err(Failure::Output)?,
                Err(error) => done = refuse(&format!("{prefix}{error}"), number)?,
            }
        }
    }
    Ok(done)
}

/// Answers a bad line.
fn refuse(error: &str, line: u64) -> Result<Done, Failure> {
    let answer = serde_json::json!({ "error": error, "line": line });
    writeln!(io::stdout(), "{answer}").map_err(Failure::Output)?;
    Ok(Done::WithBadLines)
}

fn open(path: &Path) -> io::Result<Box<dyn BufRead>> {
    Ok(if path.as_os_str().is_empty() || path.as_os_str() == "-" {
        Box::new(io::stdin().lock())
    } else {
        Box::new(BufReader::new(File::open(path)?))
    })
}

/// The next line without its end (and, at the beginning, without a byte order mark); `None` at the end;
/// an inner error for a line that is too long or no UTF-8.
fn next_line(input: &mut dyn BufRead, first: bool) -> io::Result<Option<Result<String, String>>> {
    let mut bytes = Vec::new();
    if (&mut *input).take(MAX_LINE).read_until(b'\n', &mut bytes)? == 0 {
        return Ok(None);
    }
    if bytes.last() != Some(&b'\n') && bytes.len() as u64 == MAX_LINE {
        while !matches!(bytes.last(), Some(&b'\n')) {
            bytes.clear();
            if (&mut *input).take(MAX_LINE).read_until(b'\n', &mut bytes)? == 0 {
                break;
            }
        }
        return Ok(Some(Err(format!("the line is longer than {} MB", MAX_LINE >> 20))));
    }
    Ok(Some(match String::from_utf8(bytes) {
        Ok(text) => {
            let text = text.trim_end_matches(['\n', '\r']);
            let text = if first { text.trim_start_matches('\u{feff}') } else { text };
            Ok(text.to_owned())
        }
        Err(_) => Err("the line is not UTF-8".into()),
    }))
}
