//! The page's own corpus: six sentences, each with states before and after.

use crate::worker::protocol::{CorpusFile, MappedFile, Mapping};

/// Its name.
pub const NAME: &str = "six.csv";

/// Its text.
pub const TEXT: &str = include_str!("../../../../assets/corpus/six.csv");

/// It as a file.
pub fn file() -> MappedFile {
    let file = CorpusFile { name: NAME.to_owned(), bytes: TEXT.as_bytes().to_vec().into() };
    MappedFile { file, mapping: Mapping::default() }
}
