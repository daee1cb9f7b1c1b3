//! `evaluate`: a model's precision, recall and F1 on a corpus.

use super::arguments::Arguments;
use super::command::{Command, Done, print};
use super::corpora::{Admit, Loaded, examples, speaker};
use super::failure::Failure;
use super::figures::{report_json, report_text};
use groundling::ccg::ChartConfig;
use groundling::learn::Evaluation;
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Instant;

pub(crate) const COMMAND: Command = Command {
    name: "evaluate",
    about: "Score a model on commands with states before and after",
    usage: "--model MODEL --corpus FILE… [--with-rejected] [--json]",
    details: "  --model MODEL       a model file\n\
              \x20 --corpus FILE…      batch-results CSV or JSON, found out by what is in it; all are judged together\n\
              \x20 --with-rejected     use rejected rows too\n\
              \x20 --json              print one JSON object: total, answered, correct, precision, recall, f1;\n\
              \x20                     the same after skipping_ (words skipped) and resolved_ (ties broken by\n\
              \x20                     which form refers); intervals (95 %), tasks, confusion, seconds; rows, rejected and\n\
              \x20                     left_out, which became of the rows of the files; and of the\n\
              \x20                     answers that say how likely they are right (words skipped): asked,\n\
              \x20                     unasked_precision, ece (expected calibration error, ten bins), reliability\n\
              \x20                     (the bins), risk_coverage",
    run,
};

/// Said of a model that was learned without a map of doubt, or before there was one.
const NO_DOUBT: &str = "the model does not say how likely its answers are, so none is asked about (`calibrate` learns that, \
    and `train --doubt MAP` puts it into a model)";

fn run(mut arguments: Arguments) -> Result<Done, Failure> {
    use lexopt::Arg::{Long, Value};
    let (mut model_file, mut corpus) = (None::<PathBuf>, Vec::<PathBuf>::new());
    let mut in_corpus = false;
    let (mut with_rejected, mut as_json) = (false, false);
    while let Some(argument) = arguments.next()? {
        let was_in_corpus = std::mem::take(&mut in_corpus);
        match argument {
            Long("model") => model_file = Some(arguments.file()?),
            Long("corpus") => {
                corpus.push(arguments.one_more()?.into());
                in_corpus = true;
            }
            Value(file) if was_in_corpus => {
                corpus.push(file.into());
                in_corpus = true;
            }
            Long("with-rejected") => with_rejected = true,
            Long("json") => as_json = true,
            other => return Err(other.unexpected().into()),
        }
    }
    let missing = |name: &str| Failure::Usage(format!("{name} is missing"));
    let mut model = speaker(&model_file.ok_or_else(|| missing("--model MODEL"))?)?;
    if corpus.is_empty() {
        return Err(missing("--corpus FILE"));
    }
    let Loaded { examples, rows, .. } = examples(&corpus, Admit::with_rejected(with_rejected))?;
    if model.doubt.is_none() {
        // Standard error may be gone; the figures are still right.
        let _ = writeln!(io::stderr(), "{NO_DOUBT}");
    }
    let started = Instant::now();
    let config = ChartConfig::of(&model);
    let mut evaluation = Evaluation::new(&mut model, &examples, config);
    while evaluation.step().is_some() {}
    let report = evaluation.into_report();
    let text = if as_json {
        let mut object = report_json(&report);
        rows.put(&mut object);
        object["seconds"] = started.elapsed().as_secs_f64().into();
        object.to_string()
    } else {
        format!("{rows}\n{}", report_text(&report))
    };
    print(&text)
}
