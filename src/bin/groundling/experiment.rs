//! `experiment`: the paper's tables and demonstration, and cross-validation. One file an experiment beside this.

#[path = "experiment/cross.rs"]
mod cross;
#[path = "experiment/options.rs"]
mod options;
#[path = "experiment/table.rs"]
mod table;

use super::command::{Command, Done, Failure};
use lexopt::ValueExt;

pub(crate) const COMMAND: Command = Command {
    name: "experiment",
    about: "Repeat an experiment: learn, judge, and hold the figures beside the paper's",
    usage: "cross [OPTIONS]",
    details: "  cross --corpus FILE…   cross-validation\n\
              \x20   --folds N            parts of the corpus (5)\n\
              \x20   --by KIND            what stays together: command, row or task (command)\n\
              \x20   --fold K…            only these folds, from 1\n\
              \n\
              All experiments:\n\
              \x20 --demonstrations N     learn from the first N pairs of each row (all)\n\
              \x20 --epochs N             passes over the corpus (15)\n\
              \x20 --seed N               order of the examples, and of the folds (0)\n\
              \x20 --lexicon FILE         the seed lexicon (the whole domain's)\n\
              \x20 --with-rejected        use rejected rows too\n\
              \x20 --jobs N               runs at a time (as many as there are processors)\n\
              \x20 --json                 print one JSON object",
    run,
};

/// What does an experiment on what follows its name; its result as text.
type Experiment = fn(lexopt::Parser) -> Result<String, Failure>;

/// Every experiment.
const EXPERIMENTS: [(&str, Experiment); 1] = [("cross", cross::run)];

fn run(mut arguments: lexopt::Parser) -> Result<Done, Failure> {
    let names = EXPERIMENTS.map(|(name, _)| name).join(", ");
    let Some(lexopt::Arg::Value(name)) = arguments.next()? else {
        return Err(Failure::Usage(format!("no experiment given: use one of {names}")));
    };
    let name = name.string()?;
    let Some((_, run)) = EXPERIMENTS.iter().find(|(known, _)| *known == name) else {
        return Err(Failure::Usage(format!("no experiment `{name}`: use one of {names}")));
    };
    super::command::print(&run(arguments)?)
}
