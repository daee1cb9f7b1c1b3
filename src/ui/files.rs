//! Files that a person gives the page: what they are, and which are refused before they are read.

/// The largest file that is read: 64 MiB.
pub const MAX_BYTES: f64 = 67_108_864.0;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A corpus: batch-results CSV or JSON lines.
    Corpus,
    /// A model.
    Model,
}

/// Refuses a file by its size in bytes.
///
/// # Errors
/// Words for the person when it is empty or too large.
pub fn admit(name: &str, bytes: f64) -> Result<(), String> {
    if bytes <= 0.0 {
        return Err(format!(
            "{name} is empty. Choose a file with a header line and at least one row."
        ));
    }
    if bytes > MAX_BYTES {
        return Err(format!("{name} is larger than 64 MB. Split it and open one part at a time."));
    }
    Ok(())
}

/// What a file is: a model says so in its first line, anything else is taken for a corpus.
pub fn kind(name: &str, text: &str) -> Kind {
    let first = text.trim_start_matches('\u{feff}').lines().next().unwrap_or_default();
    let named = name.rsplit_once('.').is_some_and(|(_, end)| end.eq_ignore_ascii_case("model"));
    if named || first.starts_with("groundling") { Kind::Model } else { Kind::Corpus }
}

/// A file's bytes as text.
///
/// # Errors
/// Words for the person when they are not UTF-8.
pub fn decode(name: &str, bytes: Vec<u8>) -> Result<String, String> {
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes().iter().take(at).filter(|b| **b == b'\n').count();
        format!(
            "{name} is not text in UTF-8 (first seen in line {line}). Save it again as UTF-8, \
             or choose the CSV file itself, not a spreadsheet or an archive."
        )
    })
}
