//! What came of a lesson besides weights: whether what a command would do now ends where things were put, which other
//! readings would, what was added in plain words, and phrases taught by saying them in other words. Where these describe a
//! thing, the phrase is its name; where they are a command, it is an idiom of the model: a whole sentence with a goal. A
//! closed word gets no new meaning by it (`ccg::closed`).

use super::protocol::{Check, Fit, Lesson, Meaning, Refusal, Told, What};
use crate::ccg::{
    Atom, Category, ChartConfig, Derivation, EntryId, Model, Origin, Parse, SyntaxId, closed,
    parse_words, words,
};
use crate::corpus::{Example, Pair};
use crate::domain::State;
use crate::domain::straight::region;
use crate::ground::{Goal, Validator, claim, noun};
use crate::logic::{TermId, print, read, ty};

/// Readings of a lesson that are looked at.
const MOST_READINGS: usize = 30;
/// Readings that are offered.
const MOST_FITS: usize = 3;

/// What comes before a description to make a command of it.
const GO_TO: &str = "go to the ";

/// Gives a lesson's command the meaning that the person chose or said in other words; the entry of a name that was given.
///
/// # Errors
/// Why it cannot have it.
pub(super) fn mean(model: &mut Model, lesson: &Lesson) -> Result<Option<EntryId>, Refusal> {
    let Some(means) = &lesson.means else { return Ok(None) };
    let said = words(&lesson.command);
    if bare(&said).is_empty() {
        return Err(Refusal::Known);
    }
    let own = parsed(model, &lesson.command);
    let goal = match means {
        Meaning::Form(form) => read(&mut model.grammar.terms, form).map_err(|_| Refusal::Lost)?,
        Meaning::Words(other) => {
            if is_understood(&own) {
                return Err(Refusal::Known);
            }
            if let Some(thing) = described(model, other) {
                return name(model, bare(&said), thing).map(Some);
            }
            let other = parsed(model, other);
            let goal = other.answer().filter(|_| other.left_out.is_empty());
            goal.ok_or(Refusal::Lost)?.form
        }
    };
    let is_own = own.readings.iter().any(|reading| reading.form == goal);
    let closed = closed(&said).iter().position(Option::is_some).filter(|_| !is_own);
    if let Some(word) = closed.and_then(|at| said.get(at)) {
        return Err(Refusal::Closed(word.clone()));
    }
    model.add_idiom(&said, goal).map_err(|_| Refusal::Lost)?;
    Ok(None)
}

/// Gives a thing a name.
fn name(model: &mut Model, said: &[String], thing: Category) -> Result<EntryId, Refusal> {
    let closed = closed(said).iter().position(Option::is_some);
    match closed.and_then(|at| said.get(at)) {
        Some(word) => Err(Refusal::Closed(word.clone())),
        None => model.add_name(said, thing).map_err(|_| Refusal::Lost),
    }
}

/// The noun that words are, with an article or without, if they are one.
fn described(model: &mut Model, other: &str) -> Option<Category> {
    let said = words(other);
    let noun = bare(&said);
    let parse = parsed(model, &format!("{GO_TO}{}", noun.join(" ")));
    let derivation = parse.derivation(parse.answer().filter(|_| is_understood(&parse))?);
    let before = words(GO_TO).len();
    noun_at(model, &derivation, (before, before + noun.len()))
}

/// The noun that spans these words in a derivation.
fn noun_at(model: &Model, derivation: &Derivation, span: (usize, usize)) -> Option<Category> {
    let category = derivation.category();
    if derivation.span() == span && is_noun(model, category.syntax) {
        return Some(category);
    }
    let Derivation::Node { children, .. } = derivation else { return None };
    children.iter().find_map(|child| noun_at(model, child, span))
}

/// Words without the article that they may begin with.
fn bare(words: &[String]) -> &[String] {
    match words {
        [article, rest @ ..] if ["the", "a", "an"].contains(&&**article) => rest,
        all => all,
    }
}

/// Whether a command has one answer, and nothing of it is left out.
fn is_understood(parse: &Parse) -> bool {
    parse.answer().is_some() && parse.left_out.is_empty()
}

/// Whether the one answer to a lesson's command is what it says that it means.
pub(super) fn is_meant(model: &mut Model, lesson: &Lesson) -> bool {
    let mut answer = |command: &str| {
        let answer = parsed(model, command).answer();
        answer.map(|answer| print(&model.grammar.terms, answer.form))
    };
    let is_same = |one: Option<String>, other| one.is_some() && one == other;
    match &lesson.means {
        Some(Meaning::Form(form)) => answer(&lesson.command).as_ref() == Some(form),
        Some(Meaning::Words(other)) => {
            let to = |said: &str| format!("{GO_TO}{}", bare(&words(said)).join(" "));
            is_same(answer(&lesson.command), answer(other))
                || is_same(answer(&to(&lesson.command)), answer(&to(other)))
        }
        None => false,
    }
}

/// Whether what a lesson's command means now accounts for all that was shown, and which readings would.
pub(super) fn check(model: &mut Model, lesson: &Example) -> Check {
    let parse = parsed(model, &lesson.command);
    let mut validator = Validator::new();
    let shown = |pair: &Pair| validator.shown(&pair.pre, &pair.post, pair.way.as_deref());
    let pairs: Vec<_> = lesson.pairs.iter().map(shown).collect();
    let terms = &model.grammar.terms;
    let mut fits = |form: TermId| {
        validator.valid(terms, form, &pairs)
            && lesson.pairs.iter().all(|pair| accounts(model, form, pair))
    };
    let ends = parse.answer().is_some_and(|answer| fits(answer.form));
    let readings = parse.readings.iter().take(MOST_READINGS).filter(|_| !ends);
    let fitting = readings.filter(|reading| fits(reading.form)).take(MOST_FITS);
    let fit = |form: TermId| Fit { form: print(terms, form), claim: claim(terms, form) };
    Check { ends, fits: fitting.map(|reading| fit(reading.form)).collect() }
}

/// Whether a goal has to do with everything that was moved: put back to where it was, the goal would not hold. A robot
/// that stands beside what it moved is there for that. Of a task over time the whole run was asked.
fn accounts(model: &Model, form: TermId, Pair { pre, post, .. }: &Pair) -> bool {
    if model.grammar.terms.ty(form) == ty::RUN {
        return true;
    }
    let Ok(goal) = Goal::new(&model.grammar.terms, form, pre) else { return false };
    let mut moved = Vec::new();
    for (at, (was, is)) in pre.objects.iter().zip(&post.objects).enumerate() {
        if region(pre, (was.x, was.y)) == region(post, (is.x, is.y)) {
            continue;
        }
        moved.push((is.x, is.y));
        let mut back = post.clone();
        if let Some(object) = back.objects.get_mut(at) {
            (object.x, object.y) = (was.x, was.y);
        }
        if goal.holds(&back) {
            return false;
        }
    }
    let (was, is) = (&pre.agent, &post.agent);
    let is_beside = |&(x, y): &(i32, i32)| (x - is.x).abs() + (y - is.y).abs() <= 1;
    if region(pre, (was.x, was.y)) == region(post, (is.x, is.y)) || moved.iter().any(is_beside) {
        return true;
    }
    let back = State { agent: *was, ..post.clone() };
    !goal.holds(&back)
}

/// What an entry means, in plain words.
pub(super) fn told(model: &mut Model, id: EntryId) -> Told {
    let category = model.lexicon.category(id);
    let words = model.lexicon.lexeme(model.lexicon.entry(id).lexeme).words.join(" ");
    let what = if model.lexicon.is_empty_entry(id) {
        What::Nothing
    } else if category.syntax.is_sentence() {
        What::Goal(claim(&model.grammar.terms, category.meaning))
    } else if let Some(word) = like(model, id) {
        What::Like(word)
    } else if is_noun(model, category.syntax) {
        let phrase = format!("(the:<<e,t>,e> {})", print(&model.grammar.terms, category.meaning));
        match read(&mut model.grammar.terms, &phrase) {
            Ok(phrase) => What::Thing(noun(&model.grammar.terms, phrase)),
            Err(_) => What::Other,
        }
    } else {
        What::Other
    };
    Told { words, what }
}

fn is_noun(model: &Model, syntax: SyntaxId) -> bool {
    model.grammar.syntaxes.is(syntax, Atom::N)
}

/// A word of the seed that means the same.
fn like(model: &Model, id: EntryId) -> Option<String> {
    let lexicon = &model.lexicon;
    let words = |other: EntryId| &lexicon.lexeme(lexicon.entry(other).lexeme).words;
    let same = |other: &EntryId| {
        lexicon.origin(*other) == Origin::Seed && lexicon.category(*other) == lexicon.category(id)
    };
    let same = lexicon.entries().iter().copied().filter(same);
    same.min_by_key(|&other| words(other).len()).map(|other| words(other).join(" "))
}

fn parsed(model: &mut Model, command: &str) -> Parse {
    let config = ChartConfig::of(model);
    parse_words(model, words(command), config)
}
