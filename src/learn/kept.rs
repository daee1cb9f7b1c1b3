//! What training keeps of each command from one visit to the next: how it is heard, the entries that its words may have,
//! and the forest of its goals, as long as the lexicon says the same of it. What is read so is what would be read anew.

use crate::ccg::absorb::{Leniency, absorbed, absorbing};
use crate::ccg::antecedent;
use crate::ccg::chart::{Chart, ChartConfig, Derivations, Lexical};
use crate::ccg::goals::Goals;
use crate::ccg::hearing::taken;
use crate::ccg::parse::fill_knowing;
use crate::ccg::{EntryId, Feature, Forest, Hearing, Model, Vector};
use crate::logic::TermId;
use std::rc::Rc;

/// Edges and derivations that all forests together may have: some 100 MB. What does not fit is read anew each time.
const MOST: usize = 3_000_000;
/// Derivations that are tried without a beam for the sake of a forest.
const LARGEST: usize = 120_000;

/// The goals that a command can mean, ranked, with their features; whether its chart is not whole.
pub(super) type Read = (Vec<(TermId, Rc<Vector>)>, bool);

/// What is kept of all commands of a run.
#[derive(Default)]
pub(super) struct Kept {
    commands: Vec<Option<Command>>,
    /// Edges and derivations of all forests.
    size: usize,
    goals: Goals,
}

/// What is kept of a command.
struct Command {
    /// The entries of the lexicon when the command was heard: with more it may be heard otherwise.
    entries: usize,
    heard: Heard,
    forest: Option<Forest>,
    /// Whether it is too large for a forest.
    is_large: bool,
}

/// What the lexicon says of a command.
struct Heard {
    hearing: Hearing,
    /// Entries over their own words.
    items: Vec<Lexical>,
    /// What it adds to the score of each that its words are taken for others: no matter of training.
    taken: Vec<f64>,
    /// For every word that may go without meaning what that is scored by.
    absorbed: Vec<Option<Vec<Feature>>>,
}

impl Kept {
    /// For so many commands.
    pub(super) fn new(commands: usize) -> Self {
        Kept { commands: (0..commands).map(|_| None).collect(), ..Kept::default() }
    }

    /// Reads the command of a place with the model as it stands.
    pub(super) fn read(
        &mut self,
        at: usize,
        model: &mut Model,
        words: &[String],
        config: ChartConfig,
    ) -> Read {
        let mut command = self.heard(at, model, words);
        let lexical = command.heard.lexical(model);
        let Hearing { words, empty, .. } = &command.heard.hearing;
        if command.forest.is_none() && !command.is_large {
            command.forest = self.grow(model, words.len(), &lexical, config);
            command.is_large = command.forest.is_none();
        }
        if let Some(forest) = &mut command.forest {
            forest.rescore(&model.grammar, &model.features, &lexical);
            let readings = forest.vectors(model, &mut self.goals, words, empty);
            self.commands[at] = Some(command);
            return (readings, false);
        }
        let parse = fill_knowing(model, &mut self.goals, words, lexical, |_, _, _| true, config);
        let mut readings = Vec::with_capacity(parse.readings.len());
        for &reading in &parse.readings {
            let derivation = parse.derivation(reading);
            let root = self.goals.get(&mut model.grammar, reading.form).features.clone();
            let occurring = derivation.features_besides(model, root, words, empty);
            readings.push((reading.form, Rc::new(model.features.vector(&occurring))));
        }
        let over_budget = parse.over_budget();
        self.commands[at] = Some(command);
        (readings, over_budget)
    }

    /// The forest of a command; `None` if that would be too large.
    fn grow(
        &mut self,
        model: &mut Model,
        words: usize,
        lexical: &[Lexical],
        config: ChartConfig,
    ) -> Option<Forest> {
        let budget = config.budget.min(LARGEST);
        let derivations = Derivations::Whole;
        let whole = ChartConfig { beam: usize::MAX, budget, derivations, ..config };
        let Model { grammar, features, .. } = model;
        let chart = Chart::fill(grammar, features, words, lexical.to_vec(), |_, _, _| true, whole);
        if !chart.is_whole() {
            return None;
        }
        let forest = Forest::of(grammar, &chart, config.beam);
        let size = self.size + forest.size();
        if size > MOST {
            return None;
        }
        self.size = size;
        Some(forest)
    }

    /// What a command is answered with the model as it stands, if that is known without a chart.
    pub(super) fn answer(&mut self, at: usize, model: &mut Model) -> Option<Option<TermId>> {
        let command = self.commands.get_mut(at)?.as_mut()?;
        let is_current = command.entries == model.lexicon.len() && !command.heard.looks_back();
        let forest = command.forest.as_mut().filter(|_| is_current)?;
        forest.rescore(&model.grammar, &model.features, &command.heard.lexical(model));
        let readings = forest.readings(model, &mut self.goals);
        (!readings.is_empty()).then(|| Forest::answer(&readings))
    }

    /// What is known of goals.
    pub(super) fn goals(&mut self) -> &mut Goals {
        &mut self.goals
    }

    /// What is kept of a command, brought up to date: its forest is gone if the lexicon says something else of it now.
    fn heard(&mut self, at: usize, model: &mut Model, words: &[String]) -> Command {
        let entries = model.lexicon.len();
        match self.commands[at].take() {
            Some(command) if command.entries == entries && !command.heard.looks_back() => command,
            Some(command) if command.heard.stays(model, command.entries, words) => {
                Command { entries, ..command }
            }
            known => {
                let heard = Heard::new(model, words);
                match known {
                    Some(known) if known.heard.is_like(&heard) => {
                        Command { entries, heard, ..known }
                    }
                    known => {
                        self.size -= known.and_then(|known| known.forest).map_or(0, |f| f.size());
                        Command { entries, heard, forest: None, is_large: false }
                    }
                }
            }
        }
    }
}

impl Heard {
    fn new(model: &mut Model, words: &[String]) -> Self {
        let hearing = Hearing::new(model, words);
        let items = antecedent::items(model, &hearing);
        let Hearing { words, empty, .. } = &hearing;
        let taken = |item: &Lexical| {
            let (own, entry) = (&words[item.own.0..item.own.1], EntryId::from_item(item.item));
            taken(model, own, entry).map_or(0.0, |(_, features)| model.value(&features))
        };
        let taken = items.iter().map(taken).collect();
        let absorbed = absorbed(model, words, empty, Leniency::Learned);
        Heard { hearing, items, taken, absorbed }
    }

    /// Whether it is what the model says of these words, as it was when the lexicon had so many entries: there is no word
    /// that it does not know, and none of the entries that came since stands in them.
    fn stays(&self, model: &Model, then: usize, words: &[String]) -> bool {
        let Hearing { words: heard, closed, .. } = &self.hearing;
        let is_sure =
            |(word, closed): (&String, &Option<_>)| closed.is_some() || model.lexicon.knows(word);
        heard == words
            && !self.looks_back()
            && words.iter().zip(closed).all(is_sure)
            && !model.lexicon.says_more(then, words)
    }

    /// Whether a word names again what was named before: what that means hangs on the weights, too.
    fn looks_back(&self) -> bool {
        antecedent::looks_back(&self.hearing.words)
    }

    /// Whether another says the same, whatever it scores.
    fn is_like(&self, other: &Heard) -> bool {
        let is_like = |(a, b): (&Lexical, &Lexical)| Lexical { score: b.score, ..*a } == *b;
        self.hearing.words == other.hearing.words
            && self.hearing.empty == other.hearing.empty
            && self.absorbed == other.absorbed
            && self.taken == other.taken
            && self.items.len() == other.items.len()
            && self.items.iter().zip(&other.items).all(is_like)
    }

    /// What a chart is given, scored as the model stands.
    fn lexical(&self, model: &Model) -> Vec<Lexical> {
        let scored = |(item, taken): (&Lexical, &f64)| {
            let score = model.entry_score(EntryId::from_item(item.item)) + taken;
            Lexical { score, ..*item }
        };
        let items = self.items.iter().zip(&self.taken).map(scored).collect();
        let value = |features: &Option<Vec<Feature>>| features.as_ref().map(|f| model.value(f));
        let costs: Vec<Option<f64>> = self.absorbed.iter().map(value).collect();
        absorbing(items, &costs)
    }
}
