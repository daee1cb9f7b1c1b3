//! Running the command line as a person or a script does: input in, output out, answers a line each.

use std::io::Write;
use std::process::{Command, Output, Stdio};

/// What the command answers to the input.
pub(crate) fn run(name: &str, input: &str) -> Output {
    call(&[name], input)
}

/// What the command answers to arguments and input.
pub(crate) fn call(arguments: &[&str], input: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_groundling"));
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    output
}

/// The JSON lines of an output.
pub(crate) fn answers(output: &Output) -> Vec<serde_json::Value> {
    let text = std::str::from_utf8(&output.stdout).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}
