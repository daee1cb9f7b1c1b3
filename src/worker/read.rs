//! A parse taken apart for the page: words, readings with their pieces, phrases and cells, and for those who study
//! them scores and reductions.

use super::protocol::{Fate, Node, Phrase, Piece, Reading, Referent, Refers, Study, Taken, Word};
use crate::ccg::{
    self, ChartConfig, Derivation, Explanation, Hearing, Model, Parse, Reason, Trace, Traced,
    alike, composed_words, parse_words,
};
use crate::domain::{Bounds, Color, Shape, State};
use crate::ground::{self, Class, Course, Entity, Failure, Goal, Thing, claim, noun, phrases};
use crate::logic::ty::{RUN, TRUTH};
use crate::logic::{TermId, Terms, print, print_human, steps};

/// Readings that an answer shows, unless more are tied for best.
const MAX_READINGS: usize = 10;

/// Known words that are offered for an unknown one.
const MAX_NEAR: usize = 3;

/// Parses what was typed; whatever comes from the page is in NFC (`agent`).
pub(super) fn parsed(model: &mut Model, command: &str) -> Parse {
    let config = ChartConfig::of(model);
    parse_words(model, composed_words(command), config)
}

/// The readings that an answer shows.
pub(super) fn shown(parse: &Parse) -> impl Iterator<Item = ccg::Reading> {
    parse.readings.iter().take(MAX_READINGS.max(parse.tied())).copied()
}

/// The words of a parse, and what became of each in the best reading; in a state, known words in place of unknown ones
/// are of that.
pub(super) fn words(model: &Model, parse: &Parse, state: Option<&State>) -> Vec<Word> {
    let best = parse.readings.first().map(|&reading| parse.derivation(reading));
    let absorbed = best.map(|derivation| derivation.absorbed());
    let Hearing { words: spelt, closed, .. } = Hearing::new(model, &parse.words);
    let word = |(at, (text, spelt)): (usize, (&String, &String))| {
        let heard = (spelt != text).then(|| spelt.clone());
        let is_out = parse.left_out.contains(&at);
        let fate = match &absorbed {
            Some(absorbed) if !is_out && absorbed.contains(&at) => Fate::Empty,
            Some(_) if !is_out => Fate::Meant,
            _ if closed[at].is_none() && !model.lexicon.knows(spelt) => Fate::Unknown,
            None if !is_out => Fate::Idle,
            _ => Fate::Skipped,
        };
        let near = match fate {
            Fate::Unknown => {
                let near = alike(&model.lexicon, text).into_iter();
                let is_known = |word: &str| state.is_none_or(|state| is_here(model, word, state));
                near.filter(|words| words.split(' ').all(is_known)).take(MAX_NEAR).collect()
            }
            _ => Vec::new(),
        };
        Word { text: text.clone(), heard, fate, closed: closed[at], near }
    };
    let mut words: Vec<Word> = parse.words.iter().zip(&spelt).enumerate().map(word).collect();
    if parse.reason == Some(Reason::LeftOut) && absorbed.is_some() {
        // What means nothing beside words that are left out was left out with them.
        let is_out = |word: &Word| !matches!(word.fate, Fate::Meant);
        for run in words.chunk_by_mut(|a, b| is_out(a) == is_out(b)) {
            if run.iter().any(|word| word.fate == Fate::Skipped) {
                let beside = run.iter_mut().filter(|word| word.fate == Fate::Empty);
                beside.for_each(|word| word.fate = Fate::Skipped);
            }
        }
    }
    words
}

/// Whether a word that names a colour or a shape names one of the world's.
fn is_here(model: &Model, word: &str, state: &State) -> bool {
    let lexicon = &model.lexicon;
    let entries = lexicon.entries_for_word(word).iter();
    let constants = entries.flat_map(|&id| &lexicon.lexeme(lexicon.entry(id).lexeme).constants);
    let mut names = constants.map(|&constant| model.grammar.terms.name(constant));
    names.all(|name| match (name.parse::<Color>(), name.parse::<Shape>()) {
        (Ok(color), _) => Thing::all(state).iter().any(|thing| thing.color() == Some(color)),
        (_, Ok(shape)) => state.objects.iter().any(|object| object.shape == shape),
        _ => true,
    })
}

/// The words that the best reading takes for others, but for misspelt ones and shades, which are told apart.
pub(super) fn taken(parse: &Parse) -> Vec<Taken> {
    let told = |((start, end), name): &((usize, usize), String)| {
        let own = parse.hearing.words.get(*start..*end).unwrap_or_default();
        (own.join(" ") != *name).then(|| Taken { words: (*start, *end), name: name.clone() })
    };
    parse.heard.iter().filter_map(told).collect()
}

/// A reading with all that a page can point at.
pub(super) fn reading(
    model: &mut Model,
    parse: &Parse,
    reading: ccg::Reading,
    state: &State,
) -> Reading {
    let derivation = parse.derivation(reading);
    let trace = Trace::of(model, &derivation).ok();
    let nodes = trace.as_ref().map(|trace| nodes(model, trace)).unwrap_or_default();
    // What the root says, since the goal is its meaning; a task over time is what its root asks for by itself.
    let is_root = model.grammar.terms.ty(reading.form) == TRUTH;
    let formula = nodes.last().filter(|_| is_root).map(|root| root.meaning.clone());
    let phrases = said(model, trace.as_ref(), reading.form, state);
    let terms = &model.grammar.terms;
    let plain = || vec![Piece { text: print_human(terms, reading.form), words: None }];
    Reading {
        form: print(terms, reading.form),
        formula: formula.unwrap_or_else(plain),
        claim: claim(terms, reading.form),
        score: Explanation::of(model, parse, reading).score,
        nodes,
        derivation: derivation.print(model, &parse.words),
        phrases,
        cells: Goal::new(terms, reading.form, state).map_or(Vec::new(), |goal| goal.cells(state)),
        forbidden: forbidden(terms, reading.form, state),
    }
}

/// A task that nobody said in these words, as a reading.
pub(super) fn plain(terms: &Terms, task: TermId, state: &State) -> Reading {
    let things = Thing::all(state);
    let found = phrases(terms, task, state).unwrap_or_default().into_iter();
    Reading {
        form: print(terms, task),
        formula: vec![Piece { text: print_human(terms, task), words: None }],
        claim: claim(terms, task),
        score: 0.0,
        nodes: Vec::new(),
        derivation: String::new(),
        phrases: found.map(|phrase| said_as(terms, &things, phrase, Vec::new())).collect(),
        cells: Vec::new(),
        forbidden: forbidden(terms, task, state),
    }
}

/// Where the robot may not stand on the way of a task over time.
fn forbidden(terms: &Terms, task: TermId, state: &State) -> Vec<(i32, i32)> {
    match terms.ty(task) {
        RUN => Course::new(terms, task, state)
            .map_or(Vec::new(), |course| course.forbidden(terms, state)),
        _ => Vec::new(),
    }
}

fn nodes(model: &mut Model, trace: &Trace) -> Vec<Node> {
    let node = |node: &Traced| {
        let piece = |(text, words)| Piece { text, words };
        let pieces = trace.pieces(node, &mut model.grammar.terms);
        Node {
            words: node.words,
            rule: node.rule.map_or("", |rule| model.grammar.rule_name(rule)).to_owned(),
            category: model.grammar.syntaxes.text(node.category.syntax).to_owned(),
            meaning: pieces.into_iter().map(piece).collect(),
            parts: node.parts.clone(),
        }
    };
    trace.nodes.iter().map(node).collect()
}

/// The phrases of a goal in a state.
fn said(model: &mut Model, trace: Option<&Trace>, goal: TermId, state: &State) -> Vec<Phrase> {
    let found = phrases(&model.grammar.terms, goal, state).unwrap_or_default();
    let things = Thing::all(state);
    let said = |phrase: ground::Phrase| {
        let words = trace.map(|trace| trace.words_of(phrase.term, &mut model.grammar.terms));
        said_as(&model.grammar.terms, &things, phrase, words.unwrap_or_default())
    };
    found.into_iter().map(said).collect()
}

/// A phrase that these words carried, with what it refers to.
fn said_as(
    terms: &Terms,
    things: &[Thing<'_>],
    phrase: ground::Phrase,
    words: Vec<usize>,
) -> Phrase {
    let (refers, entities) = match phrase.referent {
        Ok(entity) => (Refers::One, vec![entity]),
        Err(Failure::None) => (Refers::None, Vec::new()),
        Err(Failure::Several(which)) => (Refers::Several, which),
        Err(Failure::Tie(which)) => (Refers::Tie, which),
        Err(Failure::Single(only)) => (Refers::Single, vec![only]),
        Err(Failure::Mixed(which)) => (Refers::Mixed, which),
        Err(Failure::Inner) => (Refers::Inner, Vec::new()),
    };
    let thing = |entity: &Entity| things.iter().find(|thing| thing.is(entity));
    Phrase {
        noun: noun(terms, phrase.term),
        words,
        refers,
        taken: phrase.taken,
        referents: entities.iter().filter_map(thing).map(|&thing| referent(thing)).collect(),
    }
}

fn referent(thing: Thing<'_>) -> Referent {
    let within = |bounds: Bounds, inner: bool| {
        let cells = bounds.cells();
        cells.filter(|&(x, y)| !inner || bounds.strictly_inside(x, y)).collect::<Vec<_>>()
    };
    let (class, cells) = match thing {
        Thing::Agent { x, y } => (Class::Agent, vec![(x, y)]),
        Thing::Room(room) => (Class::Room, within(room.bounds, true)),
        Thing::Door(door) => (Class::Door, within(door.bounds, false)),
        Thing::Object(object) => (Class::Object, vec![(object.x, object.y)]),
    };
    let size = match thing {
        Thing::Object(object) => object.size,
        _ => None,
    };
    let class = class.name().to_owned();
    Referent { class, color: thing.color(), shape: thing.shape(), size, cells }
}

/// The readings that an answer shows, for those who study them.
pub(super) fn studies(model: &mut Model, command: &str) -> Vec<Study> {
    let parse = parsed(model, command);
    let study = |reading| Study {
        explanation: Explanation::of(model, &parse, reading),
        reductions: reductions(model, &parse.derivation(reading)),
    };
    shown(&parse).map(study).collect()
}

/// How the meaning of each node of a derivation came about, parts before what was made of them.
fn reductions(model: &Model, derivation: &Derivation) -> Vec<Vec<String>> {
    let Derivation::Node { rule, children, category } = derivation else {
        return vec![vec![print_human(&model.grammar.terms, derivation.category().meaning)]];
    };
    let mut all: Vec<Vec<String>> =
        children.iter().flat_map(|child| reductions(model, child)).collect();
    let parts: Vec<TermId> = children.iter().map(|child| child.category().meaning).collect();
    let mut lines = model.grammar.written(*rule, &parts).map(steps).unwrap_or_default();
    // Conjuncts have an order of their own, and each stands once.
    let meaning = print_human(&model.grammar.terms, category.meaning);
    if lines.last() != Some(&meaning) {
        lines.push(meaning);
    }
    all.push(lines);
    all
}
