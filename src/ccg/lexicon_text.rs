//! The text form of a seed lexicon, which a person can read and change. A line is `words | words :- SYNTAX : meaning`;
//! `(this|that) way` is short for `this way | that way`, and `very (big|) room` for `very big room | very room`;
//! `*` in place of words gives a template that learned words may fill: `?`, `?noun` and `?adjective` are its holes;
//! `frame` and `commutative` lines name constants; `shift FROM=>TO : meaning` lines are type shifts; `#` begins a comment.

use super::alternatives::alternatives;
use super::category::Category;
use super::closed::{Kind, closed};
use super::features::Feature;
use super::lexicon::{Hole, Origin, boxed};
use super::model::Model;
use super::sentence::words;
use super::syntax::SyntaxId;
use crate::logic::{ConstantId, read};

/// The weight of a seed lexeme, and of a seed entry for each of its words (see [`seed_weight`]). The reference has 10,
/// for another update of the weights: what counts is how far one step goes against it.
pub const SEED: f64 = 3.0;
/// The weight of a word that is skipped.
const SKIP: f64 = -1.0;
/// The weight of a word that is dropped although it has a meaning: what is said is meant.
const DROP: f64 = -3.0;
/// The weight of a predicate that a step leaves out.
const LOSS: f64 = -1.5;
/// The weight with which learning begins for two commands side by side: most commands are one.
const BESIDE: f64 = -6.0;
/// The same for two commands of which nothing says that one comes after the other: most are about one end.
const SEQUENCE: f64 = -12.0;
/// What it costs that "and" says what comes after.
const JOINED: f64 = -6.0;

/// What is wrong with a lexicon's text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {reason}")]
pub struct LexiconError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub reason: String,
}

/// Reads a seed lexicon into a model, with weights after the reference's: a lexeme 1, an entry words^1.1, each times
/// [`SEED`]; what is said and left out costs what `SKIP`, `DROP` and `LOSS` say.
///
/// # Errors
/// With the line and what is wrong there.
pub fn read_lexicon(model: &mut Model, text: &str) -> Result<(), LexiconError> {
    for (line, content) in (1..).zip(text.lines()) {
        let content = content.split('#').next().unwrap_or("").trim();
        if !content.is_empty() {
            read_line(model, content).map_err(|reason| LexiconError { line, reason })?;
        }
    }
    model.features.set(Feature::Skip, SKIP);
    model.features.set(Feature::Dropped, DROP);
    model.features.set(Feature::Lost, LOSS);
    for (name, weight) in [("&", BESIDE), (";", SEQUENCE), ("!", BESIDE), ("!>", BESIDE)] {
        if let Some(beside) = model.grammar.rule_named(name) {
            model.features.set(Feature::Rule(beside), weight);
        }
    }
    Ok(())
}

fn read_line(model: &mut Model, line: &str) -> Result<(), String> {
    let Some((phrase, category)) = line.split_once(":-") else {
        return read_directive(model, line);
    };
    read_words(model, phrase, category)
}

/// A line that is not about words.
fn read_directive(model: &mut Model, line: &str) -> Result<(), String> {
    if let Some(constant) = line.strip_prefix("frame ") {
        let constant = model.read_constant(constant.trim())?;
        model.lexicon.frame.push(constant);
        return Ok(());
    }
    if let Some(constant) = line.strip_prefix("commutative ") {
        let constant = model.read_constant(constant.trim())?;
        model.grammar.commutative.push(constant);
        return Ok(());
    }
    if let Some(shift) = line.strip_prefix("shift ") {
        let (name, meaning) =
            shift.split_once(" : ").ok_or("between a shift's name and meaning stands a colon")?;
        return model.read_shift(name.trim(), meaning.trim());
    }
    Err("a line is words :- CATEGORY : meaning".to_owned())
}

fn read_words(model: &mut Model, phrase: &str, category: &str) -> Result<(), String> {
    let (syntax, meaning) =
        category.split_once(" : ").ok_or("between category and meaning stands a colon")?;
    let syntax_id = model.grammar.syntaxes.read(syntax.trim());
    let syntax = syntax_id.ok_or(format!("{:?} is no syntactic category", syntax.trim()))?;
    let meaning = read(&mut model.grammar.terms, meaning.trim()).map_err(|e| e.to_string())?;
    model.check_constants(meaning)?;
    let category = Category { syntax, meaning };
    if phrase.trim() == "*" {
        let factored =
            super::factor::factor(&mut model.grammar.terms, meaning, &model.lexicon.frame)
                .map_err(|e| e.to_string())?;
        let hole = |&c: &ConstantId| Hole::of(model.grammar.terms.name(c), c);
        let holes: Box<[Hole]> = factored.constants.iter().map(hole).collect();
        let template = model.lexicon.add_template(syntax, factored.template, holes.len());
        model.lexicon.open.insert(template, holes);
        return Ok(());
    }
    let phrases = alternatives(phrase)?;
    phrases.iter().try_for_each(|phrase| add_entry(model, phrase, category))
}

fn add_entry(model: &mut Model, phrase: &str, category: Category) -> Result<(), String> {
    let words = words(phrase);
    if words.is_empty() {
        return Err("there are no words before :-".to_owned());
    }
    let n_words = words.len();
    let own = boxed(&words);
    let entry = model
        .lexicon
        .add_category(&mut model.grammar, own, category, Origin::Seed)
        .map_err(|e| e.to_string())?;
    // That a word may mean nothing is no reason to think so: where it also has a meaning, the meaning goes before.
    if category.syntax != SyntaxId::EMPTY {
        let lexeme = model.lexicon.entry(entry).lexeme;
        let is_joint = closed(words.as_slice()).iter().all(|&kind| kind == Some(Kind::Joins));
        let is_of_time = model.grammar.syntaxes.is_in_time(category.syntax);
        let price = if is_joint && is_of_time { JOINED } else { 0.0 };
        model.features.set(Feature::Lexeme(lexeme), seed_weight(n_words));
        model.features.set(Feature::Entry(entry), seed_weight(n_words) + price);
    }
    Ok(())
}

/// The weight of a seed entry of so many words.
pub fn seed_weight(n_words: usize) -> f64 {
    SEED * libm::pow(n_words as f64, 1.1)
}
