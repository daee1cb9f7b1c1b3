//! `experiment table2`: F1 on held-out commands, by training set and by number of demonstrations.

use super::options::{Common, missing};
use super::table;
use crate::arguments::Arguments;
use crate::failure::Failure;
use crate::parallel::run_all;
use groundling::learn::experiment::{Selection, table_2};
use groundling::learn::{CLEANUP_LEXICON, paper};
use serde_json::json;
use std::path::PathBuf;

pub(super) fn run(mut given: Arguments) -> Result<String, Failure> {
    let mut common = Common::new();
    let mut sets = Vec::new();
    while let Some(name) = given.option()? {
        match name.as_str() {
            "set" => {
                for text in given.texts()? {
                    sets.push(set(&text)?);
                }
            }
            "demonstrations" => {
                let why = "--demonstrations: the table has 3, 2 and 1 of its own";
                return Err(Failure::Usage(why.into()));
            }
            _ => common.take(&name, &mut given)?,
        }
    }
    if sets.is_empty() {
        return Err(missing("--set NAME=TRAIN,TEST"));
    }
    let mut runs = Vec::new();
    for (name, train, test) in sets {
        let train = Selection::all(&common.rows(&[train])?);
        let test = Selection::all(&common.rows(&[test])?);
        runs.extend(table_2(&name, &train, &test, &common.config));
    }
    let finished = run_all(&runs, &common.seed(CLEANUP_LEXICON)?, common.jobs);
    Ok(if common.json {
        let runs = table::json(&finished);
        common.report(json!({ "experiment": "table2", "source": paper::SOURCE, "runs": runs }))
    } else {
        let table = table::text(&finished);
        common.told(&format!("F1 by training set and demonstrations ({})\n{table}", paper::SOURCE))
    })
}

/// `NAME=TRAIN,TEST`.
fn set(text: &str) -> Result<(String, PathBuf, PathBuf), Failure> {
    let parts = text.split_once('=').and_then(|(name, files)| {
        let (train, test) = files.split_once(',')?;
        let all_there = [name, train, test].iter().all(|part| !part.is_empty());
        all_there.then(|| (name.to_owned(), PathBuf::from(train), PathBuf::from(test)))
    });
    parts.ok_or_else(|| Failure::Usage(format!("--set `{text}`: write NAME=TRAIN,TEST")))
}
