//! The beginning of a file, for a person who maps its columns: their names, a few rows, and what they seem to be.

use super::admit::not_a_corpus;
use super::flaw::{Flaw, cut};
use super::items::{Item, Items};
use super::jsonl;
use super::mapping::Mapping;
use super::record::{Records, Step};
use super::source::Source;
use serde::{Deserialize, Serialize};
use std::io::Read;

/// Rows that are shown.
const MOST_ROWS: usize = 5;
/// Columns that are shown: a table with more is hardly mapped by hand.
const MOST_COLUMNS: usize = 200;
/// Characters of a cell that are shown.
const MOST_CHARS: usize = 80;
/// Steps of reading before giving up: a megabyte or two of the file.
const PATIENCE: usize = 64;

/// What a file begins with.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Preview {
    /// Whether it is JSON, and the columns are keys.
    pub is_json: bool,
    /// The names of its columns.
    pub columns: Vec<String>,
    /// The beginnings of its first rows' cells, as many as there are columns.
    pub rows: Vec<Vec<String>>,
    /// What the columns seem to be.
    pub proposal: Mapping,
}

/// Looks at the beginning of a file.
///
/// # Errors
/// Why the file is no table and no JSON.
pub fn preview(stream: impl Read) -> Result<Preview, Flaw> {
    let source = Source::new(stream).map_err(|fault| Flaw::of_file(fault.wrong()))?;
    if let Some(wrong) = not_a_corpus(&source.buffer) {
        return Err(Flaw::of_file(wrong));
    }
    let mut found = match source.buffer.trim_ascii_start().first() {
        None => return Err(Flaw::of_file(super::admit::empty())),
        Some(b'{' | b'[') => objects(Items::new(source)),
        Some(_) => table(Records::new(source)),
    };
    found.proposal = Mapping::propose(&found.columns);
    Ok(found)
}

fn table<R: Read>(mut records: Records<R>) -> Preview {
    let mut found = Preview::default();
    for _ in 0..PATIENCE {
        match records.step() {
            Ok(Step::Record(record)) if found.columns.is_empty() => {
                let names = record.cells.iter().take(MOST_COLUMNS);
                found.columns = names.map(|name| name.trim().to_owned()).collect();
            }
            Ok(Step::Record(record)) => {
                let cells = (0..found.columns.len()).map(|at| record.cells.get(at));
                found.rows.push(cells.map(|cell| cut(cell.unwrap_or(""), MOST_CHARS)).collect());
            }
            Ok(Step::Working | Step::Unclosed(..)) => {}
            Ok(Step::Over) | Err(_) => break,
        }
        if found.rows.len() == MOST_ROWS {
            break;
        }
    }
    found
}

fn objects<R: Read>(mut items: Items<R>) -> Preview {
    let mut found = Preview { is_json: true, ..Preview::default() };
    let mut objects: Vec<Vec<(String, String)>> = Vec::new();
    for _ in 0..PATIENCE {
        match items.step() {
            Ok(Item::Text(_, bytes)) => {
                let (text, _) = jsonl::text(&bytes);
                objects.extend(jsonl::fields(&text));
            }
            Ok(Item::Working | Item::Broken(..)) => {}
            Ok(Item::Over) | Err(_) => break,
        }
        if objects.len() == MOST_ROWS {
            break;
        }
    }
    for (key, _) in objects.iter().flatten() {
        if !found.columns.contains(key) && found.columns.len() < MOST_COLUMNS {
            found.columns.push(key.clone());
        }
    }
    let cell = |object: &Vec<(String, String)>, column: &String| {
        let value = object.iter().find(|(key, _)| key == column);
        cut(value.map_or("", |(_, value)| value), MOST_CHARS)
    };
    let row = |object| found.columns.iter().map(|column| cell(object, column)).collect();
    found.rows = objects.iter().map(row).collect();
    found
}
