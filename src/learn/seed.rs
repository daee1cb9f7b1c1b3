//! What learning starts from: the ontology of Cleanup World and a seed lexicon.

use crate::ccg::Model;
use crate::ccg::lexicon_text::{LexiconError, read_lexicon};
use crate::ground::ONTOLOGY;
use crate::logic::Signature;

/// The seed lexicon of the paper's demonstration with six sentences.
pub const DEMONSTRATION_LEXICON: &str = include_str!("../../assets/lexicon/demonstration.txt");

/// A model that knows the seed lexicon and nothing else.
///
/// # Errors
/// With the line of the lexicon that is wrong.
pub fn seed_model(lexicon: &str) -> Result<Model, LexiconError> {
    let signature = Signature::read(ONTOLOGY)
        .map_err(|e| LexiconError { line: e.line, reason: format!("ontology: {}", e.reason) })?;
    let mut model = Model::default();
    model.set_signature(signature);
    read_lexicon(&mut model, lexicon)?;
    Ok(model)
}

/// The seed lexicon of the whole domain: what an English speaker brings to any command.
pub const CLEANUP_LEXICON: &str = concat!(
    include_str!("../../assets/lexicon/cleanup.txt"),
    "\n",
    include_str!("../../assets/lexicon/time.txt")
);
