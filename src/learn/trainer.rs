//! Training as a resumable walk over epochs and examples: generate candidates, keep those of the best valid
//! parses, update the weights (after Artzi and Zettlemoyer 2013). A function of corpus, settings and seed alone.

use super::asked::Asked;
use super::config::Config;
use super::fingerprint::fingerprint;
use super::genlex::{Candidate, CoarseCharts, Domain, Generated, Scope, generate};
use super::gradient::update;
use super::idioms::{Command, Idioms, SEARCH};
use super::kept::{Kept, Read};
use super::look::{Last, Look};
use super::phase::Phase;
use super::place::{ASKED, BORN, PLACE, ResumeError, born, order};
use super::planning::{PlannerCost, Planning, Validation};
use super::progress::{Epoch, Progress};
use crate::ccg::absorb::{Leniency, absorbing, absorption};
use crate::ccg::chart::ChartConfig;
use crate::ccg::lookup::{lexical_item, lexical_items};
use crate::ccg::parse::{Parse, fill_knowing};
use crate::ccg::{
    Atom, Category, Derivation, EntryId, Feature, Features, Grammar, MAX_WORDS, Model, Origin,
    Reading, Vector, words,
};
use crate::corpus::Example;
use crate::ground::PairId;
use crate::logic::TermId;
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;
use std::rc::Rc;

/// What each constant of a candidate costs while it is no part of the lexicon: that a word means nothing is believed
/// sooner than that it means something new.
const NOVELTY: f64 = 1.0;

/// A command as training sees it, with the demonstrations of each example that has it: they share a chart.
struct Item {
    words: Vec<String>,
    examples: Vec<Vec<PairId>>,
}

/// A training run. Every [`Trainer::step`] does a bounded part of it.
pub struct Trainer {
    model: Model,
    config: Config,
    items: Vec<Item>,
    n_examples: usize,
    validator: Validation,
    /// Whether any demonstration is a run.
    has_runs: bool,
    kept: Kept,
    /// What was read of the command at work, while nothing is learned that could change it.
    read: Option<Read>,
    coarse: CoarseCharts,
    asked: Asked,
    order: Vec<u32>,
    epoch: u32,
    next: usize,
    phase: Phase,
    so_far: Epoch,
    /// What was learned last.
    last: Option<Last>,
    /// Entries of the lexicon when the command at work was begun.
    entries: usize,
    /// For each entry that was learned, in the lexicon's order, the place of the command that it came from.
    born: Vec<u32>,
    /// What is done when the epochs are over.
    idioms: Option<Idioms>,
}

impl Trainer {
    /// A run over the examples, from a model that knows a seed lexicon.
    pub fn new(mut model: Model, examples: &[Example], config: Config) -> Self {
        model.features.silence(config.without);
        for (name, value) in config.facts() {
            model.facts.insert(name.to_owned(), value);
        }
        model.facts.insert("examples".to_owned(), examples.len().to_string());
        model.facts.insert("corpus".to_owned(), fingerprint(examples));
        if let Some(Planning { horizon, .. }) = config.planning {
            model.facts.insert("horizon".to_owned(), horizon.to_string());
        }
        let mut validator = Validation::new(config.planning);
        let has_runs = examples.iter().flat_map(|one| &one.pairs).any(|pair| pair.way.is_some());
        let mut items: IndexMap<Vec<String>, Vec<Vec<PairId>>, FxBuildHasher> = IndexMap::default();
        for example in examples {
            let pairs = validator.demonstrations(example, config.demonstrations, config.contrasts);
            items.entry(words(&example.command)).or_default().push(pairs);
        }
        let items: Vec<Item> =
            items.into_iter().map(|(words, examples)| Item { words, examples }).collect();
        let mut trainer = Trainer {
            entries: model.lexicon.len(),
            model,
            config,
            kept: Kept::new(items.len()),
            read: None,
            coarse: CoarseCharts::default(),
            asked: Asked::new(items.len()),
            items,
            n_examples: examples.len(),
            validator,
            has_runs,
            order: Vec::new(),
            epoch: 0,
            next: 0,
            phase: Phase::Explain,
            so_far: Epoch::default(),
            last: None,
            born: Vec::new(),
            idioms: None,
        };
        trainer.begin_epoch();
        trainer
    }

    /// Goes on where a checkpoint of the same run was made.
    ///
    /// # Errors
    /// When the checkpoint is of another corpus or of other settings, or does not say where the run was.
    pub fn resume(
        checkpoint: Model,
        examples: &[Example],
        config: Config,
    ) -> Result<Self, ResumeError> {
        let theirs = checkpoint.facts.clone();
        let mut trainer = Trainer::new(checkpoint, examples, config);
        for (fact, ours) in &trainer.model.facts {
            let before = theirs.get(fact).map_or("missing", String::as_str);
            if before != ours {
                let (theirs, ours) = (before.to_owned(), ours.clone());
                return Err(ResumeError { fact: fact.clone(), theirs, ours });
            }
        }
        let place = [trainer.epoch as usize, trainer.next, 0, 0, 0];
        let mut at = place;
        for ((fact, begin), found) in PLACE.iter().zip(place).zip(&mut at) {
            let theirs = theirs.get(*fact).map_or("missing", String::as_str);
            let number = theirs.parse().ok().filter(|&n| trainer.has_place(fact, n));
            *found = number.ok_or_else(|| ResumeError {
                fact: (*fact).to_owned(),
                theirs: theirs.to_owned(),
                ours: begin.to_string(),
            })?;
        }
        let [epoch, next, valid, updates, over_budget] = at;
        trainer.epoch = (epoch as u32).saturating_sub(1);
        trainer.begin_epoch();
        trainer.next = next;
        let entries = trainer.model.lexicon.len();
        trainer.so_far = Epoch { valid, updates, entries, over_budget };
        trainer.born = born(theirs.get(BORN), trainer.items.len(), entries);
        trainer.asked = Asked::read(theirs.get(ASKED), trainer.items.len(), entries);
        if let [Some(numbers), Some(meant), Some(found)] = SEARCH.map(|fact| theirs.get(fact)) {
            let (n_items, place) = (trainer.items.len(), [numbers, meant, found]);
            let begun = trainer.begin_idioms();
            let terms = &mut trainer.model.grammar.terms;
            trainer.idioms = begun.resumed(place.map(String::as_str), n_items, terms);
        }
        let place = PLACE.iter().chain([&BORN, &ASKED]).chain(&SEARCH);
        place.for_each(|&fact| drop(trainer.model.facts.shift_remove(fact)));
        Ok(trainer)
    }

    /// Whether a run can stand there: an epoch from 1 to one past the last, an example of it.
    fn has_place(&self, fact: &str, n: usize) -> bool {
        match fact {
            "at_epoch" => (1..=self.config.epochs as usize + 1).contains(&n),
            "at_example" => n < self.items.len().max(1),
            _ => true,
        }
    }

    /// A model file from which the run can go on, made between two examples.
    pub fn checkpoint(&self) -> String {
        let mut model = self.model.clone();
        let Epoch { valid, updates, over_budget, .. } = self.so_far;
        let place = [self.epoch as usize, self.next, valid, updates, over_budget];
        for (fact, value) in PLACE.iter().zip(place) {
            model.facts.insert((*fact).to_owned(), value.to_string());
        }
        if let Some(idioms) = &self.idioms {
            let place = idioms.place(&model.grammar.terms);
            let facts = SEARCH.into_iter().map(str::to_owned).zip(place);
            model.facts.extend(facts);
        }
        if !self.born.is_empty() {
            let born: Vec<String> = self.born.iter().map(u32::to_string).collect();
            model.facts.insert(BORN.to_owned(), born.join(" "));
        }
        model.facts.extend(self.asked.print().map(|asked| (ASKED.to_owned(), asked)));
        model.print()
    }

    /// Examples in an epoch.
    pub fn n_examples(&self) -> usize {
        self.n_examples
    }

    /// The settings of the run.
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// What planning cost so far; `None` when nothing plans.
    pub fn planner_cost(&self) -> Option<PlannerCost> {
        self.validator.cost()
    }

    /// Whether all epochs are done, and idioms found.
    pub fn is_done(&self) -> bool {
        let has_idioms = || self.idioms.as_ref().is_some_and(|i| i.seen() == 2 * self.items.len());
        self.items.is_empty() || self.is_trained() && (!self.config.idioms || has_idioms())
    }

    /// Whether all epochs are done.
    fn is_trained(&self) -> bool {
        self.epoch > self.config.epochs
    }

    /// The model as it is now.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The model with every weight as it was on average so far and the idioms found, which is what a run ends with.
    pub fn averaged(&self) -> Model {
        self.ended(self.model.clone())
    }

    /// The same at the end of a run, which keeps nothing.
    pub fn end(mut self) -> Model {
        let model = std::mem::take(&mut self.model);
        self.ended(model)
    }

    /// A model with the weights of this one as they were on average so far, and the idioms found.
    fn ended(&self, mut model: Model) -> Model {
        self.average(&mut model.features);
        for (at, goal) in self.idioms.iter().flat_map(Idioms::found) {
            // A goal that a chart has made is never too large.
            let _ = model.add_idiom(&self.items[*at].words, *goal);
        }
        model
    }

    /// Replaces the weights by what they were on average so far.
    fn average(&self, features: &mut Features) {
        let visits = self.visits();
        if visits > 0.0 {
            features.average(visits);
        }
    }

    /// Distinct commands.
    pub(super) fn n_commands(&self) -> usize {
        self.items.len()
    }

    /// The weights.
    pub(super) fn features_mut(&mut self) -> &mut Features {
        self.coarse.forget();
        &mut self.model.features
    }

    /// The model as it is now.
    pub(super) fn into_model(self) -> Model {
        self.model
    }

    /// Visits of examples before those of the command at work.
    fn visits(&self) -> f64 {
        f64::from(self.epoch - 1) * self.n_examples as f64 + self.seen() as f64
    }

    /// Examples of this epoch that were seen.
    fn seen(&self) -> usize {
        let done = self.order.iter().take(self.next);
        done.map(|&at| self.items[at as usize].examples.len()).sum()
    }

    /// Whether it is between two commands, where a checkpoint may be made.
    pub fn is_between(&self) -> bool {
        self.phase == Phase::Explain && self.read.is_none()
    }

    /// What was learned from the command before.
    pub fn look(&self) -> Option<Look> {
        let last = self.last.as_ref()?;
        let Item { words, examples } = self.items.get(last.at)?;
        Some(last.look(&self.model, words, examples.len(), self.config.without))
    }

    /// For each entry that was learned, in the lexicon's order, the command that it came from.
    pub fn origins(&self) -> Vec<String> {
        let command = |&at: &u32| self.items.get(at as usize).map(|item| item.words.join(" "));
        self.born.iter().map(|at| command(at).unwrap_or_default()).collect()
    }

    /// How far it is.
    pub fn progress(&self) -> Progress {
        Progress { epoch: self.epoch, example: self.seen(), so_far: self.so_far }
    }

    /// Does the next part; the progress when that ended an example.
    pub fn step(&mut self) -> Option<Progress> {
        if self.is_done() {
            return None;
        }
        if self.is_trained() {
            return Some(self.look_for_idioms());
        }
        let at = *self.order.get(self.next)? as usize;
        let known = match self.phase {
            Phase::Explain => None,
            Phase::Generate(example, scope) => {
                let entries = self.model.lexicon.len();
                self.generate(at, example, scope);
                self.read.take().filter(|_| self.model.lexicon.len() == entries)
            }
        };
        let (readings, over_budget) = known.unwrap_or_else(|| self.read(at));
        let judged = self.judge(at, &readings);
        let Trainer { model: Model { lexicon, .. }, asked, items, .. } = self;
        if self.epoch <= self.config.generations
            && (self.phase != Phase::Explain || !asked.is_known(at, &items[at].words, lexicon))
        {
            if let Some(next) = self.phase.next(&judged) {
                self.phase = next;
                self.read = Some((readings, over_budget));
                return None;
            }
            asked.note(at, lexicon);
        }
        self.phase = Phase::Explain;
        self.coarse.forget();
        let mut steps = Vec::with_capacity(judged.len());
        let without = self.config.without;
        let moves = |feature: Feature| feature.is_learned() && !without.has(feature);
        for (moment, valid) in (self.visits() as u64..).zip(&judged) {
            let at = (self.config.margin, moment as f64);
            let step = update(&mut self.model.features, &readings, valid, at, moves);
            self.so_far.over_budget += usize::from(over_budget);
            self.so_far.valid += usize::from(valid.contains(&true));
            self.so_far.updates += usize::from(step.is_some());
            steps.extend(step);
        }
        self.so_far.entries = self.model.lexicon.len();
        let entries = std::mem::replace(&mut self.entries, self.model.lexicon.len());
        self.last = Some(Last { at, readings, judged, steps, entries });
        self.next += 1;
        let progress = self.progress();
        if self.next == self.items.len() {
            self.model.facts.insert("valid".to_owned(), self.so_far.valid.to_string());
            self.begin_epoch();
        }
        Some(progress)
    }

    /// Looks at one command: what it is answered, or what else it could mean. How far that is, as if it were one more
    /// epoch.
    fn look_for_idioms(&mut self) -> Progress {
        let mut idioms = self.idioms.take().unwrap_or_else(|| self.begin_idioms());
        let (seen, all) = (idioms.seen(), self.items.len());
        let at = seen % all;
        if let Some(Item { words, examples }) = self.items.get(at) {
            let command = Command { words, rows: examples };
            let Trainer { model, kept, validator, .. } = self;
            match seen < all {
                true => idioms.answer((at, &command), model, kept, validator),
                false => idioms.search(&command, &model.grammar.terms, validator),
            }
        }
        let example = self.n_examples * idioms.seen() / (2 * all);
        self.idioms = Some(idioms);
        Progress { epoch: self.epoch, example, so_far: self.so_far }
    }

    fn begin_idioms(&self) -> Idioms {
        let mut features = self.model.features.clone();
        self.average(&mut features);
        Idioms::new(features)
    }

    fn begin_epoch(&mut self) {
        self.epoch += 1;
        self.next = 0;
        if !self.is_trained() {
            self.so_far = Epoch::default();
        }
        self.order = order(self.items.len(), self.config.seed, self.epoch);
    }

    /// What pairs of states alone show tells of no task over time.
    fn chart_config(&self, beam: u32, budget: usize) -> ChartConfig {
        let in_time = self.has_runs;
        ChartConfig { beam: beam as usize, budget, in_time, ..ChartConfig::default() }
    }

    /// Lexical generation for a sentence that the lexicon cannot explain: the candidates that the best valid parse
    /// uses become entries.
    pub(super) fn generate(&mut self, at: usize, example: usize, scope: Scope) {
        let words = &self.items[at].words;
        if !can_parse(words) {
            return;
        }
        let config = self.chart_config(self.config.lexical_beam, self.config.lexical_budget);
        let pairs = &self.items[at].examples[example];
        let shows_run = pairs.iter().any(|&pair| self.validator.is_run(pair));
        let may = (scope, if shows_run { Domain::Runs } else { Domain::States });
        let generated = generate(&mut self.model, words, may, config, &mut self.coarse);
        let is_new = |&id: &EntryId| self.model.lexicon.is_candidate(id);
        if generated.candidates.is_empty() && !generated.empty.iter().flatten().any(is_new) {
            return;
        }
        let parse = self.parse_with(at, example, &generated);
        let mut additions: Vec<Vec<EntryId>> = Vec::new();
        for reading in self.best_valid(&parse, at, example) {
            let derivation = parse.derivation(reading);
            let lexicon = &self.model.lexicon;
            let empty = derivation.absorbed().into_iter().filter_map(|at| generated.empty[at]);
            let entries =
                derivation.leaves().into_iter().filter_map(Derivation::entry).chain(empty);
            additions.push(entries.filter(|&entry| lexicon.is_candidate(entry)).collect());
        }
        // Of readings that explain the demonstrations equally well, the one that asks for least is believed.
        if let Some(fewest) = additions.iter().min_by_key(|entries| entries.len()) {
            for &entry in fewest {
                if self.model.lexicon.admit(entry, Origin::Learned) {
                    self.born.push(at as u32);
                }
            }
        }
    }

    /// A parse with lexicon and candidates. Phrases that denote nothing before the demonstrations, and categories
    /// that lead nowhere, are left out.
    fn parse_with(&mut self, at: usize, example: usize, generated: &Generated) -> Parse {
        let config = self.chart_config(self.config.beam, self.config.lexical_budget);
        let Item { words, examples } = &self.items[at];
        let pairs = &examples[example];
        let mut items = lexical_items(&self.model, words);
        for &Candidate { start, end, entry } in &generated.candidates {
            let mut item = lexical_item(&self.model, entry, start, end);
            let lexeme = self.model.lexicon.lexeme(self.model.lexicon.entry(entry).lexeme);
            item.score -= NOVELTY * lexeme.constants.len() as f64;
            items.push(item);
        }
        let costs = absorption(&self.model, words, &generated.empty, Leniency::Learned);
        let items = absorbing(items, &costs);
        let validator = &mut self.validator;
        let admit = |grammar: &Grammar, (start, end): (usize, usize), category: Category| {
            let is = |atom| grammar.syntaxes.is(category.syntax, atom);
            generated.useful.contains(&(start, end, category.syntax))
                && (!(is(Atom::N) || is(Atom::NP))
                    || validator.denotes(&grammar.terms, category.meaning, pairs))
        };
        fill_knowing(&mut self.model, self.kept.goals(), words, items, admit, config)
    }

    /// The valid readings that no other valid reading outscores.
    fn best_valid(&mut self, parse: &Parse, at: usize, example: usize) -> Vec<Reading> {
        let pairs = &self.items[at].examples[example];
        let mut best = Vec::new();
        let mut bar = None;
        for (rank, reading) in parse.ranked() {
            if bar.is_some_and(|bar| rank < bar) {
                break;
            }
            if self.validator.valid(&self.model.grammar.terms, reading.form, pairs) {
                bar = Some(rank);
                best.push(reading);
            }
        }
        best
    }

    /// For each example of a command which of its readings are valid.
    pub(super) fn judge(&mut self, at: usize, readings: &[(TermId, Rc<Vector>)]) -> Vec<Vec<bool>> {
        let mut judged = Vec::with_capacity(self.items[at].examples.len());
        for pairs in &self.items[at].examples {
            let mut valid = |form| self.validator.valid(&self.model.grammar.terms, form, pairs);
            judged.push(readings.iter().map(|&(form, _)| valid(form)).collect());
        }
        judged
    }

    /// The goals that the lexicon alone reads, with their features; whether the chart is not whole.
    pub(super) fn read(&mut self, at: usize) -> Read {
        let words = &self.items[at].words;
        if !can_parse(words) {
            return (Vec::new(), false);
        }
        let config = self.chart_config(self.config.beam, self.config.budget);
        self.kept.read(at, &mut self.model, words, config)
    }
}

fn can_parse(words: &[String]) -> bool {
    (1..=MAX_WORDS).contains(&words.len())
}
