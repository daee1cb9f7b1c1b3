//! What a parse shows of how far its answer can be trusted, and the probability that the model's map makes of that.

use super::derivation::Derivation;
use super::doubt::Signs;
use super::features::{Feature, root_features};
use super::hearing::taken;
use super::lexicon::Origin;
use super::model::Model;
use super::parse::Parse;

/// The probability that a parse's one answer is what was meant, and whether to ask before it is done; `None` without an
/// answer, and where the model has no map for it.
pub fn probability(model: &Model, parse: &Parse) -> Option<(f64, bool)> {
    parse.answer()?;
    let doubt = model.doubt.as_ref()?;
    let probability = doubt.probability(&signs(model, parse)?);
    let asks = doubt.asks(probability) || parse.is_forced || lacks_verb(model, parse);
    Some((probability, asks))
}

/// Whether words were skipped, and no word that is left says what to do: one of those may have been the verb, and could
/// have said the opposite ("flee the red room").
fn lacks_verb(model: &Model, parse: &Parse) -> bool {
    let Some(&best) = parse.readings.first().filter(|_| !parse.skipped.is_empty()) else {
        return false;
    };
    let is_verb = |leaf: &&Derivation| match **leaf {
        Derivation::Leaf { entry, .. } => {
            let syntax = model.lexicon.category(entry).syntax;
            model.grammar.syntaxes.sets_goal(syntax)
        }
        _ => false,
    };
    !parse.derivation(best).leaves().iter().any(is_verb)
}

/// The signs of a parse's best reading; `None` without one.
pub fn signs(model: &Model, parse: &Parse) -> Option<Signs> {
    let best = *parse.readings.first()?;
    let derivation = parse.derivation(best);
    let words = &parse.hearing.words;
    let n_words = words.len().max(1) as f64;
    let behind = |at: usize| parse.readings.get(at).map(|reading| best.score - reading.score);
    let rivals = parse.readings.iter().skip(1).filter(|other| best.score - other.score < 3.0);
    let known = |word: &&String| model.lexicon.has_content(word);
    let mut far = 0.0;
    let (mut learned, mut leaves, mut weakest) = (0.0, 0.0, 10.0_f64);
    for leaf in derivation.leaves() {
        let Derivation::Leaf { own: (start, end), entry, .. } = *leaf else { continue };
        leaves += 1.0;
        let taken = taken(model, &words[start..end], entry);
        far += taken.as_ref().map_or(0.0, |(_, features)| features.len() as f64);
        learned += f64::from(u8::from(model.lexicon.origin(entry) == Origin::Learned));
        if taken.is_none() {
            weakest = weakest.min(model.entry_score(entry));
        }
    }
    let root = root_features(&model.grammar.terms, &model.grammar.sorts, best.form);
    let unseen = root.iter().filter(|&&feature| model.features.weight(feature) == 0.0).count();
    let is_list = derivation.category().syntax.is_several();
    let misspelt = parse.words.iter().zip(words).filter(|(word, heard)| word != heard).count();
    let share = |count: usize, most: usize| count.min(most) as f64 / most as f64;
    let is_silent = |&at: &usize| model.lexicon.has_content(&words[at]);
    let silent = derivation.absorbed().into_iter().filter(is_silent).count();
    let values = [
        ("bias", 1.0),
        ("lead", behind(1).map_or(1.0, |lead| lead.clamp(0.0, 10.0) / 10.0)),
        ("rivals", share(rivals.count(), 5)),
        ("score", (best.score / n_words).clamp(-10.0, 10.0) / 10.0),
        ("skipped", share(parse.skipped.len(), 4)),
        ("skipped known", share(parse.skipped.iter().filter(known).count(), 3)),
        ("silent", share(silent, 3)),
        ("misspelt", share(misspelt, 3)),
        ("far", f64::min(far, 6.0) / 6.0),
        ("learned", learned / f64::max(leaves, 1.0)),
        ("weakest", weakest.clamp(-10.0, 10.0) / 10.0),
        ("length", n_words.min(20.0) / 20.0),
        ("closed", f64::from(u8::from(parse.hearing.closed.iter().any(Option::is_some)))),
        ("unseen", unseen as f64 / root.len().max(1) as f64),
        ("beside", f64::from(u8::from(is_list))),
        ("predicates", share(model.grammar.terms.predicates(best.form) as usize, 12)),
    ];
    let mut signs: Signs = values.map(|(name, value)| (name.to_owned(), value)).into();
    // What it claims of what: each once.
    let claims = root.iter().filter(|feature| matches!(feature, Feature::Head(..)));
    for claim in claims {
        let name = model.feature_text(*claim).replace('\t', " ");
        if signs.iter().all(|(known, _)| *known != name) {
            signs.push((name, 1.0));
        }
    }
    Some(signs)
}
