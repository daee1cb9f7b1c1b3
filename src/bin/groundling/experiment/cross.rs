//! `experiment cross`: cross-validation, by distinct command (harder than the paper's own split, whose test
//! commands mostly stand verbatim in its training set), by row, by task, or by any key of the rows; or draws, each of
//! which leaves some values of that key out.

use super::options::{Common, missing};
use super::table;
use crate::arguments::Arguments;
use crate::failure::Failure;
use crate::figures::{report_json, report_text};
use crate::parallel::{Finished, run_all};
use groundling::learn::experiment::{By, Run, cross_by, left_out};
use groundling::learn::{CLEANUP_LEXICON, Report, Ties};
use serde_json::json;

pub(super) fn run(mut given: Arguments) -> Result<String, Failure> {
    let mut common = Common::new();
    let (mut corpus, mut n_folds, mut by) = (Vec::new(), 5u32, "command".to_owned());
    let mut only: Vec<u32> = Vec::new();
    let (mut leave, mut draws, mut keep) = (None::<usize>, 10u32, None::<String>);
    while let Some(name) = given.option()? {
        match name.as_str() {
            "corpus" => corpus.extend(given.files()?),
            "folds" => n_folds = given.whole()?,
            "by" => by = given.text()?,
            "leave" => leave = Some(given.whole()?),
            "draws" => draws = given.whole()?,
            "keep" => keep = Some(given.text()?),
            "fold" => only.extend(given.wholes::<u32>()?),
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
    if let Some(n) = leave {
        let kinds = keep.map(|kind| common.values(&corpus, &kind)).transpose()?;
        let kinds = kinds.unwrap_or_else(|| vec![String::new(); rows.len()]);
        let runs = left_out(&rows, (&keys, &kinds), (n, draws), &common.config);
        return drawn(&runs, &common, (&by, n));
    }
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
        common.told(&format!("{}\n\nall folds: {}", table::text(&finished), report_text(&all)))
    })
}

/// What came of draws, with the mean of their F1.
fn drawn(runs: &[Run], common: &Common, (by, n): (&str, usize)) -> Result<String, Failure> {
    if runs.is_empty() {
        return Err(Failure::Usage(format!("--leave {n}: no draw leaves something on both sides")));
    }
    let finished = run_all(runs, &common.seed(CLEANUP_LEXICON)?, common.jobs);
    let f1 = |run: &Finished| {
        let scores = run.outcome.report.scores(Ties::Abstain);
        scores.plain.f1(scores.total)
    };
    let mean = finished.iter().map(f1).sum::<f64>() / finished.len() as f64;
    Ok(if common.json {
        common.report(json!({
            "experiment": "cross", "by": by, "leave": n, "runs": table::json(&finished), "mean_f1": mean,
        }))
    } else {
        common.told(&format!("{}\n\nmean F1 of all draws: {mean:.3}", table::text(&finished)))
    })
}
