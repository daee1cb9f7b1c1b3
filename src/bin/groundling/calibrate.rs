//! `calibrate`: learns from a model's answers how far they can be trusted.

use super::arguments::Arguments;
use super::command::{Command, Done};
use super::corpora::{Admit, Rows, examples, speaker};
use super::failure::Failure;
use super::output::outputs;
use groundling::learn::calibrate::{calibrate, marks};
use std::io::{self, Write};
use std::path::PathBuf;

pub(crate) const COMMAND: Command = Command {
    name: "calibrate",
    about: "Learn how far a model's answers can be trusted",
    usage: "--model MODEL --corpus FILE… [--model MODEL --corpus FILE…] [--precision 0.9] --out MAP",
    details: "  --model MODEL       a model file, for the corpora behind it\n\
              \x20 --corpus FILE…      commands that it has not learned from; each file counts alike\n\
              \x20 --precision P       ask below the probability from which on this share of every file is right\n\
              \x20 --out MAP           the map, which `train --doubt MAP` puts into a model",
    run,
};

fn run(mut arguments: Arguments) -> Result<Done, Failure> {
    use lexopt::Arg::{Long, Value};
    let (mut model, mut out, mut corpora) = (None, None::<PathBuf>, Vec::new());
    let mut precision = 0.9;
    let mut in_corpora = false;
    while let Some(argument) = arguments.next()? {
        let was_in_corpora = std::mem::replace(&mut in_corpora, true);
        match argument {
            Long("corpus") => corpora.push((model.clone(), PathBuf::from(arguments.one_more()?))),
            Value(file) if was_in_corpora => corpora.push((model.clone(), file.into())),
            other => {
                in_corpora = false;
                match other {
                    Long("model") => model = Some(PathBuf::from(arguments.one_more()?)),
                    Long("out") => out = Some(arguments.file()?),
                    Long("precision") => precision = arguments.number(0.0..=1.0)?,
                    other => return Err(other.unexpected().into()),
                }
            }
        }
    }
    let missing = |name: &str| Failure::Usage(format!("{name} is missing"));
    if corpora.is_empty() {
        return Err(missing("--corpus FILE"));
    }
    let inputs = corpora.iter().flat_map(|(model, corpus)| model.iter().chain([corpus]));
    let [out] = outputs([("--out", out.as_deref())], inputs)?;
    let out = out.ok_or_else(|| missing("--out MAP"))?;
    let (mut all, mut rows) = (Vec::with_capacity(corpora.len()), Rows::default());
    for (model, corpus) in corpora {
        let mut model = speaker(&model.ok_or_else(|| missing("--model MODEL"))?)?;
        let loaded = examples(&[corpus], Admit::Never)?;
        rows.add(loaded.rows);
        all.push(marks(&mut model, &loaded.examples));
    }
    let lines = calibrate(&all, precision).lines();
    out.write(&(lines.join("\n") + "\n"))?;
    // Standard error may be gone; the map is written.
    let _ = writeln!(io::stderr(), "{rows}");
    Ok(Done::Well)
}
