//! Explanations of scores: what the parts add is the score, to the last bit as printed.

use crate::command::{answers, call};
use groundling::ccg::{ChartConfig, Explanation, General, Model, Reading, parse};
use groundling::learn::{CLEANUP_LEXICON, seed_model};
use groundling::logic::print_human;
use groundling::worker::protocol::{Event, Request};
use groundling::worker::{Engine, Talker};
use std::path::PathBuf;
use std::sync::Arc;

const WORDS: &str = include_str!("../../assets/lexicon/words.txt");

/// Plain, of two commands, with filling words, misspelt, with a word that is skipped, and with words of the general
/// resource: one that is taken for another, a measure, and both where a word is skipped.
const COMMANDS: [&str; 8] = [
    "go to the blue room",
    "move the red chair to the green room and go to the blue room",
    "please could you go into the largest room now",
    "go to the yelow room",
    "go to the blue room xyzzy",
    "shove the armchair into the red chamber",
    "put the hamper in the dark violet room",
    "xyzzy go to the navy blue room",
];

fn model() -> Model {
    seed_model(CLEANUP_LEXICON).unwrap()
}

/// The model with odd weights everywhere, so that the order of sums shows.
fn weighted() -> Model {
    let text = model().print();
    let odd = |line: &str| match line.rsplit_once('\t') {
        Some((head, value)) if line.starts_with("weight\t") => {
            let value: f64 = value.parse().unwrap();
            format!("{head}\t{}", value * 1.1 + 0.1 / 3.0)
        }
        _ => line.to_owned(),
    };
    let lines: Vec<String> = text.lines().map(odd).collect();
    Model::read(&(lines.join("\n") + "\n")).unwrap()
}

/// The model, understanding words that its lexicon does not know.
fn attached(mut model: Model) -> Model {
    model.attach(Arc::new(General::read(WORDS).unwrap()));
    model
}

#[test]
fn parts_sum_to_the_score_of_every_reading() {
    let mut model = attached(weighted());
    let config = ChartConfig::of(&model);
    for command in COMMANDS {
        let parse = parse(&mut model, command, config);
        assert!(!parse.readings.is_empty(), "{command}");
        for &reading in &parse.readings {
            let explanation = Explanation::of(&model, &parse, reading);
            let sum = explanation.parts.iter().fold(0.0, |sum, part| sum + part.adds);
            assert_eq!(sum.to_bits(), explanation.score.to_bits(), "{command}");
            let apart = (explanation.score - reading.score).abs();
            assert!(apart < 1e-9, "{command}: the chart has {}, not {sum}", reading.score);
            assert!(!explanation.entries.is_empty());
        }
    }
}

#[test]
fn an_explanation_names_entries_rules_and_features() {
    let mut model = model();
    let config = ChartConfig::of(&model);
    let parse = parse(&mut model, "go to the blue room", config);
    let explanation = Explanation::of(&model, &parse, parse.answer().unwrap());
    let words: Vec<&str> = explanation.entries.iter().map(|entry| &*entry.words).collect();
    assert_eq!(words, ["go", "to", "the", "blue", "room"]);
    assert!(explanation.entries.iter().all(|entry| !entry.learned));
    let has = |name: &str| explanation.parts.iter().any(|part| part.feature == name);
    for name in ["rule >", "lexeme blue blue:<e,t>", "pair blue:<e,t> in:<e,<e,t>>"] {
        assert!(has(name), "{name}: {:#?}", explanation.parts);
    }
    let applied = explanation.parts.iter().find(|part| part.feature == "rule >").unwrap();
    assert_eq!(applied.count, 4, "four words take what follows them");
}

#[test]
fn a_clause_that_sets_no_goal_costs_what_it_said() {
    // What no closed word stands for may throw a clause away, if nothing else can be made of the sentence.
    let likewise = "likewise :- S\\S/S : (lambda $0:t (lambda $1:t $0))";
    let mut model = seed_model(&format!("{CLEANUP_LEXICON}\n{likewise}")).unwrap();
    let config = ChartConfig::of(&model);
    let command = "move the red chair to the green room likewise go to the blue room";
    let parse = parse(&mut model, command, config);
    let lost = |wanted: &str| {
        let form = |r: &&Reading| print_human(&model.grammar.terms, r.form) == wanted;
        let &reading = parse.readings.iter().find(form).unwrap();
        let parts = Explanation::of(&model, &parse, reading).parts;
        parts.into_iter().find(|part| part.feature == "lost").map(|part| (part.count, part.adds))
    };
    // `in`, `red`, `chair`, `green` and `room` are said for nothing.
    assert_eq!(lost("in(the agent, the λx. blue(x) ∧ room(x))"), Some((5, -7.5)));
    let both = "in(the agent, the λx. blue(x) ∧ room(x)) ∧ \
                in(the λx. chair(x) ∧ red(x), the λx. green(x) ∧ room(x))";
    assert_eq!(lost(both), None);
}

#[test]
fn the_command_line_explains_the_scores_that_it_prints() {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("explained.model");
    std::fs::write(&path, weighted().print()).unwrap();
    let input = COMMANDS.join("\n") + "\n";
    let path = path.display().to_string();
    let plain = answers(&call(&["parse", "--model", &path], &input));
    let explained = answers(&call(&["parse", "--model", &path, "--explain"], &input));
    assert_eq!(plain.len(), COMMANDS.len());
    for (mut explained, plain) in explained.into_iter().zip(plain) {
        for form in explained["forms"].as_array_mut().unwrap() {
            let form = form.as_object_mut().unwrap();
            let explanation = form.remove("explanation").unwrap();
            let parts = explanation["parts"].as_array().unwrap();
            let sum = parts.iter().fold(0.0, |sum, part| sum + part["adds"].as_f64().unwrap());
            // What is printed is exact; serde_json reads it back to the last digit but one.
            assert!((sum - form["score"].as_f64().unwrap()).abs() < 1e-12);
            assert!(explanation["entries"][0]["words"].is_string());
        }
        assert_eq!(explained, plain, "nothing else changes");
    }
}

#[test]
fn the_engine_explains_the_readings_that_it_shows() {
    let mut engine = Engine::<Talker>::new();
    engine.start(1, Request::Explain { command: "go".to_owned() });
    assert!(matches!(engine.step(), Some((1, Event::Refused { .. }))));
    engine.start(2, Request::OpenModel { text: model().print() });
    engine.step();
    engine.start(3, Request::Explain { command: COMMANDS[0].to_owned() });
    let Some((3, Event::Explained(readings))) = engine.step() else { panic!("no explanation") };
    assert!(!readings.is_empty() && readings.len() <= 10);
    assert!(readings[0].explanation.score >= readings[readings.len() - 1].explanation.score);
}
