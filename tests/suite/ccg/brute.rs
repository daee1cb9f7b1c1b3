//! Every derivation of a short sentence, written out without a chart: all bracketings, all rules, all shifts.

use groundling::ccg::combinator::Made;
use groundling::ccg::features::root_features;
use groundling::ccg::{Atom, Category, Feature, Lexical, Model, RuleId, SyntaxId};
use groundling::logic::{Node, TermId, Terms, print, ty};
use std::collections::BTreeMap;

/// One derivation of a span.
#[derive(Clone, Copy)]
struct Derived {
    category: Category,
    made: Made,
    score: f64,
}

/// Which derivations count.
#[derive(Clone, Copy)]
pub(super) struct Admitted {
    /// Only Eisner's, or all of them.
    pub(super) normal_form: bool,
    /// Also those in which a functor adds nothing to its argument.
    pub(super) vacuous: bool,
}

impl Admitted {
    /// How a derivation was made, as far as is asked here: that a bare phrase is no command beside another, always.
    fn made(self, derived: &Derived) -> Made {
        match derived.made {
            Made::ByForwardComposition | Made::ByBackwardComposition if !self.normal_form => {
                Made::Plainly
            }
            made => made,
        }
    }
}

/// What a chart admits.
pub(super) const NORMAL_FORM: Admitted = Admitted { normal_form: true, vacuous: false };

/// Whether somebody could mean a goal, as far as these sentences go.
pub(super) fn is_meant(terms: &Terms, goal: TermId) -> bool {
    !contradicts(terms, goal) && !forgets_room(terms, goal) && !is_beside_itself(terms, goal)
}

/// Whether a thing is to be beside itself, which the robot always is.
fn is_beside_itself(terms: &Terms, goal: TermId) -> bool {
    match terms.node(goal) {
        Node::Constant(_) | Node::Variable(_) => false,
        Node::Lambda { body, .. } => is_beside_itself(terms, body),
        Node::Apply { args: &[thing, other], .. }
            if thing == other && terms.head_name(goal) == Some("near") =>
        {
            !print(terms, thing).contains("agent:<e,t>")
        }
        Node::Apply { args, .. } => args.iter().any(|&arg| is_beside_itself(terms, arg)),
    }
}

/// Whether a conjunction claims and denies the same, which nobody means.
fn contradicts(terms: &Terms, both: TermId) -> bool {
    let Node::Apply { args, .. } = terms.node(both) else { return false };
    let is_denied = |&part: &TermId| match terms.node(part) {
        Node::Apply { args: &[denied], .. } => {
            terms.head_name(part) == Some("not") && args.contains(&denied)
        }
        _ => false,
    };
    terms.head_name(both) == Some("and") && args.iter().any(is_denied)
}

/// Whether a goal speaks of "the room" and nothing more beside a room that is told from others, which nobody means.
fn forgets_room(terms: &Terms, goal: TermId) -> bool {
    let text = print(terms, goal);
    let bare = |depth: u32| format!("(the:<<e,t>,e> (lambda ${depth}:e (room:<e,t> ${depth})))");
    let n_bare: usize = (0..9).map(|depth| text.matches(&bare(depth)).count()).sum();
    n_bare > 0 && text.matches("(room:<e,t> $").count() > n_bare
}

/// The goals of a sentence that is one command.
pub(super) fn commands(
    model: &mut Model,
    n_words: usize,
    lexical: &[Lexical],
    admitted: Admitted,
) -> Vec<TermId> {
    let found = derive(model, lexical, (0, n_words), admitted).into_iter();
    let found = found.filter(|found| model.grammar.syntaxes.is(found.category.syntax, Atom::S));
    let mut goals: Vec<TermId> = found
        .map(|found| found.category.meaning)
        .filter(|&goal| is_meant(&model.grammar.terms, goal))
        .collect();
    goals.sort_unstable();
    goals.dedup();
    goals
}

/// Whether a sentence may be several commands side by side.
pub(super) fn is_several(model: &mut Model, n_words: usize, lexical: &[Lexical]) -> bool {
    let found = derive(model, lexical, (0, n_words), NORMAL_FORM);
    found.iter().any(|found| found.category.syntax == SyntaxId::LIST)
}

/// The goals of a sentence, printed, each with the best score of its derivations.
pub(super) fn goals(
    model: &mut Model,
    n_words: usize,
    lexical: &[Lexical],
    admitted: Admitted,
) -> BTreeMap<String, f64> {
    let mut best: BTreeMap<String, f64> = BTreeMap::new();
    for found in derive(model, lexical, (0, n_words), admitted) {
        let Category { syntax, meaning } = found.category;
        let terms = &model.grammar.terms;
        if syntax.is_sentence() && terms.ty(meaning) == ty::TRUTH && is_meant(terms, meaning) {
            let root = root_features(&model.grammar.terms, &model.grammar.sorts, meaning);
            let score = root.iter().fold(found.score, |sum, &f| sum + model.features.value(f));
            let known = best.entry(print(&model.grammar.terms, meaning)).or_insert(score);
            *known = known.max(score);
        }
    }
    best
}

/// How many derivations in normal form the goals of a sentence have together.
pub(super) fn derivations(model: &mut Model, n_words: usize, lexical: &[Lexical]) -> usize {
    let found = derive(model, lexical, (0, n_words), NORMAL_FORM);
    let is_goal = |found: &&Derived| {
        let Category { syntax, meaning } = found.category;
        syntax.is_sentence() && model.grammar.terms.ty(meaning) == ty::TRUTH
    };
    found.iter().filter(is_goal).count()
}

fn derive(
    model: &mut Model,
    lexical: &[Lexical],
    (start, end): (usize, usize),
    admitted: Admitted,
) -> Vec<Derived> {
    let items = lexical.iter().filter(|item| (item.start, item.end) == (start, end));
    let mut found: Vec<Derived> = items
        .map(|item| Derived { category: item.category, made: Made::Plainly, score: item.score })
        .filter(|found| model.grammar.fits(found.category.meaning))
        .collect();
    for split in start + 1..end {
        let lefts = derive(model, lexical, (start, split), admitted);
        let rights = derive(model, lexical, (split, end), admitted);
        for (l, r) in lefts.iter().flat_map(|l| rights.iter().map(move |r| (l, r))) {
            let rows = model.grammar.rows(l.category.syntax, r.category.syntax).to_vec();
            for (rule, syntax) in rows {
                let meanings = (l.category.meaning, r.category.meaning);
                let combined =
                    model.grammar.combine(rule, meanings.0, meanings.1, admitted.vacuous);
                if let Some(meaning) = combined
                    && model.grammar.fits(meaning)
                    && rule.admits(admitted.made(l), admitted.made(r))
                {
                    let own = step(model, rule, &[meanings.0, meanings.1], meaning);
                    let score = l.score + r.score + own;
                    let category = Category { syntax, meaning };
                    found.push(Derived { category, made: rule.makes(), score });
                }
            }
        }
    }
    for late in [false, true] {
        for base in found.clone() {
            let is_plain = !matches!(base.made, Made::ByShift | Made::ByTask | Made::ByDescription);
            if !late && !is_plain {
                continue;
            }
            for (rule, category) in model.grammar.shifted(base.category, late) {
                if !model.grammar.fits(category.meaning) {
                    continue;
                }
                let made = model.grammar.shift_makes(rule, base.made);
                let own = step(model, rule, &[base.category.meaning], category.meaning);
                let score = base.score + own;
                found.push(Derived { category, made, score });
            }
        }
    }
    found
}

/// What a step adds to the score: its rule, and what it leaves out.
fn step(model: &Model, rule: RuleId, parts: &[TermId], whole: TermId) -> f64 {
    let lost = f64::from(model.grammar.lost(parts, whole));
    model.features.value(Feature::Rule(rule)) + lost * model.features.value(Feature::Lost)
}
