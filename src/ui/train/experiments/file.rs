//! An experiment as a file of JSON, as it is kept: with it a result is seen, saved and repeated on another day. As long as
//! its runs are at work there is the plan alone, by which it is told that what they had found is lost.

use super::state::{About, Found};
use crate::domain::misread;
use crate::worker::protocol::Joined;
use serde::{Deserialize, Serialize};

/// What such a file calls itself.
const FORMAT: &str = "groundling experiment";
/// The version of its form.
const VERSION: u32 = 1;

/// What it begins with.
const HEAD: &[u8] = b"{\"format\":\"groundling experiment\"";

/// Whether bytes are such a file.
pub fn is_result(bytes: &[u8]) -> bool {
    bytes.starts_with(HEAD)
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    plan: String,
    /// Nothing as long as the runs are at work.
    joined: Option<Joined>,
}

/// A plan, with what its runs found once they have, as a file.
pub fn write(plan: &str, joined: Option<&Joined>) -> String {
    let (plan, joined) = (plan.to_owned(), joined.cloned());
    let file = File { format: FORMAT.to_owned(), version: VERSION, plan, joined };
    // It has no maps, and its numbers are finite.
    serde_json::to_string(&file).unwrap_or_default()
}

/// What a file says was found, kept under a name; of runs that were at work what the plan is called.
///
/// # Errors
/// In words, what is wrong with it.
pub fn read(name: &str, text: &str) -> Result<Result<Found, String>, String> {
    let File { format, version, plan, joined } = misread::read(text)?;
    if format != FORMAT || version != VERSION {
        return Err(format!("it is no file of {FORMAT:?}, version {VERSION}"));
    }
    Ok(match joined {
        Some(joined) => Ok(Found { name: name.to_owned(), ..Found::new(plan, joined) }),
        None => Err(About::of(&plan).name),
    })
}
