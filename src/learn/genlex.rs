//! Coarse lexical generation (Artzi and Zettlemoyer 2013, Section 6): every span of a few words is tried in every
//! template with one placeholder constant a type; what a full parse used is filled in with every constant of the
//! type. What comes out are candidates: only validation makes them entries. The coarse parse knows the seed
//! lexicon and its weights alone, so that candidates are a function of the sentence and can be made again.

use crate::ccg::chart::{Chart, ChartConfig, Lexical, Step};
use crate::ccg::factor::instantiate;
use crate::ccg::lexicon::Lexeme;
use crate::ccg::lexicon_text::{SEED_LEXEME, seed_weight};
use crate::ccg::parse::lexical_items;
use crate::ccg::{Atom, Category, EntryId, Model, Origin, TemplateId};
use crate::logic::{ConstantId, TyId, ty};

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

/// The candidates for a sentence.
pub fn candidates(model: &mut Model, words: &[String], config: ChartConfig) -> Vec<Candidate> {
    let templates = coarse_categories(model);
    let chart = coarse_chart(model, words, &templates, config);
    let mut found = Vec::new();
    for (start, end, template) in used_templates(model, &chart, &templates) {
        let words: Box<[Box<str>]> =
            words[start..end].iter().map(|word| Box::from(word.as_str())).collect();
        for constants in fillings(model, template) {
            let lexeme = Lexeme { words: words.clone(), constants: constants.into() };
            let added = model.lexicon.add(&mut model.grammar, lexeme, template, Origin::Candidate);
            if let Ok(entry) = added {
                found.push(Candidate { start, end, entry });
            }
        }
    }
    found
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
    templates: &[(TemplateId, Category)],
    config: ChartConfig,
) -> Chart {
    let n_templates = templates.len() as u32;
    let mut items = lexical_items(model, words);
    items.retain(|item| model.lexicon.origin(EntryId::from_item(item.item)) == Origin::Seed);
    for item in &mut items {
        item.score = SEED_LEXEME + seed_weight(item.end - item.start);
        item.item += n_templates;
    }
    for start in 0..words.len() {
        for end in start + 1..=(start + MAX_SPAN).min(words.len()) {
            for (item, &(_, category)) in (0..).zip(templates) {
                items.push(Lexical { start, end, skipped: 0, category, score: 0.0, item });
            }
        }
    }
    let config = ChartConfig { all_derivations: true, allow_vacuous: true, ..config };
    Chart::fill(&mut model.grammar, words.len(), items, |_| 0.0, |_, _| true, config)
}

/// The templates that any full parse in the chart used, with their spans, in order and once each.
fn used_templates(
    model: &mut Model,
    chart: &Chart,
    templates: &[(TemplateId, Category)],
) -> Vec<(usize, usize, TemplateId)> {
    let sentence = model.grammar.syntaxes.atom(Atom::S);
    let is_goal = |&edge: &u32| {
        let category = chart.edge(edge).category;
        category.syntax == sentence && model.grammar.terms.ty(category.meaning) == ty::TRUTH
    };
    let mut open: Vec<u32> = chart.roots().filter(is_goal).collect();
    let mut seen = vec![false; chart.n_edges()];
    let mut used = Vec::new();
    while let Some(edge) = open.pop() {
        if std::mem::replace(&mut seen[edge as usize], true) {
            continue;
        }
        for step in chart.steps(edge) {
            match step {
                Step::Binary { left, right, .. } => open.extend([left, right]),
                Step::Shift { child, .. } => open.push(child),
                Step::Lexical(index) => {
                    let item = &chart.lexical[index as usize];
                    if let Some(&(template, _)) = templates.get(item.item as usize) {
                        used.push((item.start, item.end, template));
                    }
                }
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
