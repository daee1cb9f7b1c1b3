//! What was decided of a sheet's rows as a file of JSON, by which the same rows stand so once more.

use super::change::Verdict;
use super::row::Half;
use super::rows::Sheet;
use crate::corpus::Decision;
use crate::domain::misread;
use crate::learn::fingerprint::fingerprint;
use crate::learn::runs::spans;
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

/// What such a file calls itself.
const FORMAT: &str = "groundling decisions";
/// The version of its form.
const VERSION: u32 = 1;

/// Decisions as a file; rows as spans.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    /// The fingerprint of the rows.
    corpus: String,
    approved: String,
    /// By reason.
    rejected: Vec<(String, String)>,
    held_out: String,
    aside: String,
}

/// What was decided of all rows.
pub fn write(sheet: &Sheet) -> String {
    let rows = 0..sheet.len() as u32;
    let (mut approved, mut rejected): (Vec<u32>, IndexMap<&str, Vec<u32>>) =
        (Vec::new(), IndexMap::new());
    for (row, decision) in rows.zip(sheet.decisions()) {
        match decision {
            Decision::Open => {}
            Decision::Approved => approved.push(row),
            Decision::Rejected(why) => rejected.entry(why).or_default().push(row),
        }
    }
    let in_half = |half: Half| {
        let is_in = |(row, one): (u32, &Half)| (*one == half).then_some(row);
        spans::write(&(0..).zip(sheet.halves()).filter_map(is_in).collect::<Vec<u32>>())
    };
    let file = File {
        format: FORMAT.to_owned(),
        version: VERSION,
        corpus: fingerprint(sheet.examples()),
        approved: spans::write(&approved),
        rejected: rejected
            .iter()
            .map(|(why, rows)| ((*why).to_owned(), spans::write(rows)))
            .collect(),
        held_out: in_half(Half::HeldOut),
        aside: in_half(Half::Aside),
    };
    // Strings alone: JSON can hold them all.
    serde_json::to_string(&file).unwrap_or_default()
}

/// Decides of all rows what a file says, which can be undone like any change.
///
/// # Errors
/// In words: it is no such file, or is of other rows.
pub fn take(sheet: &mut Sheet, text: &str) -> Result<(), String> {
    let file: File = misread::read(text)?;
    if file.format != FORMAT || file.version != VERSION {
        return Err(format!("it is no file of {FORMAT:?}, version {VERSION}"));
    }
    if file.corpus != fingerprint(sheet.examples()) {
        return Err("they are of other rows".to_owned());
    }
    let rows = |text: &str| {
        spans::read(text, sheet.len() as u32)
            .ok_or_else(|| format!("{text:?} are no rows of these"))
    };
    let mut verdicts = vec![(Verdict::Approve, rows(&file.approved)?)];
    for (why, text) in &file.rejected {
        verdicts.push((Verdict::Reject(why.clone()), rows(text)?));
    }
    let mut is_open = vec![true; sheet.len()];
    let decided = verdicts.iter().flat_map(|(_, rows)| rows);
    decided.for_each(|&row| is_open[row as usize] = false);
    let open = (0..).zip(is_open).filter_map(|(row, is_open)| is_open.then_some(row));
    verdicts.push((Verdict::Reopen, open.collect()));
    let mut halves = vec![Half::Train; sheet.len()];
    for (half, text) in [(Half::HeldOut, &file.held_out), (Half::Aside, &file.aside)] {
        rows(text)?.into_iter().for_each(|row| halves[row as usize] = half);
    }
    for (verdict, rows) in verdicts {
        sheet.decide(&rows, &verdict);
    }
    sheet.divide(&halves);
    Ok(())
}
