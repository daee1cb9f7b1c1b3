//! `experiment cross`: cross-validation, by distinct command (harder than the paper's own split, whose test
//! commands mostly stand verbatim in its training set), by row, by task, or by any key of the rows.

use super::options::{Common, Given, missing};
use super::table;
use crate::command::Failure;
use crate::figures::{report_json, report_text};
use crate::parallel::run_all;
use groundling::learn::experiment::{By, cross_by};
use groundling::learn::{CLEANUP_LEXICON, Report};
use serde_json::json;

pub(super) fn run(arguments: lexopt::Parser) -> Result<String, Failure> {
    let mut given = Given(arguments);
    let mut common = Common::new();
    let (mut corpus, mut n_folds, mut by) = (Vec::new(), 5u32, "command".to_owned());
    let mut only: Vec<u32> = Vec::new();
    while let Some(name) = given.next()? {
        match name.as_str() {
            "corpus" => corpus.extend(given.files()?),
            "folds" => n_folds = given.value()?,
            "by" => by = given.value()?,
            "fold" => only.extend(given.values::<u32>()?),
            _ => common.take(&name, &mut given)?,
        }
    }
    if corpus.is_empty() {
        return Err(missing("--corpus FILE"));
    }
    let (rows, keys) = match By::ALL.iter().find(|(known, _)| *known == by) {
        Some((_, kind)) => {
            let rows = common.rows(&corpus)?;
            let keys = kind.keys(&rows);
            (rows, keys)
        }
        None => common.keyed(&corpus, &by)?,
    };
    if n_folds < 2 || n_folds as usize > rows.len() {
        let all = rows.len();
        return Err(Failure::Usage(format!("--folds must be from 2 to the corpus' {all} rows")));
    }
    if let Some(fold) = only.iter().find(|fold| !(1..=n_folds).contains(*fold)) {
        return Err(Failure::Usage(format!("--fold {fold}: folds are from 1 to {n_folds}")));
    }
    let mut number = 0;
    let mut runs = cross_by(&rows, n_folds, &keys, &common.config);
    runs.retain(|_| {
        number += 1;
        only.is_empty() || only.contains(&number)
    });
    let finished = run_all(&runs, &common.seed(CLEANUP_LEXICON)?, common.jobs);
    let mut all = Report::default();
    finished.iter().for_each(|run| all.add(run.outcome.report.clone()));
    Ok(if common.json {
        common.report(json!({
            "experiment": "cross", "by": by, "folds": n_folds,
            "runs": table::json(&finished), "all": report_json(&all),
        }))
    } else {
        format!("{}\n\nall folds: {}", table::text(&finished), report_text(&all))
    })
}
