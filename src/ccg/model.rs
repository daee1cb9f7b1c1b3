//! A model: grammar, lexicon and weights, with what is known of how it came to be. Its file is one text, a fact a
//! line, fields parted by tabs; what is read back scores every sentence to the same bit, since order is kept.

use super::category::Category;
use super::combinator::{Grammar, Shift};
use super::doubt::Doubt;
use super::features::{Feature, Features};
use super::general::General;
use super::lexicon::{EntryId, Hole, Lexeme, Lexicon, Origin, TemplateId, boxed};
use super::number::number;
use super::syntax::Atom;
use crate::logic::{ConstantId, LogicError, Signature, Sorts, TIME, TermId, print, read, ty};
use indexmap::IndexMap;
use std::sync::Arc;

/// The first line of a model file.
const HEADER: &str = "groundling model 1";

/// What a step away from a word costs.
const FAR: f64 = -2.5;
/// What a measure scores, as if a seed lexicon had it.
const MEASURE: f64 = 14.0;
/// What it is worth that words are a name that was given.
const NAME: f64 = 1.0;

/// Type shifts that a grammar may have: rules are numbered in a byte.
const MAX_SHIFTS: usize = 64;

/// A parser that can be asked, trained and saved.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// The arena, categories and rules.
    pub grammar: Grammar,
    /// Words and their categories.
    pub lexicon: Lexicon,
    /// Features and their weights.
    pub features: Features,
    /// The constants that forms may speak of.
    pub signature: Signature,
    /// Settings, seed, corpus: name and value, in order.
    pub facts: IndexMap<String, String>,
    /// How likely its answers are right; old models have none.
    pub doubt: Option<Doubt>,
    /// What words that the lexicon does not know may stand for. No part of a model file.
    general: Arc<General>,
}

/// What is wrong with a model file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {reason}")]
pub struct ModelError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub reason: String,
}

impl Model {
    /// Says which constants there are.
    pub fn set_signature(&mut self, signature: Signature) {
        self.grammar.sorts = Sorts::new(&signature);
        self.signature = signature;
    }

    /// Understands words that the lexicon does not know by a general resource, from now on.
    pub fn attach(&mut self, general: Arc<General>) {
        self.features.set(Feature::Far, FAR);
        self.features.set(Feature::Measure, MEASURE);
        self.general = general;
    }

    /// What words that the lexicon does not know may stand for.
    pub fn general(&self) -> &Arc<General> {
        &self.general
    }

    /// What an entry of the lexicon, or a candidate, scores.
    pub fn entry_score(&self, id: EntryId) -> f64 {
        self.value(&self.entry_features(id))
    }

    /// What the use of an entry is scored by.
    pub fn entry_features(&self, id: EntryId) -> [Feature; 3] {
        let entry = self.lexicon.entry(id);
        [Feature::Lexeme(entry.lexeme), Feature::Template(entry.template), Feature::Entry(id)]
    }

    /// What it is scored by that a word goes without meaning, be it by an entry that says so.
    pub fn absorption_features(&self, word: &str, empty: Option<EntryId>) -> Vec<Feature> {
        let mut features = match empty {
            Some(entry) => self.entry_features(entry).to_vec(),
            None => vec![Feature::Skip],
        };
        if self.lexicon.has_content(word) {
            features.push(Feature::Dropped);
        }
        features
    }

    /// The sum of what features add to a score, each occurring once.
    pub fn value(&self, features: &[Feature]) -> f64 {
        features.iter().fold(0.0, |sum, &feature| sum + self.features.value(feature))
    }

    /// Gives a whole sentence a goal, heard only when nothing else is said.
    ///
    /// # Errors
    /// When the goal is too large.
    pub fn add_idiom(&mut self, words: &[String], goal: TermId) -> Result<(), LogicError> {
        let words = boxed(words);
        let syntax = self.grammar.syntaxes.atom(Atom::S);
        let category = Category { syntax, meaning: goal };
        self.lexicon.add_idiom(&mut self.grammar, words, category).map(drop)
    }

    /// Gives words the category that other words have; it goes before what learning made of them.
    ///
    /// # Errors
    /// When the category cannot be factored.
    pub fn add_name(
        &mut self,
        words: &[String],
        category: Category,
    ) -> Result<EntryId, LogicError> {
        let words = boxed(words);
        let entry =
            self.lexicon.add_category(&mut self.grammar, words, category, Origin::Learned)?;
        self.features.set(Feature::Entry(entry), NAME);
        Ok(entry)
    }

    /// The model file's text.
    pub fn print(&self) -> String {
        let mut lines = vec![HEADER.to_owned()];
        lines.extend(self.facts.iter().map(|(name, value)| format!("fact\t{name}\t{value}")));
        lines.extend(self.signature.print().lines().map(|line| format!("signature\t{line}")));
        lines.extend(self.lexicon.frame.iter().map(|&c| format!("frame\t{}", self.constant(c))));
        let commutative = self.grammar.commutative.iter();
        lines.extend(commutative.map(|&c| format!("commutative\t{}", self.constant(c))));
        for Shift { name, meaning, .. } in &self.grammar.shifts {
            lines.push(format!("shift\t{name}\t{}", print(&self.grammar.terms, *meaning)));
        }
        for (_, template) in self.lexicon.templates() {
            let syntax = self.grammar.syntaxes.text(template.syntax);
            let meaning = print(&self.grammar.terms, template.meaning);
            lines.push(format!("template\t{syntax}\t{}\t{meaning}", template.holes));
        }
        for (&template, holes) in &self.lexicon.open {
            let holes: Vec<String> = holes.iter().map(|&hole| self.hole_text(hole)).collect();
            let place = self.lexicon.template_place(template);
            lines.push(format!("open\t{place}\t{}", holes.join(" ")));
        }
        for &id in self.lexicon.entries() {
            let origin = match self.lexicon.origin(id) {
                Origin::Seed => "seed",
                Origin::Learned | Origin::Candidate => "learned",
            };
            lines.push(format!("entry\t{}\t{origin}", self.entry_text(id)));
        }
        for (feature, weight, drift) in self.features.iter() {
            let feature = self.feature_text(feature);
            lines.push(format!("weight\t{feature}\t{weight}"));
            if drift != 0.0 {
                lines.push(format!("drift\t{feature}\t{drift}"));
            }
        }
        for (words, entry) in self.lexicon.idioms() {
            let goal = print(&self.grammar.terms, self.lexicon.category(entry).meaning);
            lines.push(format!("idiom\t{}\t{goal}", words.join(" ")));
        }
        lines.extend(self.doubt.iter().flat_map(Doubt::lines));
        lines.push("end\n".to_owned());
        lines.join("\n")
    }

    /// Reads a model file.
    ///
    /// # Errors
    /// With the line and what is wrong there.
    pub fn read(text: &str) -> Result<Model, ModelError> {
        let mut model = Model::default();
        let mut signature = String::new();
        let mut ended = false;
        for (line, content) in (1..).zip(text.lines()) {
            let fields: Vec<&str> = content.split('\t').collect();
            let error = |reason: String| ModelError { line, reason };
            match fields[..] {
                [HEADER] if line == 1 => {}
                _ if line == 1 => {
                    return Err(error(format!(
                        "a model file of this version begins with {HEADER:?}: learn it anew with `train`, from the corpus that it was learned from"
                    )));
                }
                _ if ended => return Err(error("the file goes on after its end".to_owned())),
                ["end"] => ended = true,
                ["signature", line] => {
                    signature.push_str(line);
                    signature.push('\n');
                    let read = Signature::read(&signature);
                    model.set_signature(read.map_err(|e| error(e.reason.into()))?);
                }
                _ => model.read_line(&fields).map_err(error)?,
            }
        }
        if !ended {
            let line = text.lines().count() + 1;
            return Err(ModelError {
                line,
                reason: "the file breaks off before its end".to_owned(),
            });
        }
        Ok(model)
    }

    fn read_line(&mut self, fields: &[&str]) -> Result<(), String> {
        match *fields {
            ["fact", name, value] => {
                self.facts.insert(name.to_owned(), value.to_owned());
            }
            ["frame", constant] => {
                let constant = self.read_constant(constant)?;
                self.lexicon.frame.push(constant);
            }
            ["commutative", constant] => {
                let constant = self.read_constant(constant)?;
                self.grammar.commutative.push(constant);
            }
            ["shift", name, meaning] => self.read_shift(name, meaning)?,
            ["template", syntax, holes, meaning] => {
                let syntax = self
                    .grammar
                    .syntaxes
                    .read(syntax)
                    .ok_or(format!("{syntax:?} is no category"))?;
                let holes = holes.parse().map_err(|_| format!("{holes:?} is no number"))?;
                let meaning = read(&mut self.grammar.terms, meaning).map_err(|e| e.to_string())?;
                let template = self.lexicon.add_template(syntax, meaning, holes);
                if self.lexicon.holes(&self.grammar, template).len() != holes {
                    return Err(format!("the template's meaning has not {holes} holes"));
                }
            }
            ["open", place, holes] => {
                let template = self.read_template(place)?;
                let holes: Result<Box<[Hole]>, String> =
                    holes.split_whitespace().map(|hole| self.read_hole(hole)).collect();
                let holes = holes?;
                if holes.len() != self.lexicon.template(template).holes {
                    return Err(format!("template {place} has not {} holes", holes.len()));
                }
                self.lexicon.open.insert(template, holes);
            }
            ["entry", words, constants, template, origin] => {
                let origin = match origin {
                    "seed" => Origin::Seed,
                    "learned" => Origin::Learned,
                    _ => return Err(format!("{origin:?} is neither seed nor learned")),
                };
                self.read_entry(words, constants, template, origin)?;
            }
            [kind @ ("weight" | "drift"), ref feature @ .., text] => {
                let value = number(text).ok_or_else(|| format!("{text:?} is no finite number"))?;
                let feature = self.read_feature(feature)?;
                match kind {
                    "weight" => self.features.set(feature, value),
                    _ => self.features.set_drift(feature, value),
                }
            }
            ["idiom", words, goal] => {
                let words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
                let goal = read(&mut self.grammar.terms, goal).map_err(|e| e.to_string())?;
                self.check_constants(goal)?;
                if words.is_empty() || !matches!(self.grammar.terms.ty(goal), ty::TRUTH | ty::RUN) {
                    return Err("an idiom is words and a goal".to_owned());
                }
                self.add_idiom(&words, goal).map_err(|e| e.to_string())?;
            }
            ["doubt", sign, value] => {
                self.doubt.get_or_insert_default().read_line(sign, value)?;
            }
            _ => {
                let begin: String = fields.concat().chars().take(20).collect();
                return Err(format!(
                    "no line of a model begins with {begin:?}; its parts stand between tabs, not spaces"
                ));
            }
        }
        Ok(())
    }

    /// Adds a type shift: a name `FROM=>TO`, after which a further word may tell shifts apart, and what it does to a
    /// meaning.
    ///
    /// # Errors
    /// In words, when a category or the meaning cannot be read, the name is taken, or there are too many.
    pub(super) fn read_shift(&mut self, name: &str, meaning: &str) -> Result<(), String> {
        let Grammar { syntaxes, shifts, .. } = &mut self.grammar;
        let (from, to) = name.split_once("=>").ok_or("a shift is called FROM=>TO")?;
        let to = to.split_whitespace().next().unwrap_or("");
        let mut syntax =
            |text: &str| syntaxes.read(text).ok_or(format!("{text:?} is no syntactic category"));
        let (from, to) = (syntax(from.trim())?, syntax(to)?);
        if shifts.len() == MAX_SHIFTS || shifts.iter().any(|shift| *shift.name == *name) {
            return Err(format!("there are {MAX_SHIFTS} shifts at most, each with its own name"));
        }
        let meaning = read(&mut self.grammar.terms, meaning).map_err(|e| e.to_string())?;
        self.check_constants(meaning)?;
        let Grammar { syntaxes, terms, shifts, .. } = &mut self.grammar;
        if let [Some(from), Some(to)] = [from, to].map(|id| syntaxes.ty(&mut terms.types, id)) {
            let (wanted, found) = (terms.types.function(from, to), terms.ty(meaning));
            if wanted != found {
                let [wanted, found] = [wanted, found].map(|ty| terms.types.print(ty));
                return Err(format!("what {name} does has type {wanted}, not {found}"));
            }
        }
        shifts.push(Shift { name: name.into(), from, to, meaning });
        Ok(())
    }

    fn read_entry(
        &mut self,
        words: &str,
        constants: &str,
        template: &str,
        origin: Origin,
    ) -> Result<EntryId, String> {
        let words: Box<[Box<str>]> = words.split_whitespace().map(Box::from).collect();
        if words.is_empty() {
            return Err("an entry needs words".to_owned());
        }
        let constants: Result<Box<[ConstantId]>, String> =
            constants.split_whitespace().map(|constant| self.read_constant(constant)).collect();
        let place = template.parse().map_err(|_| format!("{template:?} is no number"))?;
        let template =
            self.lexicon.template_at(place).ok_or(format!("there is no template {place}"))?;
        let lexeme = Lexeme { words, constants: constants? };
        self.lexicon
            .add(&mut self.grammar, lexeme, template, origin)
            .map_err(|_| "the constants do not fit the template".to_owned())
    }

    /// Every constant must be in the signature with its type, or be a hole; what speaks of time is in every one.
    pub(super) fn check_constants(&mut self, meaning: TermId) -> Result<(), String> {
        for constant in self.grammar.terms.constants(meaning) {
            let terms = &mut self.grammar.terms;
            let (name, ty) = (terms.name(constant).to_owned(), terms.constant_ty(constant));
            let is_of_time = TIME.contains(&(&*name, &*terms.types.print(ty)));
            if !name.starts_with('?')
                && !is_of_time
                && self.signature.ty(&mut terms.types, &name) != Some(ty)
            {
                let ty = terms.types.print(ty);
                return Err(format!("{name}:{ty} is not in the signature"));
            }
        }
        Ok(())
    }

    /// The constant that a text `name:type` names, which must be in the signature.
    pub(super) fn read_constant(&mut self, text: &str) -> Result<ConstantId, String> {
        let known = || format!("{text} is not in the signature");
        let (name, ty) = text.split_once(':').ok_or_else(known)?;
        let terms = &mut self.grammar.terms;
        let ty = terms.types.read(ty).ok_or_else(known)?;
        if self.signature.ty(&mut terms.types, name) != Some(ty) {
            return Err(known());
        }
        Ok(terms.constant(name, ty))
    }

    fn constant(&self, constant: ConstantId) -> String {
        let terms = &self.grammar.terms;
        format!("{}:{}", terms.name(constant), terms.types.print(terms.constant_ty(constant)))
    }

    fn hole_text(&self, hole: Hole) -> String {
        match hole {
            Hole::Any => "?".to_owned(),
            Hole::Noun => "?noun".to_owned(),
            Hole::Adjective => "?adjective".to_owned(),
            Hole::Only(constant) => self.constant(constant),
        }
    }

    fn read_hole(&mut self, text: &str) -> Result<Hole, String> {
        Ok(match text {
            "?" => Hole::Any,
            "?noun" => Hole::Noun,
            "?adjective" => Hole::Adjective,
            _ => Hole::Only(self.read_constant(text)?),
        })
    }

    fn read_template(&self, place: &str) -> Result<TemplateId, String> {
        let number = place.parse().map_err(|_| format!("{place:?} is no number"))?;
        self.lexicon.template_at(number).ok_or(format!("there is no template {place}"))
    }

    /// Words, constants and the template's place, as a model file has them.
    fn entry_text(&self, id: EntryId) -> String {
        let entry = self.lexicon.entry(id);
        let lexeme = self.lexicon.lexeme(entry.lexeme);
        let constants: Vec<String> = lexeme.constants.iter().map(|&c| self.constant(c)).collect();
        let place = self.lexicon.template_place(entry.template);
        format!("{}\t{}\t{place}", lexeme.words.join(" "), constants.join(" "))
    }

    /// A feature as a model file has it.
    pub fn feature_text(&self, feature: Feature) -> String {
        match feature {
            Feature::Lexeme(id) => {
                let lexeme = self.lexicon.lexeme(id);
                let constants: Vec<String> =
                    lexeme.constants.iter().map(|&c| self.constant(c)).collect();
                format!("lexeme\t{}\t{}", lexeme.words.join(" "), constants.join(" "))
            }
            Feature::Template(id) => format!("template\t{}", self.lexicon.template_place(id)),
            Feature::Entry(id) => format!("entry\t{}", self.entry_text(id)),
            Feature::Rule(rule) => format!("rule\t{}", self.grammar.rule_name(rule)),
            Feature::Skip => "skip".to_owned(),
            Feature::Dropped => "dropped".to_owned(),
            Feature::Lost => "lost".to_owned(),
            Feature::Far => "far".to_owned(),
            Feature::Measure => "measure".to_owned(),
            Feature::Pair(a, b) => format!("pair\t{}\t{}", self.constant(a), self.constant(b)),
            Feature::Conjoined(a, b) => {
                format!("conjoined\t{}\t{}", self.constant(a), self.constant(b))
            }
            Feature::Alone(constant) => format!("alone\t{}", self.constant(constant)),
            Feature::Head(relation, place, head) => {
                format!("head\t{}\t{place}\t{}", self.constant(relation), self.constant(head))
            }
            Feature::Heads(a, b) => format!("heads\t{}\t{}", self.constant(a), self.constant(b)),
            Feature::Twice(relation) => format!("twice\t{}", self.constant(relation)),
            Feature::Adjectives => "adjectives".to_owned(),
            Feature::Then(a, b) => format!("then\t{}\t{}", self.constant(a), self.constant(b)),
        }
    }

    fn read_feature(&mut self, fields: &[&str]) -> Result<Feature, String> {
        Ok(match *fields {
            ["lexeme", words, constants] => {
                let words = words.split_whitespace().map(Box::from).collect();
                let constants: Result<Box<[ConstantId]>, String> =
                    constants.split_whitespace().map(|c| self.read_constant(c)).collect();
                let lexeme = Lexeme { words, constants: constants? };
                Feature::Lexeme(self.lexicon.intern_lexeme(lexeme))
            }
            ["template", place] => Feature::Template(self.read_template(place)?),
            ["entry", words, constants, template] => {
                Feature::Entry(self.read_entry(words, constants, template, Origin::Candidate)?)
            }
            ["rule", name] => Feature::Rule(
                self.grammar.rule_named(name).ok_or(format!("there is no rule {name:?}"))?,
            ),
            ["skip"] => Feature::Skip,
            ["dropped"] => Feature::Dropped,
            ["lost"] => Feature::Lost,
            ["far"] => Feature::Far,
            ["measure"] => Feature::Measure,
            ["pair", a, b] => Feature::Pair(self.read_constant(a)?, self.read_constant(b)?),
            ["conjoined", a, b] => {
                Feature::Conjoined(self.read_constant(a)?, self.read_constant(b)?)
            }
            ["alone", constant] => Feature::Alone(self.read_constant(constant)?),
            ["head", relation, place, head] => {
                let place = place.parse().map_err(|_| format!("{place:?} is no number"))?;
                Feature::Head(self.read_constant(relation)?, place, self.read_constant(head)?)
            }
            ["heads", a, b] => Feature::Heads(self.read_constant(a)?, self.read_constant(b)?),
            ["twice", relation] => Feature::Twice(self.read_constant(relation)?),
            ["adjectives"] => Feature::Adjectives,
            ["then", a, b] => Feature::Then(self.read_constant(a)?, self.read_constant(b)?),
            _ => {
                let begin: String = fields.concat().chars().take(20).collect();
                return Err(format!("there is no feature {begin:?} with so many parts"));
            }
        })
    }
}
