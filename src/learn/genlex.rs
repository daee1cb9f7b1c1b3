//! Coarse lexical generation (Artzi and Zettlemoyer 2013, Section 6): every span of a few words is tried in every
//! template with one placeholder constant a type; what a full parse used is filled in with every constant of the
//! type. What comes out are candidates: only validation makes them entries.

use crate::ccg::chart::{Chart, ChartConfig, Lexical, Step};
use crate::ccg::factor::instantiate;
use crate::ccg::lexicon::Lexeme;
use crate::ccg::parse::lexical_items;
use crate::ccg::{Atom, Category, EntryId, Feature, Grammar, Model, Origin, SyntaxId, TemplateId};
use crate::logic::{ConstantId, TyId, ty};
use rustc_hash::FxHashSet;

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

/// What lexical generation found for a sentence.
#[derive(Clone, Debug, Default)]
pub struct Generated {
    /// The candidates.
    pub candidates: Vec<Candidate>,
    /// The syntactic categories that took part in a full coarse parse, by span: no other can lead to one.
    pub useful: FxHashSet<(usize, usize, SyntaxId)>,
}

/// The candidates for a sentence, as the model stands.
pub fn generate(
    model: &mut Model,
    words: &[String],
    scope: Scope,
    config: ChartConfig,
) -> Generated {
    let templates = coarse_categories(model);
    let chart = coarse_chart(model, words, scope, &templates, config);
    let mut generated = Generated::default();
    for (start, end, template) in used_templates(model, &chart, &templates, &mut generated.useful) {
        let words: Box<[Box<str>]> =
            words[start..end].iter().map(|word| Box::from(word.as_str())).collect();
        for constants in fillings(model, template) {
            let lexeme = Lexeme { words: words.clone(), constants: constants.into() };
            let added = model.lexicon.add(&mut model.grammar, lexeme, template, Origin::Candidate);
            if let Ok(entry) = added
                && model.lexicon.origin(entry) == Origin::Candidate
            {
                generated.candidates.push(Candidate { start, end, entry });
            }
        }
    }
    generated
}

/// Every template with placeholders in its holes.
fn coarse_categories(model: &mut Model) -> Vec<(TemplateId, Category)> {
    let ids: Vec<TemplateId> = model.lexicon.templates().map(|(id, _)| id).collect();
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

/// A chart of the lexicon's entries and the templates; an item from the number of templates on is an entry.
fn coarse_chart(
    model: &mut Model,
    words: &[String],
    scope: Scope,
    templates: &[(TemplateId, Category)],
    config: ChartConfig,
) -> Chart {
    let mut items = lexical_items(model, words);
    for item in &mut items {
        item.item += templates.len() as u32;
    }
    let unknown: Vec<bool> = words.iter().map(|word| !model.lexicon.knows(word)).collect();
    for start in 0..words.len() {
        for end in start + 1..=(start + MAX_SPAN).min(words.len()) {
            if scope == Scope::UnknownWords && !unknown[start..end].contains(&true) {
                continue;
            }
            for (item, &(_, category)) in (0..).zip(templates) {
                items.push(Lexical { start, end, skipped: 0, category, score: 0.0, item });
            }
        }
    }
    let features = &model.features;
    let rule_score = |rule| features.value(Feature::Rule(rule));
    let config = ChartConfig { all_derivations: true, allow_vacuous: true, ..config };
    let all = |_: &Grammar, _: (usize, usize), _: Category| true;
    Chart::fill(&mut model.grammar, words.len(), items, rule_score, all, config)
}

/// The templates that any full parse in the chart used, with their spans, in order and once each. Every category
/// on the way is put into `useful`.
fn used_templates(
    model: &mut Model,
    chart: &Chart,
    templates: &[(TemplateId, Category)],
    useful: &mut FxHashSet<(usize, usize, SyntaxId)>,
) -> Vec<(usize, usize, TemplateId)> {
    let sentence = model.grammar.syntaxes.atom(Atom::S);
    let is_goal = |&edge: &u32| {
        let category = chart.edge(edge).category;
        category.syntax == sentence && model.grammar.terms.ty(category.meaning) == ty::TRUTH
    };
    let mut used = Vec::new();
    for (start, end, edge) in chart.below(chart.roots().filter(is_goal)) {
        useful.insert((start, end, chart.edge(edge).category.syntax));
        for step in chart.steps(edge) {
            if let Step::Lexical(index) = step
                && let Some(&(template, _)) =
                    templates.get(chart.lexical[index as usize].item as usize)
            {
                used.push((start, end, template));
            }
        }
    }
    used.sort_unstable();
    used.dedup();
    used
}

/// Every way to fill a template's holes with the signature's constants.
fn fillings(model: &mut Model, template: TemplateId) -> Vec<Vec<ConstantId>> {
    let holes = model.lexicon.holes(&model.grammar, template);
    let mut ways = vec![Vec::new()];
    for hole in holes {
        let constants = constants_of(model, hole);
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

/// The constants of a type that words can stand for: the frame's are none.
fn constants_of(model: &mut Model, hole: TyId) -> Vec<ConstantId> {
    let Model { signature, grammar, lexicon, .. } = model;
    let terms = &mut grammar.terms;
    let mut found = Vec::new();
    for (name, text) in signature.iter() {
        if terms.types.read(text) == Some(hole) {
            let constant = terms.constant(name, hole);
            if !lexicon.frame.contains(&constant) {
                found.push(constant);
            }
        }
    }
    found
}
