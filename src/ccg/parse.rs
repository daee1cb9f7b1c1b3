//! Parsing a command with a model: its distinct readings, ranked; when there is no full parse, the parse that
//! skips words or throws meanings away, and says which; when there is no single answer, why. No reading is silent about a
//! closed word: what can be read only without one is no answer.

use super::absorb::{Leniency, absorbing, absorption, clauses_behind};
use super::antecedent;
use super::category::Category;
use super::chart::{Chart, ChartConfig, Edge, Lexical};
use super::clauses::Clauses;
use super::closed::Kind;
use super::combinator::Grammar;
use super::derivation::Derivation;
use super::fences::Fences;
use super::filling::all_edges;
use super::goals::{Goal, Goals};
use super::hearing::{self, Hearing, taken};
use super::lexicon::{EntryId, boxed};
use super::lookup::lexical_item;
use super::model::Model;
use super::sense::{defeats_itself, makes_sense};
use super::sentence::{is_too_long, words};
use super::syntax::SyntaxId;
use crate::logic::order::{sort_by, sort_by_key};
use crate::logic::{TermId, Terms, TyId, ty};
use indexmap::IndexMap;
use indexmap::map::Entry;
use rustc_hash::FxBuildHasher;
use std::rc::Rc;

/// By how much the reading leads that a sentence was said to mean.
const PREFERENCE: f64 = 1.0;

/// By how much a reading that defeats itself leads where the others are not believed: words would have to mean something else
/// than they mostly do.
const FORCED: f64 = 4.0;

/// Why a command has no single answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it; see `Reason::name`")]
pub enum Reason {
    Empty,
    TooLong,
    UnknownWords,
    NoParse,
    Tie,
    Budget,
    LeftOut,
}

impl Reason {
    /// The name in the command line's contract.
    pub fn name(self) -> &'static str {
        match self {
            Reason::Empty => "empty",
            Reason::TooLong => "too_long",
            Reason::UnknownWords => "unknown_words",
            Reason::NoParse => "no_parse",
            Reason::Tie => "tie",
            Reason::Budget => "budget",
            Reason::LeftOut => "left_out",
        }
    }
}

/// One of the distinct goals that a command may mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// The goal.
    pub form: TermId,
    /// Its score, root features included.
    pub score: f64,
    /// The edge of its best derivation.
    pub edge: u32,
}

/// Everything that came of a command.
#[derive(Clone, Debug)]
pub struct Parse {
    /// The words.
    pub words: Vec<String>,
    /// The distinct readings, best first; ties stand in the order of their printed forms.
    pub readings: Vec<Reading>,
    /// Words that the best reading skips: not empty exactly when the skipping parse answered.
    pub skipped: Vec<String>,
    /// Their places.
    pub left_out: Vec<usize>,
    /// Words that the best reading takes for others, the first and one past the last, with what for: misspelt ones, and
    /// those that the lexicon does not know.
    pub heard: Vec<((usize, usize), String)>,
    /// How its words were heard.
    pub hearing: Hearing,
    /// Why there is no single answer.
    pub reason: Option<Reason>,
    /// Derivations tried, in both passes.
    pub tried: usize,
    /// Whether a reading that defeats itself leads the others by far: that was said, and none of them.
    pub is_forced: bool,
    chart: Chart,
}

impl Parse {
    fn new(words: Vec<String>, readings: Vec<Reading>, chart: Chart) -> Self {
        Parse {
            words,
            readings,
            skipped: Vec::new(),
            left_out: Vec::new(),
            heard: Vec::new(),
            hearing: Hearing::default(),
            reason: None,
            tried: 0,
            is_forced: false,
            chart,
        }
    }

    /// The readings with their ranks: two that share a rank are tied.
    pub fn ranked(&self) -> impl Iterator<Item = (i64, Reading)> {
        self.readings.iter().map(|&reading| (rank(reading.score), reading))
    }

    /// The number of readings that share the best rank.
    pub fn tied(&self) -> usize {
        let best = self.ranked().next().map(|(rank, _)| rank);
        self.ranked().take_while(|&(rank, _)| Some(rank) == best).count()
    }

    /// Whether the chart ran out of its budget: there may be better readings.
    pub fn over_budget(&self) -> bool {
        self.chart.over_budget
    }

    /// The chart that the readings come of.
    pub fn chart(&self) -> &Chart {
        &self.chart
    }

    /// The one best reading, if there is just one.
    pub fn answer(&self) -> Option<Reading> {
        if self.reason.is_none() { self.readings.first().copied() } else { None }
    }

    /// The next attempt at the same command: what it found, and what both have tried.
    fn or_else(self, mut next: Parse) -> Parse {
        next.tried += self.tried;
        next.chart.over_budget |= self.chart.over_budget;
        next
    }

    /// The best derivation of a reading, over [`Parse::words`].
    pub fn derivation(&self, reading: Reading) -> Derivation {
        Derivation::of(&self.chart, reading.edge, &EntryId::from_item)
    }
}

/// Parses a command: without skipping words, then, if there is no full parse, with, unknown words first.
pub fn parse(model: &mut Model, command: &str, config: ChartConfig) -> Parse {
    parse_words(model, words(command), config)
}

/// Parses a command that was taken apart.
pub fn parse_words(model: &mut Model, words: Vec<String>, config: ChartConfig) -> Parse {
    let reason = match words.is_empty() {
        true => Some(Reason::Empty),
        false => is_too_long(&words).then_some(Reason::TooLong),
    };
    if reason.is_some() {
        let chart =
            Chart::fill(&mut model.grammar, &model.features, 0, Vec::new(), all_edges, config);
        return Parse { reason, ..Parse::new(words, Vec::new(), chart) };
    }
    let hearing = Hearing::new(model, &words);
    let Hearing { words: heard, closed, empty } = &hearing;
    let idiom = idiom(model, &hearing);
    let is_whole = idiom.as_ref().is_some_and(|item| item.own == (item.start, item.end));
    let of_idiom = |model: &mut Model, item| fill(model, heard, vec![item], all_edges, config);
    let mut parse = match idiom {
        Some(item) if is_whole => of_idiom(model, item),
        Some(item) => match fill_clauses(model, &hearing, config) {
            parse if parse.readings.is_empty() => of_idiom(model, item),
            parse => parse,
        },
        None => fill_clauses(model, &hearing, config),
    };
    if parse.readings.is_empty() {
        // Beside a closed word what skips words is no answer: better than that is a part of the sentence that skips none.
        let part = pieces(model, &hearing).into_iter().find_map(|piece| {
            let part = fill_piece(model, &hearing, piece, config);
            (!part.readings.is_empty()).then_some(part)
        });
        if let Some(part) = part {
            parse = parse.or_else(part);
        }
    }
    for leniency in [Leniency::Unknown, Leniency::Any] {
        if parse.readings.is_empty() {
            let allow_throwing = leniency == Leniency::Any;
            let config = ChartConfig { allow_throwing, ..config };
            let next = fill_at(model, &hearing, leniency, config);
            parse = parse.or_else(next);
        }
    }
    let is_closed = closed.iter().any(Option::is_some);
    if is_closed && let Some(entry) = model.lexicon.idiom(&boxed(heard)) {
        prefer(&mut parse, model.lexicon.category(entry).meaning);
    }
    if let Some(&best) = parse.readings.first() {
        let left_out = left_out(&model.grammar, &parse.derivation(best), empty);
        // Beside a closed word what is left out may be half of what it speaks of.
        let is_goal = |&(_, thrown): &(usize, Option<TyId>)| thrown == Some(ty::TRUTH);
        if is_closed && !left_out.is_empty() || left_out.iter().any(is_goal) {
            parse.reason = Some(Reason::LeftOut);
        }
        parse.left_out = left_out.into_iter().map(|(at, _)| at).collect();
    } else if parse.chart.over_budget {
        parse.reason = Some(Reason::Budget);
    } else if !heard.iter().all(|word| model.lexicon.knows(word)) && !is_closed {
        parse.reason = Some(Reason::UnknownWords);
    } else if is_closed {
        parse.left_out = (0..words.len()).filter(|&at| closed[at].is_some()).collect();
        parse.reason = Some(Reason::LeftOut);
    } else {
        parse.reason = Some(Reason::NoParse);
    }
    parse.skipped = parse.left_out.iter().map(|&at| words[at].clone()).collect();
    parse.heard = taken_for(model, &parse, &hearing, &words);
    (parse.words, parse.hearing) = (words, hearing);
    parse
}

/// The words that the best reading takes for others: those that are spelt otherwise, and those of a leaf whose entry is
/// another word's.
fn taken_for(
    model: &Model,
    parse: &Parse,
    hearing: &Hearing,
    words: &[String],
) -> Vec<((usize, usize), String)> {
    let Some(&best) = parse.readings.first() else { return Vec::new() };
    let mut found = Vec::new();
    for leaf in parse.derivation(best).leaves() {
        let Derivation::Leaf { own: (start, end), entry, .. } = *leaf else { continue };
        let spelt = (start..end).filter(|&at| words[at] != hearing.words[at]);
        found.extend(spelt.map(|at| ((at, at + 1), hearing.words[at].clone())));
        let taken = taken(model, &hearing.words[start..end], entry);
        found.extend(taken.map(|(name, _)| ((start, end), name)));
    }
    found
}

/// The places of the words that a reading leaves out, in order: those that are skipped, and those whose meaning is
/// thrown away, with the type of what is.
fn left_out(
    grammar: &Grammar,
    derivation: &Derivation,
    empty: &[Option<EntryId>],
) -> Vec<(usize, Option<TyId>)> {
    let thrown = derivation.thrown(grammar).into_iter();
    let thrown = thrown.map(|(at, what)| (at, Some(grammar.terms.ty(what.meaning))));
    let skipped = derivation.absorbed().into_iter().filter(|&at| empty[at].is_none());
    let mut left_out: Vec<_> = skipped.map(|at| (at, None)).chain(thrown).collect();
    sort_by_key(&mut left_out, |&one| one);
    left_out.dedup_by_key(|(at, _)| *at);
    left_out
}

/// The idiom that a sentence is, as an entry for all of it.
fn idiom(model: &Model, hearing: &Hearing) -> Option<Lexical> {
    let is_closed = hearing.closed.iter().any(Option::is_some);
    let (own, entry) = hearing::idiom(model, &hearing.words).filter(|_| !is_closed)?;
    Some(Lexical { own, ..lexical_item(model, entry, 0, hearing.words.len()) })
}

/// Puts the reading first that a sentence with closed words was said to mean. It is one of its own: no closed word gets
/// another meaning by that.
fn prefer(parse: &mut Parse, form: TermId) {
    let Some(place) = parse.readings.iter().position(|reading| reading.form == form) else {
        return;
    };
    let best = parse.readings.first().map_or(0.0, |best| best.score);
    let chosen = Reading { score: best + PREFERENCE, ..parse.readings.remove(place) };
    parse.readings.insert(0, chosen);
    if parse.reason == Some(Reason::Tie) {
        parse.reason = None;
    }
}

/// The stretches of a sentence without closed words, the last one first: a part of it that could be done. Behind a word
/// that turns round stands what is denied, or before it where nothing is said behind; but not what another verb begins.
fn pieces(model: &Model, hearing: &Hearing) -> Vec<(usize, usize)> {
    let Hearing { words, closed, .. } = hearing;
    let turn = closed.iter().position(|&kind| kind == Some(Kind::Turns));
    let says = |start: usize, end: usize| {
        words[start..end].iter().any(|word| model.lexicon.has_content(word))
    };
    let denies_before = turn.is_some_and(|turn| !says(turn + 1, words.len()));
    if closed.iter().all(Option::is_none) || denies_before {
        return Vec::new();
    }
    let end = turn.unwrap_or(closed.len());
    let rest = |start: usize| {
        let between = turn.and_then(|turn| closed.get(turn + 1..start)).unwrap_or_default();
        let turned = between.contains(&Some(Kind::Turns));
        (!turned && closed[start..].iter().all(Option::is_none)).then_some((start, words.len()))
    };
    let clauses = clauses_behind(model, words, closed).into_iter();
    let bounds = (0..end).filter(|&at| closed[at].is_some()).chain([end]);
    let mut pieces = Vec::new();
    let mut start = 0;
    for end in bounds {
        if start < end && says(start, end) {
            pieces.push((start, end));
        }
        start = end + 1;
    }
    pieces.extend(clauses.filter_map(rest));
    pieces.reverse();
    pieces
}

/// What a stretch of the sentence alone would mean.
fn fill_piece(
    model: &mut Model,
    hearing: &Hearing,
    (start, end): (usize, usize),
    config: ChartConfig,
) -> Parse {
    let Hearing { words, empty, .. } = hearing;
    let mut costs = absorption(model, words, empty, Leniency::Learned);
    let skipping = |at: usize| model.value(&model.absorption_features(&words[at], empty[at]));
    let outside = (0..words.len()).filter(|at| !(start..end).contains(at));
    outside.for_each(|at| costs[at] = Some(skipping(at)));
    let mut items = antecedent::items(model, hearing);
    items.retain(|item| start <= item.start && item.end <= end);
    fill_within(model, hearing, absorbing(items, &costs), config)
}

/// Reads a sentence clause by clause, if it has several; as a whole where that comes to nothing.
fn fill_clauses(model: &mut Model, hearing: &Hearing, config: ChartConfig) -> Parse {
    // What is said of time may be said of all clauses together.
    let clauses = if hearing.is_in_time(model) { Clauses::ONE } else { hearing.clauses(model) };
    let by_clause = ChartConfig { clauses, ..config };
    let parse = fill_at(model, hearing, Leniency::Learned, by_clause);
    if parse.readings.is_empty() && clauses != Clauses::ONE {
        return parse.or_else(fill_at(model, hearing, Leniency::Learned, config));
    }
    parse
}

fn fill_at(model: &mut Model, hearing: &Hearing, leniency: Leniency, config: ChartConfig) -> Parse {
    let costs = absorption(model, &hearing.words, &hearing.empty, leniency);
    let items = absorbing(antecedent::items(model, hearing), &costs);
    fill_within(model, hearing, items, config)
}

/// Parses from these items within the fences of the sentence.
fn fill_within(
    model: &mut Model,
    hearing: &Hearing,
    mut items: Vec<Lexical>,
    config: ChartConfig,
) -> Parse {
    let context = hearing.context(model);
    items.retain(|item| context.may_absorb(&model.grammar.syntaxes, item));
    let fences = Fences::new(&context);
    let admit = |grammar: &Grammar, span: (usize, usize), category: Category| {
        fences.admit(&grammar.syntaxes, span, category.syntax)
    };
    fill(model, &hearing.words, items, admit, config)
}

/// Parses words from given lexical items, whose `item` is an entry's number, without the edges that `admit`
/// refuses; no skipping.
pub fn fill(
    model: &mut Model,
    words: &[String],
    lexical: Vec<Lexical>,
    admit: impl FnMut(&Grammar, (usize, usize), Category) -> bool,
    config: ChartConfig,
) -> Parse {
    let mut goals = Goals::default();
    let parse = fill_knowing(model, &mut goals, words, lexical, admit, config);
    let is_forced = is_forced(model, &mut goals, &parse.chart, &parse.readings);
    Parse { is_forced, ..parse }
}

/// The same for whoever keeps what is known of goals, and does not ask whether a reading is forced.
pub fn fill_knowing(
    model: &mut Model,
    goals: &mut Goals,
    words: &[String],
    lexical: Vec<Lexical>,
    admit: impl FnMut(&Grammar, (usize, usize), Category) -> bool,
    config: ChartConfig,
) -> Parse {
    let Model { grammar, features, .. } = model;
    let chart = Chart::fill(grammar, features, words.len(), lexical, admit, config);
    let readings = readings(model, goals, &chart);
    let tried = chart.tried;
    let mut parse = Parse { tried, ..Parse::new(words.to_vec(), readings, chart) };
    if parse.tied() > 1 {
        parse.reason = Some(Reason::Tie);
    }
    parse
}

/// The distinct goals among a chart's roots, ranked.
fn readings(model: &mut Model, goals: &mut Goals, chart: &Chart) -> Vec<Reading> {
    let Model { grammar, features, .. } = model;
    let roots =
        chart.roots().filter(|&root| is_goal(grammar, chart.edge(root))).collect::<Vec<_>>();
    let found = roots.into_iter().map(|edge| {
        let Edge { category, score, .. } = *chart.edge(edge);
        let goal = goals.get(grammar, category.meaning);
        (goal.scored(features, score), goal, edge)
    });
    let found: Vec<_> = found.collect();
    ranked(&model.grammar.terms, found)
}

/// Whether the best of a chart's roots that defeat themselves leads all readings by far. It is of the best reading's kind, and
/// silent about no more than that one.
fn is_forced(model: &mut Model, goals: &mut Goals, chart: &Chart, readings: &[Reading]) -> bool {
    let Model { grammar, features, .. } = model;
    let Some(best) = readings.first() else { return false };
    let kind = chart.edge(best.edge).category.syntax;
    let is_void = |&root: &u32| {
        let Edge { category, .. } = *chart.edge(root);
        category.syntax == kind
            && is_sentence(grammar, chart.edge(root))
            && defeats_itself(&grammar.terms, &grammar.sorts, category.meaning)
    };
    let Some(void) = chart.roots().find(is_void) else { return false };
    let Edge { category, score, .. } = *chart.edge(void);
    let goal = goals.get(grammar, category.meaning);
    let silent = |edge| Derivation::of(chart, edge, &EntryId::from_item).absorbed().len();
    goal.scored(features, score) > best.score + FORCED && silent(void) <= silent(best.edge)
}

/// Whether an edge over a whole sentence means a goal, or a task over time: a command that was made a clause of one is no more
/// than a command.
fn is_sentence(grammar: &Grammar, edge: &Edge) -> bool {
    let Category { syntax, meaning } = edge.category;
    match syntax {
        SyntaxId::T => !edge.made.is_shifted(),
        _ => syntax.is_sentence() && matches!(grammar.terms.ty(meaning), ty::TRUTH | ty::RUN),
    }
}

/// Whether an edge over a whole sentence means what somebody could mean.
pub fn is_goal(grammar: &Grammar, edge: &Edge) -> bool {
    is_sentence(grammar, edge) && makes_sense(&grammar.terms, &grammar.sorts, edge.category.meaning)
}

/// Goals with their scores and edges, ranked. Goals that differ in the order of the arguments of a commutative relation
/// are one, printed as the better derivation has it.
pub(super) fn ranked(
    terms: &Terms,
    found: impl IntoIterator<Item = (f64, Rc<Goal>, u32)>,
) -> Vec<Reading> {
    type Found = (f64, Rc<Goal>, u32);
    let order = |a: &Found, b: &Found| {
        rank(b.0).cmp(&rank(a.0)).then_with(|| a.1.printed(terms).cmp(b.1.printed(terms)))
    };
    let mut best: IndexMap<TermId, Found, FxBuildHasher> = IndexMap::default();
    for new in found {
        match best.entry(new.1.key) {
            Entry::Vacant(place) => drop(place.insert(new)),
            Entry::Occupied(mut known) if order(&new, known.get()).is_lt() => {
                drop(known.insert(new))
            }
            Entry::Occupied(_) => {}
        }
    }
    let mut all: Vec<Found> = best.into_values().collect();
    sort_by(&mut all, order);
    all.into_iter().map(|(score, goal, edge)| Reading { form: goal.form, score, edge }).collect()
}

/// Scores that differ by less than a billionth are the same: sums run in the order of the derivation.
pub(super) fn rank(score: f64) -> i64 {
    (score * 1e9).round() as i64
}
