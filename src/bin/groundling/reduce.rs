//! `reduce`: a term a line in, its normal form out.

use super::arguments::Arguments;
use super::command::{Blank, Command, Done, answer_lines, only_files};
use super::failure::Failure;
use groundling::logic::{Terms, print, read};

pub(crate) const COMMAND: Command = Command {
    name: "reduce",
    about: "Bring λ-terms into normal form",
    usage: "[FILE…]",
    details: "In:  a term a line, such as ((lambda $0:e (red:<e,t> $0)) ball:e)\n\
              Out: its β-normal, η-long form with conjuncts in order; a bad line is answered by\n\
              \x20    {\"error\", \"line\"} in its place",
    run,
};

fn run(arguments: Arguments) -> Result<Done, Failure> {
    answer_lines(&only_files(arguments)?, Blank::IsAMistake, |line| {
        let mut terms = Terms::new();
        let term = read(&mut terms, line).map_err(|e| e.to_string())?;
        Ok(print(&terms, term))
    })
}
