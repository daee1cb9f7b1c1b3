//! `experiment`: the paper's tables and demonstration, and cross-validation. One file an experiment beside this.

#[path = "experiment/cross.rs"]
mod cross;
#[path = "experiment/demonstration.rs"]
mod demonstration;
#[path = "experiment/options.rs"]
mod options;
#[path = "experiment/runs.rs"]
mod runs;
#[path = "experiment/table.rs"]
mod table;
#[path = "experiment/table2.rs"]
mod table2;
#[path = "experiment/table3.rs"]
mod table3;

use super::arguments::Arguments;
use super::command::{Command, Done, print};
use super::failure::Failure;
use lexopt::ValueExt;

pub(crate) const COMMAND: Command = Command {
    name: "experiment",
    about: "Repeat an experiment: learn, judge, and hold the figures beside the paper's",
    usage: "NAME [OPTIONS]",
    details: "  table2         the paper's Table II: F1 by training set and by 3, 2 or 1 demonstrations\n\
              \x20   --set NAME=TRAIN,TEST…  sets (the paper's: raw, pruned)\n\
              \x20 table3         the paper's Table III: learning with a planner of horizon 1, 10, 20, and without\n\
              \x20   --train FILE… --test FILE…\n\
              \x20   --budget STATES         the most that a run's planner may expand (2,000,000,000)\n\
              \x20   --without-memo          time the planners without memo, too\n\
              \x20 demonstration  Section VII: six sentences, then one never heard\n\
              \x20   --corpus FILE…          the sentences (the six)\n\
              \x20   --command TEXT          the one never heard (go to the blue room)\n\
              \x20   --world FILE            the world it is said in (three rooms)\n\
              \x20 cross          cross-validation\n\
              \x20   --corpus FILE…\n\
              \x20   --folds N               parts of the corpus (5)\n\
              \x20   --by KIND               what stays together: command, row, task, worker,\n\
              \x20                           or the rows with the same value of a key (command)\n\
              \x20   --fold K…               only these folds, from 1\n\
              \x20   --leave N               draws instead of folds: each leaves the rows of N values of the key out\n\
              \x20   --draws N               so many (10)\n\
              \x20   --keep KEY              no value of this other key of the rows is left out whole\n\
              \x20 plan           a file of JSON that repeats runs exactly\n\
              \x20   --corpus FILE… [--held-out FILE…]\n\
              \x20   --matrix JSON           which runs (\"once\"), such as {\"curve\": {\"percents\": [25, 100], \"by\": \"row\"}}\n\
              \x20 run            all runs of a plan\n\
              \x20   --plan FILE --corpus FILE…   the plan, and its files in their order\n\
              \x20   --csv                   a table for other programs\n\
              \x20 shard          some runs of a plan, for machines that share it out; its results as JSON\n\
              \x20   --plan FILE --corpus FILE… --run K…   numbers of runs, from 0\n\
              \x20 join           what all shards of a plan found\n\
              \x20   --plan FILE --shard FILE… [--csv]\n\
              All:\n\
              \x20   --demonstrations N      learn from the first N pairs of each row (all; not table2)\n\
              \x20   --epochs N              passes over the corpus (15)\n\
              \x20   --seed N                order of the examples, and of the folds (0)\n\
              \x20   --lexicon FILE          the seed lexicon (the whole domain's; demonstration: its own)\n\
              \x20   --without-contrasts     learn from what was done alone\n\
              \x20   --with-rejected         use rejected rows too\n\
              \x20   --jobs N                runs at a time (as many as there are processors; table3: 1)\n\
              \x20   --json                  print one JSON object",
    run,
};

/// What does an experiment on what follows its name; its result as text.
type Experiment = fn(Arguments) -> Result<String, Failure>;

/// Every experiment.
const EXPERIMENTS: [(&str, Experiment); 8] = [
    ("table2", table2::run),
    ("table3", table3::run),
    ("demonstration", demonstration::run),
    ("cross", cross::run),
    ("plan", runs::plan),
    ("run", runs::run),
    ("shard", runs::shard),
    ("join", runs::join),
];

fn run(mut arguments: Arguments) -> Result<Done, Failure> {
    let names = EXPERIMENTS.map(|(name, _)| name).join(", ");
    let Some(lexopt::Arg::Value(name)) = arguments.next()? else {
        return Err(Failure::Usage(format!("no experiment given: use one of {names}")));
    };
    let name = name.string()?;
    let Some((_, run)) = EXPERIMENTS.iter().find(|(known, _)| *known == name) else {
        return Err(Failure::Usage(format!("no experiment `{name}`: use one of {names}")));
    };
    print(&run(arguments)?)
}
