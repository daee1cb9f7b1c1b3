//! Words that mean nothing here, such as "please": their neighbour absorbs them. Which they are is learned like any
//! meaning, by entries of category EMPTY (after the skipping entries of Artzi and Zettlemoyer's SPF); skipping a word
//! that no entry calls empty is the same at a price. There is one way to absorb a word, so readings do not multiply.
//! A closed word never goes without meaning.

use super::chart::Lexical;
use super::closed::closed;
use super::features::Feature;
use super::lexicon::EntryId;
use super::model::Model;

/// Which words may go without meaning.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Leniency {
    /// Those with an entry that says they are empty.
    Learned,
    /// Those and the words that the lexicon does not know.
    Unknown,
    /// Any but closed ones.
    Any,
}

/// For every word the entry by which it means nothing, if the lexicon has one and the word is not closed.
pub fn empty_entries(model: &Model, words: &[String]) -> Vec<Option<EntryId>> {
    let empty = |(word, closed): (&String, Option<_>)| {
        let entries = model.lexicon.entries_for_word(word);
        let is_empty = |&entry: &EntryId| model.lexicon.is_empty_entry(entry);
        entries.iter().copied().find(is_empty).filter(|_| closed.is_none())
    };
    words.iter().zip(closed(words)).map(empty).collect()
}

/// What it adds to a score to leave each word without meaning, by the entry given for that if there is one; `None`
/// where that may not be.
pub fn absorption(
    model: &Model,
    words: &[String],
    empty: &[Option<EntryId>],
    leniency: Leniency,
) -> Vec<Option<f64>> {
    let costs = absorbed(model, words, empty, leniency).into_iter();
    costs.map(|features| features.map(|features| model.value(&features))).collect()
}

/// By what it is scored to leave each word without meaning; `None` where that may not be.
pub fn absorbed(
    model: &Model,
    words: &[String],
    empty: &[Option<EntryId>],
    leniency: Leniency,
) -> Vec<Option<Vec<Feature>>> {
    let features = |((word, &empty), closed): ((&String, &Option<EntryId>), Option<_>)| {
        let may = match leniency {
            _ if closed.is_some() => false,
            Leniency::Any => true,
            Leniency::Unknown => empty.is_some() || !model.lexicon.knows(word),
            Leniency::Learned => empty.is_some(),
        };
        may.then(|| model.absorption_features(word, empty))
    };
    words.iter().zip(empty).zip(closed(words)).map(features).collect()
}

/// The items, each also over the empty words to its right; those at the beginning of the sentence are absorbed by
/// the item that follows. So there is one way to absorb a word.
pub fn absorbing(items: Vec<Lexical>, costs: &[Option<f64>]) -> Vec<Lexical> {
    // What it adds to leave all words before a place without meaning.
    let mut leading = vec![Some(0.0)];
    let mut sum = Some(0.0);
    leading.extend(costs.iter().map(|cost| {
        sum = sum.zip(*cost).map(|(sum, cost)| sum + cost);
        sum
    }));
    let mut all = Vec::with_capacity(items.len());
    for item in items {
        let mut starts = vec![(item.start, 0.0)];
        starts.extend(leading[item.start].filter(|_| item.start > 0).map(|cost| (0, cost)));
        for (start, before) in starts {
            let mut score = item.score + before;
            all.push(Lexical { start, score, ..item });
            for (end, cost) in (item.end + 1..).zip(&costs[item.end..]) {
                let Some(cost) = cost else { break };
                score += cost;
                all.push(Lexical { start, end, score, ..item });
            }
        }
    }
    all
}
