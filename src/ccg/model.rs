//! A model: grammar, lexicon and weights, with what is known of how it came to be. Its file is one text, a fact a
//! line, fields parted by tabs; what is read back scores every sentence to the same bit, since order is kept.

use super::combinator::{Grammar, RuleId};
use super::features::{Feature, Features};
use super::lexicon::{EntryId, Lexeme, Lexicon, Origin};
use crate::logic::{ConstantId, Signature, print, read};
use indexmap::IndexMap;

/// The first line of a model file.
const HEADER: &str = "groundling model 1";

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
    /// What an entry of the lexicon, or a candidate, scores.
    pub fn entry_score(&self, id: EntryId) -> f64 {
        let entry = self.lexicon.entry(id);
        self.features.value(Feature::Lexeme(entry.lexeme))
            + self.features.value(Feature::Template(entry.template))
            + self.features.value(Feature::Entry(id))
    }

    /// The model file's text.
    pub fn print(&self) -> String {
        let mut lines = vec![HEADER.to_owned()];
        lines.extend(self.facts.iter().map(|(name, value)| format!("fact\t{name}\t{value}")));
        lines.extend(self.signature.iter().map(|(name, ty)| format!("constant\t{name}:{ty}")));
        lines.extend(self.lexicon.frame.iter().map(|&c| format!("frame\t{}", self.constant(c))));
        let commutative = self.grammar.commutative.iter();
        lines.extend(commutative.map(|&c| format!("commutative\t{}", self.constant(c))));
        for (_, template) in self.lexicon.templates() {
            let syntax = self.grammar.syntaxes.text(template.syntax);
            let meaning = print(&self.grammar.terms, template.meaning);
            lines.push(format!("template\t{syntax}\t{}\t{meaning}", template.holes));
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
                        "a model file of this version begins with {HEADER:?}"
                    )));
                }
                _ if ended => return Err(error("the file goes on after its end".to_owned())),
                ["end"] => ended = true,
                ["constant", constant] => {
                    signature.push_str(constant);
                    signature.push('\n');
                    model.signature =
                        Signature::read(&signature).map_err(|e| error(e.reason.into()))?;
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
            ["entry", words, constants, template, origin] => {
                let origin = match origin {
                    "seed" => Origin::Seed,
                    "learned" => Origin::Learned,
                    _ => return Err(format!("{origin:?} is neither seed nor learned")),
                };
                self.read_entry(words, constants, template, origin)?;
            }
            [kind @ ("weight" | "drift"), ref feature @ .., value] => {
                let value: f64 = value.parse().map_err(|_| format!("{value:?} is no number"))?;
                if !value.is_finite() {
                    return Err(format!("the {kind} {value} is not finite"));
                }
                let feature = self.read_feature(feature)?;
                match kind {
                    "weight" => self.features.set(feature, value),
                    _ => self.features.set_drift(feature, value),
                }
            }
            _ => return Err(format!("no line of a model begins with {:?}", fields.first())),
        }
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

    /// Words, constants and the template's place, as a model file has them.
    fn entry_text(&self, id: EntryId) -> String {
        let entry = self.lexicon.entry(id);
        let lexeme = self.lexicon.lexeme(entry.lexeme);
        let constants: Vec<String> = lexeme.constants.iter().map(|&c| self.constant(c)).collect();
        let place = self.lexicon.template_place(entry.template);
        format!("{}\t{}\t{place}", lexeme.words.join(" "), constants.join(" "))
    }

    /// A feature as a model file has it.
    fn feature_text(&self, feature: Feature) -> String {
        match feature {
            Feature::Lexeme(id) => {
                let lexeme = self.lexicon.lexeme(id);
                let constants: Vec<String> =
                    lexeme.constants.iter().map(|&c| self.constant(c)).collect();
                format!("lexeme\t{}\t{}", lexeme.words.join(" "), constants.join(" "))
            }
            Feature::Template(id) => format!("template\t{}", self.lexicon.template_place(id)),
            Feature::Entry(id) => format!("entry\t{}", self.entry_text(id)),
            Feature::Rule(rule) => format!("rule\t{}", rule.name()),
            Feature::Skip => "skip".to_owned(),
            Feature::Pair(a, b) => format!("pair\t{}\t{}", self.constant(a), self.constant(b)),
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
            ["template", place] => {
                let place = place.parse().map_err(|_| format!("{place:?} is no number"))?;
                Feature::Template(
                    self.lexicon
                        .template_at(place)
                        .ok_or(format!("there is no template {place}"))?,
                )
            }
            ["entry", words, constants, template] => {
                Feature::Entry(self.read_entry(words, constants, template, Origin::Candidate)?)
            }
            ["rule", name] => {
                Feature::Rule(RuleId::named(name).ok_or(format!("there is no rule {name:?}"))?)
            }
            ["skip"] => Feature::Skip,
            ["pair", a, b] => Feature::Pair(self.read_constant(a)?, self.read_constant(b)?),
            _ => return Err(format!("there is no feature {:?}", fields.first())),
        })
    }
}
