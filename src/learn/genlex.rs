//! Coarse lexical generation (Artzi and Zettlemoyer 2013, Section 6): every span of a few words is tried in every
//! template with one placeholder constant a type; what a full parse used is filled in with every constant of the
//! type. What comes out are candidates: only validation makes them entries.

use super::novelty::{Novelty, novelty};
use crate::ccg::absorb::{Leniency, absorbing, absorption, empty_entries};
use crate::ccg::chart::{Chart, ChartConfig, Derivations, Lexical, Step};
use crate::ccg::factor::instantiate;
use crate::ccg::lexicon::{Lexeme, boxed};
use crate::ccg::lookup::lexical_items;
use crate::ccg::parse::is_goal;
use crate::ccg::{Category, EntryId, Grammar, Hole, Model, Origin, SyntaxId, TemplateId, closed};
use crate::logic::{ConstantId, TyId};
use rustc_hash::FxHashSet;
use std::rc::Rc;

/// Words that a generated lexeme may have.
pub const MAX_SPAN: usize = 4;
/// Ways to fill a template's holes that are tried.
const MAX_FILLINGS: usize = 4096;

/// A candidate entry over a span of the sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Candidate {
    /// The first word.
    pub start: usize,
    /// One past the last word.
    pub end: usize,
    /// The entry, no part of the lexicon yet.
    pub entry: EntryId,
}

/// Which spans of a sentence may get new entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Those with a word that the lexicon does not know.
    UnknownWords,
    /// All: a known word may mean something else, too.
    AllWords,
}

/// What new entries may mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// What is so of states.
    States,
    /// What is so of runs, too: that is shown by runs alone.
    Runs,
}

/// What lexical generation found for a sentence.
#[derive(Clone, Debug, Default)]
pub struct Generated {
    /// The candidates.
    pub candidates: Vec<Candidate>,
    /// For every word the entry, or candidate, by which it means nothing.
    pub empty: Vec<Option<EntryId>>,
    /// The syntactic categories that took part in a full coarse parse, by span: no other can lead to one.
    pub useful: Rc<Useful>,
}

/// Spans with syntactic categories.
pub type Useful = FxHashSet<(usize, usize, SyntaxId)>;

/// What the coarse charts of the command at work came to. As long as no weight moves, the same items come to the same.
#[derive(Default)]
pub struct CoarseCharts(Vec<Coarse>);

/// What a coarse chart came to.
struct Coarse {
    items: Vec<Lexical>,
    used: Vec<(usize, usize, TemplateId)>,
    useful: Rc<Useful>,
}

impl CoarseCharts {
    /// Forgets them: weights have moved.
    pub fn forget(&mut self) {
        self.0.clear();
    }
}

/// The candidates for a sentence, as the model stands.
pub fn generate(
    model: &mut Model,
    words: &[String],
    (scope, domain): (Scope, Domain),
    config: ChartConfig,
    charts: &mut CoarseCharts,
) -> Generated {
    let templates = coarse_categories(model, domain);
    let empty = empty_candidates(model, words);
    let items = coarse_items(model, words, scope, &templates, &empty);
    let is_open = items.iter().any(|item| (item.item as usize) < templates.len());
    let is_new = |&id: &EntryId| model.lexicon.is_candidate(id);
    if !is_open && !empty.iter().flatten().any(is_new) {
        return Generated { empty, ..Generated::default() };
    }
    let known = charts.0.iter().position(|known| known.items == items);
    let known = known.unwrap_or_else(|| {
        let chart = coarse_chart(model, words.len(), items.clone(), config);
        let mut useful = Useful::default();
        let used = used_templates(model, &chart, &templates, &mut useful);
        charts.0.push(Coarse { items, used, useful: Rc::new(useful) });
        charts.0.len() - 1
    });
    let Coarse { used, useful, .. } = &charts.0[known];
    let useful = Rc::clone(useful);
    let mut generated = Generated { candidates: Vec::new(), empty, useful };
    for &(start, end, template) in used {
        let novelty = novelty(model, &words[start..end]);
        let words = boxed(&words[start..end]);
        for constants in fillings(model, template) {
            if !novelty.admits(model, &constants) {
                continue;
            }
            let lexeme = Lexeme { words: words.clone(), constants: constants.into() };
            let added = model.lexicon.add(&mut model.grammar, lexeme, template, Origin::Candidate);
            if let Ok(entry) = added
                && model.lexicon.is_candidate(entry)
            {
                generated.candidates.push(Candidate { start, end, entry });
            }
        }
    }
    generated
}

/// For every word the entry by which it means nothing, a candidate where the lexicon has none and it may.
fn empty_candidates(model: &mut Model, words: &[String]) -> Vec<Option<EntryId>> {
    let known = empty_entries(model, words);
    let is_empty = |&id: &TemplateId| model.lexicon.is_empty_template(id);
    let Some(template) = model.lexicon.open.keys().copied().find(is_empty) else { return known };
    let mut candidates = Vec::with_capacity(words.len());
    for ((word, known), closed) in words.iter().zip(known).zip(closed(words)) {
        let novelty = novelty(model, std::slice::from_ref(word));
        let new = known.is_none() && closed.is_none() && novelty.admits_silence();
        candidates.push(if new { add(model, word, template) } else { known });
    }
    candidates
}

fn add(model: &mut Model, word: &str, template: TemplateId) -> Option<EntryId> {
    let lexeme = Lexeme { words: Box::new([Box::from(word)]), constants: Box::new([]) };
    model.lexicon.add(&mut model.grammar, lexeme, template, Origin::Candidate).ok()
}

/// Every template with placeholders in its holes; the empty one is no category.
fn coarse_categories(model: &mut Model, domain: Domain) -> Vec<(TemplateId, Category)> {
    let open = model.lexicon.open.keys().copied();
    let fits = |id: TemplateId| {
        let syntax = model.lexicon.template(id).syntax;
        !model.lexicon.is_empty_template(id)
            && (domain == Domain::Runs || !model.grammar.syntaxes.is_in_time(syntax))
    };
    let ids: Vec<TemplateId> = open.filter(|&id| fits(id)).collect();
    let mut coarse = Vec::with_capacity(ids.len());
    for id in ids {
        let holes = model.lexicon.holes(&model.grammar, id);
        let terms = &mut model.grammar.terms;
        let placeholders: Vec<ConstantId> =
            holes.iter().map(|&ty| terms.constant("?", ty)).collect();
        let template = model.lexicon.template(id);
        if let Ok(meaning) = instantiate(terms, template.meaning, &placeholders) {
            coarse.push((id, Category { syntax: template.syntax, meaning }));
        }
    }
    coarse
}

/// The lexicon's entries and the templates; an item from the number of templates on is an entry.
fn coarse_items(
    model: &mut Model,
    words: &[String],
    scope: Scope,
    templates: &[(TemplateId, Category)],
    empty: &[Option<EntryId>],
) -> Vec<Lexical> {
    let mut items = lexical_items(model, words);
    for item in &mut items {
        item.item += templates.len() as u32;
    }
    let closed = closed(words);
    for start in 0..words.len() {
        for end in start + 1..=(start + MAX_SPAN).min(words.len()) {
            let own = &words[start..end];
            // Nothing that is learned speaks for a closed word.
            if closed[start..end].iter().any(Option::is_some) {
                continue;
            }
            if scope == Scope::UnknownWords && own.iter().all(|word| model.lexicon.knows(word)) {
                continue;
            }
            let novelty = novelty(model, own);
            // What relates things stands between others.
            if novelty == Novelty::Relation && (start == 0 || end == words.len()) {
                continue;
            }
            for (item, &(_, category)) in (0..).zip(templates) {
                if novelty.admits_syntax(model, category.syntax) {
                    let own = (start, end);
                    items.push(Lexical { start, end, own, category, score: 0.0, item });
                }
            }
        }
    }
    let costs = absorption(model, words, empty, Leniency::Learned);
    absorbing(items, &costs)
}

/// A chart with all derivations.
fn coarse_chart(
    model: &mut Model,
    words: usize,
    items: Vec<Lexical>,
    config: ChartConfig,
) -> Chart {
    let Model { grammar, features, .. } = model;
    let config = ChartConfig { derivations: Derivations::All, allow_vacuous: true, ..config };
    let all = |_: &Grammar, _: (usize, usize), _: Category| true;
    Chart::fill(grammar, features, words, items, all, config)
}

/// The templates that any full parse in the chart used, with their spans, in order and once each. Every category
/// on the way is put into `useful`.
fn used_templates(
    model: &Model,
    chart: &Chart,
    templates: &[(TemplateId, Category)],
    useful: &mut Useful,
) -> Vec<(usize, usize, TemplateId)> {
    let is_goal = |&edge: &u32| is_goal(&model.grammar, chart.edge(edge));
    let mut used = Vec::new();
    for (start, end, edge) in chart.below(chart.roots().filter(is_goal)) {
        useful.insert((start, end, chart.edge(edge).category.syntax));
        for step in chart.steps(edge) {
            if let Step::Lexical(index) = step
                && let Lexical { own, item, .. } = chart.lexical[index as usize]
                && let Some(&(template, _)) = templates.get(item as usize)
            {
                used.push((own.0, own.1, template));
            }
        }
    }
    used.sort_unstable();
    used.dedup();
    used
}

/// Every way to fill an open template's holes with the signature's constants.
fn fillings(model: &mut Model, template: TemplateId) -> Vec<Vec<ConstantId>> {
    let types = model.lexicon.holes(&model.grammar, template);
    let holes = model.lexicon.open.get(&template).cloned().unwrap_or_default();
    let mut ways = vec![Vec::new()];
    for (ty, &hole) in types.into_iter().zip(&holes) {
        let constants = constants_for(model, ty, hole);
        ways = ways
            .iter()
            .flat_map(|way: &Vec<ConstantId>| {
                constants.iter().map(|&constant| {
                    let mut longer = way.clone();
                    longer.push(constant);
                    longer
                })
            })
            .take(MAX_FILLINGS)
            .collect();
    }
    ways
}

/// The constants that words can put into a hole: the frame's are none.
fn constants_for(model: &mut Model, ty: TyId, hole: Hole) -> Vec<ConstantId> {
    if let Hole::Only(constant) = hole {
        return vec![constant];
    }
    let Model { signature, grammar, lexicon, .. } = model;
    let mut found = Vec::new();
    for (name, text) in signature.iter() {
        let fits = match hole {
            Hole::Any | Hole::Only(_) => true,
            Hole::Noun => grammar.sorts.is_noun(name),
            Hole::Adjective => !grammar.sorts.is_noun(name),
        };
        if fits && grammar.terms.types.read(text) == Some(ty) {
            let constant = grammar.terms.constant(name, ty);
            if !lexicon.frame.contains(&constant) {
                found.push(constant);
            }
        }
    }
    found
}
