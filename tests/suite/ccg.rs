//! The grammar: the rules table, words, factoring and categories as data; charts against brute force; model files.

#[path = "ccg/absorb.rs"]
mod absorb;
#[path = "ccg/brute.rs"]
mod brute;
#[path = "ccg/chart.rs"]
mod chart;
#[path = "ccg/closed.rs"]
mod closed;
#[path = "ccg/files.rs"]
mod files;
#[path = "ccg/forest.rs"]
mod forest;
#[path = "ccg/general.rs"]
mod general;
#[path = "ccg/normal.rs"]
mod normal;
#[path = "ccg/numbers.rs"]
mod numbers;
#[path = "ccg/spelling.rs"]
mod spelling;

use crate::logic::cases;
use groundling::ccg::factor::{factor, instantiate};
use groundling::ccg::{Category, Grammar, MAX_WORDS, Model, Syntaxes, lexicon_text, words};
use groundling::ground::ONTOLOGY;
use groundling::logic::{Signature, Terms, print, read};

/// What may be left unsaid.
const SHIFTS: &str = r"
shift PP=>N\N : (lambda $0:<e,t> (lambda $1:<e,t> (lambda $2:e (and:<t*,t> ($1 $2) ($0 $2)))))
shift N=>NP : (lambda $0:<e,t> (the:<<e,t>,e> $0))
";

/// A lexicon in which most words can be several things, over the constants of Cleanup World.
pub(crate) const AMBIGUOUS: &str = r"
go    :- S/PP     : (lambda $0:<e,t> ($0 (the:<<e,t>,e> agent:<e,t>)))
go    :- S/NP     : (lambda $0:e (near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) $0))
to    :- PP/NP    : (lambda $0:e (lambda $1:e (in:<e,<e,t>> $1 $0)))
to    :- PP/NP    : (lambda $0:e (lambda $1:e (near:<e,<e,t>> $1 $0)))
to    :- NP/NP    : (lambda $0:e $0)
the   :- NP/N     : (lambda $0:<e,t> (the:<<e,t>,e> $0))
red   :- N/N      : (lambda $0:<e,t> (lambda $1:e (and:<t*,t> (red:<e,t> $1) ($0 $1))))
red   :- N        : red:<e,t>
room  :- N        : room:<e,t>
room  :- N/N      : (lambda $0:<e,t> (lambda $1:e (and:<t*,t> (room:<e,t> $1) ($0 $1))))
in    :- PP/NP    : (lambda $0:e (lambda $1:e (in:<e,<e,t>> $1 $0)))
in    :- S\NP/NP  : (lambda $0:e (lambda $1:e (in:<e,<e,t>> $1 $0)))
near  :- S\NP/NP  : (lambda $0:e (lambda $1:e (near:<e,<e,t>> $1 $0)))
robot :- NP       : (the:<<e,t>,e> agent:<e,t>)
robot :- N        : agent:<e,t>
now   :- S\S      : (lambda $0:t $0)
not   :- S/S      : (lambda $0:t (not:<t,t> $0))
red room :- NP    : (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (red:<e,t> $0) (room:<e,t> $0))))
";

/// A model of a lexicon over constants, with the shifts.
pub(crate) fn model_over(constants: &str, lexicon: &str) -> Model {
    let mut model = Model::default();
    model.set_signature(Signature::read(constants).unwrap());
    lexicon_text::read_lexicon(&mut model, SHIFTS).unwrap();
    lexicon_text::read_lexicon(&mut model, lexicon).unwrap();
    model
}

/// A model of a lexicon over the constants of Cleanup World, whose sorts nobody has said: there are more readings.
pub(crate) fn model(lexicon: &str) -> Model {
    let signature = Signature::read(ONTOLOGY).unwrap();
    let constants: Vec<String> =
        signature.iter().map(|(name, ty)| format!("{name}:{ty}")).collect();
    model_over(&constants.join("\n"), lexicon)
}

#[test]
fn neighbours_combine_as_the_table_says() {
    let mut grammar = Grammar::default();
    cases(include_str!("../data/ccg/combinations.txt"), 37, |line, input, expected| {
        let [left, right] = input.split(' ').collect::<Vec<_>>()[..] else {
            panic!("line {line}: not two categories: {input}");
        };
        let [left, right] = [left, right].map(|text| grammar.syntaxes.read(text).unwrap());
        let rows = grammar.rows(left, right).to_vec();
        assert_eq!(grammar.rows(left, right), rows, "asked again");
        let text = |(rule, syntax): &(groundling::ccg::RuleId, _)| {
            format!("{} {}", grammar.rule_name(*rule), grammar.syntaxes.text(*syntax))
        };
        let made: Vec<String> = rows.iter().map(text).collect();
        let made = if made.is_empty() { "-".to_owned() } else { made.join(", ") };
        assert_eq!(made, expected, "line {line}: {input}");
    });
}

fn category(grammar: &mut Grammar, text: &str) -> Category {
    let (syntax, meaning) = text.split_once(" : ").unwrap();
    let syntax = grammar.syntaxes.read(syntax).unwrap();
    Category { syntax, meaning: read(&mut grammar.terms, meaning).unwrap() }
}

#[test]
fn meanings_combine_with_the_words() {
    let mut grammar = Grammar::default();
    cases(include_str!("../data/ccg/meanings.txt"), 10, |line, input, expected| {
        let (left, right) = input.split_once(" | ").unwrap();
        let [left, right] = [left, right].map(|text| category(&mut grammar, text));
        let mut made = Vec::new();
        for (rule, syntax) in grammar.rows(left.syntax, right.syntax).to_vec() {
            if let Some(meaning) = grammar.combine(rule, left.meaning, right.meaning, false) {
                let category = Category { syntax, meaning };
                let text = category.print(&grammar.syntaxes, &grammar.terms);
                made.push(format!("{} {text}", grammar.rule_name(rule)));
            }
        }
        let made = if made.is_empty() { "-".to_owned() } else { made.join(", ") };
        assert_eq!(made, expected, "line {line}: {input}");
    });
}

#[test]
fn shifts_make_modifiers_of_prepositional_phrases_and_definites_of_bare_nouns() {
    let mut grammar = model("").grammar;
    for (from, expected) in [
        (
            "PP : (lambda $0:e (near:<e,<e,t>> $0 a:e))",
            r"PP=>N\N N\N : (lambda $0:<e,t> (lambda $1:e (and:<t*,t> (near:<e,<e,t>> $1 a:e) ($0 $1))))",
        ),
        ("N : room:<e,t>", "N=>NP NP : (the:<<e,t>,e> (lambda $0:e (room:<e,t> $0)))"),
        ("PP/NP : (lambda $0:e (lambda $1:e p:t))", ""),
        ("PP : p:t", ""),
        ("N : a:e", ""),
    ] {
        let category = category(&mut grammar, from);
        let shifted: Vec<String> = grammar
            .shifted(category, false)
            .iter()
            .map(|&(rule, to)| {
                let name = grammar.rule_name(rule);
                format!("{name} {}", to.print(&grammar.syntaxes, &grammar.terms))
            })
            .collect();
        assert_eq!(shifted.join(", "), expected, "{from}");
    }
}

#[test]
fn categories_print_as_they_are_read() {
    let mut syntaxes = Syntaxes::default();
    for (text, printed) in [
        ("S", "S"),
        ("NP/N", "NP/N"),
        ("S/PP/NP", "S/PP/NP"),
        ("(S/PP)/NP", "S/PP/NP"),
        ("S/(PP/NP)", "S/(PP/NP)"),
        (r"S\NP/(N/N)", r"S\NP/(N/N)"),
        (r"(S\NP)\(S\NP)/(AP/(ADJ\N))", r"S\NP\(S\NP)/(AP/(ADJ\N))"),
        ("((N))", "N"),
        (" NP ", "NP"),
    ] {
        let id = syntaxes.read(text).unwrap_or_else(|| panic!("{text} was not read"));
        assert_eq!(syntaxes.text(id), printed, "{text}");
        assert_eq!(syntaxes.read(printed), Some(id), "{printed} read again");
    }
    let deep = "(".repeat(17) + "N" + &")".repeat(17);
    let long = "N".to_owned() + &"/N".repeat(17);
    for text in [
        "", "X", "n", "NP/", "/N", "NP//N", "NP N", "(NP", "NP)", "()", "S|NP", "🤖", "S/🤖",
        &deep, &long,
    ] {
        assert_eq!(syntaxes.read(text), None, "{text}");
    }
}

#[test]
fn commands_fall_into_words() {
    cases(include_str!("../data/ccg/words.txt"), 25, |line, input, expected| {
        assert_eq!(words(input).join("|"), expected, "line {line}: {input}");
    });
    let long = words(&"go ".repeat(200));
    assert_eq!(long.len(), MAX_WORDS + 1, "one more than can be parsed tells that it is too long");
    assert_eq!(words(&"robot's ".repeat(200)).len(), MAX_WORDS + 1);
}

#[test]
fn factoring_takes_apart_what_filling_puts_together() {
    cases(include_str!("../data/ccg/factors.txt"), 9, |line, input, expected| {
        let mut terms = Terms::new();
        let property = terms.types.read("<e,t>").unwrap();
        let frame = [terms.constant("agent", property)];
        let meaning = read(&mut terms, input).unwrap();
        let factored = factor(&mut terms, meaning, &frame).unwrap();
        let constants = factored
            .constants
            .iter()
            .map(|&c| format!("{}:{} ", terms.name(c), terms.types.print(terms.constant_ty(c))));
        let text =
            format!("{}: {}", constants.collect::<String>(), print(&terms, factored.template));
        assert_eq!(text, expected, "line {line}: {input}");
        let filled = instantiate(&mut terms, factored.template, &factored.constants);
        assert_eq!(filled, Ok(meaning), "line {line}: filled again");
    });
}
