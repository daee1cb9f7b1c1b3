//! Going on from a finished model with a few new examples: entries are generated where none explains them, then weights
//! move until every new command is answered rightly, and no further. The weights of what is new go first: as long as
//! they are enough, a sentence without the new words scores what it scored before, to the last bit.

use super::config::Config;
use super::gradient::update;
use super::phase::Phase;
use super::trainer::Trainer;
use crate::ccg::{ChartConfig, EntryId, Feature, Features, LexemeId, Model, Origin, Vector, parse};
use crate::corpus::Example;
use crate::ground::Validator;
use crate::logic::TermId;
use indexmap::IndexMap;
use rustc_hash::FxHashSet;
use std::rc::Rc;

/// Passes over the new examples with each [`Reach`].
const PASSES: u32 = 8;
/// By how much a valid reading is to outscore every invalid one.
const LEAD: f64 = 0.2;

/// Which weights may move. Those of the seed never do: one example does not teach that "red" is a place. Nor do those
/// that all sentences share: moving them changed a third of what a model of the whole corpus answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reach {
    /// Those of entries and lexemes that were added.
    New,
    /// Those of all that were ever learned.
    Learned,
}

/// Why a model cannot be taught.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("it is a checkpoint of a run that has not ended; go on with that run first")]
pub struct Unfinished;

/// What came of teaching.
#[derive(Clone, Debug)]
pub struct Taught {
    /// The model that was taught.
    pub model: Model,
    /// The entries that were added, in the order they came into the lexicon.
    pub entries: Vec<EntryId>,
    /// For each example, in order, whether the model's one answer to its command is valid now.
    pub understood: Vec<bool>,
}

/// Teaching at work. Every [`Teaching::step`] does a bounded part of it.
pub struct Teaching {
    trainer: Trainer,
    examples: Vec<Example>,
    /// The facts of the model, which tell of the run that made it.
    facts: IndexMap<String, String>,
    demonstrations: usize,
    /// The entries before, their lexemes, and which of these are the seed's.
    n_entries: usize,
    lexemes: FxHashSet<LexemeId>,
    seed: FxHashSet<LexemeId>,
    /// The weights as they were when more of them came free.
    careful: Option<Features>,
    reach: Reach,
    pass: u32,
    next: usize,
    /// What is done next with the command at work.
    phase: Phase,
    /// Whether every command of this pass was answered rightly so far.
    settled: bool,
    is_done: bool,
}

/// Teaches a finished model a few examples, in the order given; [`Config::of`] the model is a good choice of settings.
/// Epochs, seed and planner mean nothing here.
///
/// # Errors
/// When the model is a checkpoint.
pub fn teach(model: Model, examples: &[Example], config: Config) -> Result<Taught, Unfinished> {
    let mut teaching = Teaching::new(model, examples, config)?;
    while !teaching.is_done() {
        teaching.step();
    }
    Ok(teaching.end())
}

impl Teaching {
    /// Teaching that begins.
    ///
    /// # Errors
    /// When the model is a checkpoint.
    pub fn new(model: Model, examples: &[Example], config: Config) -> Result<Self, Unfinished> {
        if model.facts.contains_key("at_epoch") {
            return Err(Unfinished);
        }
        let entries = model.lexicon.entries();
        let lexeme = |&id: &EntryId| model.lexicon.entry(id).lexeme;
        let is_seed = |id: &&EntryId| model.lexicon.origin(**id) == Origin::Seed;
        let seed = entries.iter().filter(is_seed).map(lexeme).collect();
        let lexemes = entries.iter().map(lexeme).collect();
        Ok(Teaching {
            facts: model.facts.clone(),
            n_entries: entries.len(),
            demonstrations: config.demonstrations.map_or(usize::MAX, |n| n as usize),
            trainer: Trainer::new(model, examples, Config { planning: None, ..config }),
            examples: examples.to_vec(),
            lexemes,
            seed,
            careful: None,
            reach: Reach::New,
            pass: 0,
            next: 0,
            phase: Phase::Explain,
            settled: true,
            is_done: examples.is_empty(),
        })
    }

    /// Whether there is nothing left to do but to look at what came of it.
    pub fn is_done(&self) -> bool {
        self.is_done
    }

    /// Looks at one command: its readings are judged by its examples, and entries generated or weights moved.
    pub fn step(&mut self) {
        if self.is_done {
            return;
        }
        if let Phase::Generate(example, scope) = self.phase {
            self.trainer.generate(self.next, example, scope);
        }
        let (readings, _) = self.trainer.read(self.next);
        let judged = self.trainer.judge(self.next, &readings);
        let may_generate = self.pass == 0 && self.reach == Reach::New;
        if let Some(next) = self.phase.next(&judged).filter(|_| may_generate) {
            self.phase = next;
            return;
        }
        self.phase = Phase::Explain;
        for valid in judged.iter().filter(|valid| valid.contains(&true)) {
            if !is_settled(&self.trainer.model().features, &readings, valid) {
                self.settled = false;
                self.update(&readings, valid);
            }
        }
        self.next += 1;
        if self.next == self.trainer.n_commands() {
            self.end_pass();
        }
    }

    /// All commands were looked at: another pass, with more weights free after some of them, unless all is well.
    fn end_pass(&mut self) {
        self.next = 0;
        self.pass += 1;
        if self.settled {
            self.is_done = true;
        } else if self.pass == PASSES {
            self.pass = 0;
            match self.reach {
                Reach::New => {
                    self.reach = Reach::Learned;
                    self.careful = Some(self.trainer.model().features.clone());
                }
                Reach::Learned => self.is_done = true,
            }
        }
        self.settled = true;
    }

    fn update(&mut self, readings: &[(TermId, Rc<Vector>)], valid: &[bool]) {
        let lexicon = &self.trainer.model().lexicon;
        let from = if self.reach == Reach::New { self.n_entries } else { 0 };
        let learned = |id: &EntryId| lexicon.origin(*id) != Origin::Seed;
        let free = lexicon.entries().iter().skip(from).copied().filter(learned);
        let entries: FxHashSet<EntryId> = free.collect();
        let lexemes: FxHashSet<LexemeId> =
            entries.iter().map(|&id| lexicon.entry(id).lexeme).collect();
        let fixed = if self.reach == Reach::New { &self.lexemes } else { &self.seed };
        let moves = |feature| match feature {
            Feature::Entry(id) => entries.contains(&id),
            Feature::Lexeme(id) => lexemes.contains(&id) && !fixed.contains(&id),
            _ => false,
        };
        // Moment 0: a finished model has no drifts, and gets none.
        let step = (self.trainer.config().margin, 0.0);
        update(self.trainer.features_mut(), readings, valid, step, moves);
    }

    /// What came of it. Weights of entries that were there before stay as they were, unless moving them helped.
    pub fn end(self) -> Taught {
        let Teaching { trainer, examples, facts, demonstrations, n_entries, careful, .. } = self;
        let mut model = trainer.into_model();
        model.facts = facts;
        let taught: usize = model.facts.get("taught").and_then(|n| n.parse().ok()).unwrap_or(0);
        model.facts.insert("taught".to_owned(), (taught + examples.len()).to_string());
        let mut understood = understands(&mut model, &examples, demonstrations);
        if let Some(careful) = careful {
            let bold = std::mem::replace(&mut model.features, careful);
            let before = understands(&mut model, &examples, demonstrations);
            let count = |understood: &[bool]| understood.iter().filter(|&&yes| yes).count();
            if count(&understood) > count(&before) {
                model.features = bold;
            } else {
                understood = before;
            }
        }
        let entries = model.lexicon.entries().iter().skip(n_entries).copied().collect();
        Taught { model, entries, understood }
    }
}

/// Whether the best valid reading leads.
fn is_settled(features: &Features, readings: &[(TermId, Rc<Vector>)], valid: &[bool]) -> bool {
    let best = |wanted: bool| {
        let members = readings.iter().zip(valid).filter(|&(_, &valid)| valid == wanted);
        members.map(|((_, vector), _)| features.dot(vector)).reduce(f64::max)
    };
    match (best(true), best(false)) {
        (Some(valid), Some(invalid)) => valid >= invalid + LEAD,
        (valid, _) => valid.is_some(),
    }
}

/// For each command whether the model's one answer does what the demonstrations show.
fn understands(model: &mut Model, examples: &[Example], demonstrations: usize) -> Vec<bool> {
    let mut validator = Validator::new();
    let mut understands = |example: &Example| {
        let parse = parse(model, &example.command, ChartConfig::of(model));
        let pairs = example.pairs.iter().take(demonstrations);
        let pairs: Vec<_> =
            pairs.map(|pair| validator.shown(&pair.pre, &pair.post, pair.way.as_deref())).collect();
        let answer = parse.answer();
        answer.is_some_and(|answer| validator.valid(&model.grammar.terms, answer.form, &pairs))
    };
    examples.iter().map(&mut understands).collect()
}
