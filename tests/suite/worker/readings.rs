//! Readings taken apart: every piece of every formula knows its words, phrases know what they refer to, and reductions
//! end in the meanings that they explain.

use super::{only, pump};
use groundling::ccg::{ChartConfig, Derivation, parse};
use groundling::domain::{Plan, State, generate};
use groundling::learn::{CLEANUP_LEXICON, seed_model};
use groundling::logic::{Terms, print_human, read, steps};
use groundling::worker::protocol::{
    Answer, Claim, Event, Fate, Noun, Piece, Reading, Refers, Request, Study, WorldRules,
};
use groundling::worker::{Engine, Talker};
use std::collections::BTreeSet;

const TASKS: &str = include_str!("../../../assets/corpus/tasks.txt");

/// Commands with every rule in their derivations, words twice, words left out, words misheard.
const COMMANDS: [&str; 19] = [
    "push the green block to the biggest room and bring the chair to the yellow room",
    "take the red bag out of the room with the block and put it in the green room",
    "put the yellow basket next to the red chair in the blue room",
    "bring the biggest block and the smallest chair to the room with the basket",
    "move the chair in the red room next to the block in the green room",
    "go to the room with the blue bag in it and stand next to the green block",
    "bring the block from the red room to the smallest room with the chair",
    "go to the red room and move the chair to the red room",
    "move the red chair to the red room",
    "please could you go into the largest room now",
    "go to the room with the red chair in it",
    "stand right next to the blue block",
    "leave the red room",
    "bring the chair there",
    "go to the yelow room that the chair is in",
    "red red room",
    "push the yellow block next to the blue chair",
    "put the chair into the room that the block is in",
    "take the block out of the blue room and go to the red room",
];

fn engine() -> Engine<Talker> {
    let mut engine = Engine::new();
    let text = seed_model(CLEANUP_LEXICON).unwrap().print();
    pump(&mut engine, 1, Request::OpenModel { text });
    engine
}

/// Three rooms with a red chair in the red one and a yellow block in the blue one.
fn world() -> State {
    State::read(
        r#"{"agent":{"x":1,"y":1,"direction":"south"},
        "rooms":[{"name":"r","color":"red","left":0,"bottom":0,"right":4,"top":4},
                 {"name":"b","color":"blue","left":4,"bottom":0,"right":10,"top":4},
                 {"name":"g","color":"green","left":0,"bottom":4,"right":10,"top":8}],
        "doors":[{"name":"d","left":4,"bottom":2,"right":4,"top":2,"lock":"unlocked"}],
        "objects":[{"name":"c","shape":"chair","color":"red","x":2,"y":2},
                   {"name":"k","shape":"block","color":"yellow","size":"large","x":7,"y":2}]}"#,
    )
    .unwrap()
}

#[track_caller]
fn answer(command: &str) -> Answer {
    let ask = Request::Ask {
        command: command.to_owned(),
        state: world(),
        rules: WorldRules { landmarks_stay: false, ..WorldRules::default() },
    };
    match pump(&mut engine(), 2, ask).pop() {
        Some(Event::Answer(answer)) => *answer,
        other => panic!("{command}: {other:?}"),
    }
}

fn studies(command: &str) -> Vec<Study> {
    let explain = Request::Explain { command: command.to_owned() };
    match only(pump(&mut engine(), 2, explain)) {
        Event::Explained(studies) => studies,
        other => panic!("{command}: {other:?}"),
    }
}

fn joined(pieces: &[Piece]) -> String {
    pieces.iter().map(|piece| &*piece.text).collect()
}

/// The pieces of that text, as the words that they came from.
fn from(pieces: &[Piece], text: &str, answer: &Answer) -> Vec<String> {
    let of = |(start, end): (usize, usize)| {
        answer.words[start..end].iter().map(|word| &*word.text).collect::<Vec<_>>().join(" ")
    };
    let pieces = pieces.iter().filter(|piece| piece.text == text);
    pieces.map(|piece| piece.words.map(of).unwrap_or_default()).collect()
}

fn commands() -> impl Iterator<Item = &'static str> {
    TASKS.lines().filter_map(|line| line.strip_prefix("says ")).chain(COMMANDS)
}

#[test]
fn the_pieces_of_every_meaning_are_the_meaning() {
    for command in commands() {
        let answer = answer(command);
        assert!(!answer.readings.is_empty(), "{command}");
        for reading in &answer.readings {
            let mut terms = Terms::new();
            let form = read(&mut terms, &reading.form).unwrap();
            assert_eq!(joined(&reading.formula), print_human(&terms, form), "{command}");
            let root = reading.nodes.last().unwrap();
            // A clause of time is a sentence when it asks for nothing afterwards.
            if root.category != "T" {
                assert_eq!(root.meaning, reading.formula, "{command}");
            }
            let is_sentence = ["S", "NEG", "LIST", "PAIR", "T"].contains(&root.category.as_str());
            assert!(is_sentence, "{command}: {}", root.category);
            assert_eq!(root.words, (0, answer.words.len()), "{command}");
            for (at, node) in reading.nodes.iter().enumerate() {
                assert!(node.parts.iter().all(|&part| part < at));
                assert_eq!(node.parts.is_empty(), node.rule.is_empty());
                for piece in &node.meaning {
                    let within = |(start, end)| node.words.0 <= start && end <= node.words.1;
                    assert!(piece.words.is_none_or(within), "{command}: {piece:?}");
                }
            }
        }
    }
}

#[test]
fn a_word_that_stands_twice_is_told_apart() {
    let answer = answer("move the red chair to the red room");
    let formula = &answer.readings[0].formula;
    assert_eq!(joined(formula), "in(the λx. chair(x) ∧ red(x), the λx. red(x) ∧ room(x))");
    let reds: Vec<_> = formula.iter().filter(|piece| piece.text == "red").collect();
    assert_eq!(
        reds.iter().map(|piece| piece.words).collect::<Vec<_>>(),
        [Some((2, 3)), Some((6, 7))]
    );
    for (piece, words) in
        [("in", vec!["to"]), ("chair", vec!["chair"]), ("the", vec!["the", "the"])]
    {
        assert_eq!(from(formula, piece, &answer), words, "{piece}");
    }
}

#[test]
fn words_that_were_left_out_carry_nothing() {
    let answer = answer("please could you go into the largest room now");
    let fates: Vec<Fate> = answer.words.iter().map(|word| word.fate).collect();
    assert_eq!(fates[..3], [Fate::Empty; 3]);
    assert_eq!(fates[3..5], [Fate::Meant; 2]);
    let formula = &answer.readings[0].formula;
    assert_eq!(joined(formula), "in(the agent, argmax(room, size))");
    assert_eq!(from(formula, "agent", &answer), ["go"]);
    assert_eq!(from(formula, "argmax", &answer), ["largest"]);
}

#[test]
fn unknown_words_come_with_known_ones() {
    let answer = answer("go to the yelow rom xylophone");
    let of = |at: usize| &answer.words[at];
    assert_eq!((of(3).heard.as_deref(), of(3).fate), (Some("yellow"), Fate::Meant));
    assert_eq!((of(4).heard.as_deref(), of(4).fate), (None, Fate::Unknown));
    assert!(of(4).near.contains(&"room".to_owned()) && of(4).near.len() <= 3, "{:?}", of(4).near);
    assert_eq!((of(5).fate, &*of(5).near), (Fate::Unknown, &[][..]));
}

#[test]
fn phrases_know_what_they_refer_to_and_who_said_so() {
    let of = |reading: &Reading, answer: &Answer| -> Vec<(String, Refers, usize)> {
        let words = |places: &[usize]| {
            places.iter().map(|&at| &*answer.words[at].text).collect::<Vec<_>>().join(" ")
        };
        let phrases = reading.phrases.iter();
        phrases.map(|p| (words(&p.words), p.refers, p.referents.len())).collect()
    };
    let found = answer("move the yellow block to the red room");
    let best = &found.readings[0];
    assert_eq!(
        of(best, &found),
        [
            ("the yellow block".to_owned(), Refers::One, 1),
            ("the red room".to_owned(), Refers::One, 1)
        ]
    );
    let block = &best.phrases[0].referents[0];
    assert_eq!((&*block.class, &block.cells[..]), ("object", &[(7, 2)][..]));
    assert_eq!(best.phrases[1].referents[0].cells.len(), 9, "the floor, without the walls");
    assert_eq!(best.cells.len(), 9 - 2, "neither on the robot nor on the chair");
    let Claim::Related { relation, nouns } = &best.claim else { panic!("{:?}", best.claim) };
    assert!(
        relation == "in"
            && matches!(&nouns[0], Noun::Described(what) if what.properties == ["yellow", "block"])
    );
    let lost = answer("go to the room with the green chair");
    assert_eq!(
        of(&lost.readings[0], &lost)[1..],
        [
            ("the green chair".to_owned(), Refers::None, 0),
            ("the room with the green chair".to_owned(), Refers::Inner, 0)
        ]
    );
    assert_eq!(lost.plan.unwrap().reason.as_deref(), Some("no_referent"));
    assert!(lost.readings[0].cells.is_empty());
}

#[test]
fn reductions_lead_from_the_parts_to_every_meaning() {
    for command in commands() {
        let (answer, studies) = (answer(command), studies(command));
        assert_eq!(answer.readings.len(), studies.len(), "{command}");
        for (reading, study) in answer.readings.iter().zip(&studies) {
            assert_eq!(reading.score, study.explanation.score, "{command}");
            assert_eq!(reading.nodes.len(), study.reductions.len(), "{command}");
            for (node, lines) in reading.nodes.iter().zip(&study.reductions) {
                assert_eq!(lines.last(), Some(&joined(&node.meaning)), "{command}");
                // Two commands side by side are put together as they are.
                let is_plain = node.rule.is_empty() || node.rule == "&";
                assert!(lines.len() > 1 || is_plain, "{command}: {lines:#?}");
                assert!(lines.len() == 1 || !node.rule.is_empty(), "{command}: {lines:#?}");
                assert!(lines.windows(2).all(|two| two[0] != two[1]));
            }
        }
    }
}

#[test]
fn reduced_step_by_step_a_meaning_differs_in_the_order_of_conjuncts_and_in_twins_at_most() {
    let mut model = seed_model(CLEANUP_LEXICON).unwrap();
    let mut seen = 0;
    for command in commands() {
        let config = ChartConfig::of(&model);
        let parse = parse(&mut model, command, config);
        for &reading in &parse.readings {
            let mut open = vec![parse.derivation(reading)];
            while let Some(derivation) = open.pop() {
                let Derivation::Node { rule, children, category } = derivation else { continue };
                let parts: Vec<_> = children.iter().map(|child| child.category().meaning).collect();
                let last = steps(model.grammar.written(rule, &parts).unwrap()).pop().unwrap();
                let meaning = print_human(&model.grammar.terms, category.meaning);
                let same = if category.syntax.is_sentence() {
                    clauses(&last) == clauses(&meaning)
                } else {
                    ordered(&last) == ordered(&meaning)
                };
                assert!(same, "{last} is not {meaning}");
                open.extend(children);
                seen += 1;
            }
        }
    }
    assert!(seen > 1_000, "{seen} nodes");
}

/// The clauses that a goal joins, each once.
fn clauses(text: &str) -> BTreeSet<Vec<char>> {
    let (mut parts, mut depth) = (vec![String::new()], 0);
    for c in text.chars() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        match parts.last_mut() {
            Some(part) if c != '∧' || depth > 0 => part.push(c),
            _ => parts.push(String::new()),
        }
    }
    let joined = |part: &str| {
        let inner = part.strip_prefix('(').and_then(|part| part.strip_suffix(')'));
        inner.map_or_else(|| BTreeSet::from([ordered(part)]), clauses)
    };
    parts.iter().flat_map(|part| joined(part.trim())).collect()
}

/// The characters of a text in order, without brackets.
fn ordered(text: &str) -> Vec<char> {
    let mut all: Vec<char> = text.chars().filter(|c| !"()".contains(*c)).collect();
    all.sort_unstable();
    all
}

#[test]
fn a_reduction_can_be_followed() {
    let study = studies("go to the blue room").remove(0);
    let root = study.reductions.last().unwrap();
    let wanted = [
        "(λx. x(the agent))(λx. in(x, the λy. blue(y) ∧ room(y)))",
        "(λx. in(x, the λy. blue(y) ∧ room(y)))(the agent)",
        "in(the agent, the λx. blue(x) ∧ room(x))",
    ];
    assert_eq!(root, &wanted);
}

#[test]
fn every_world_of_the_generator_is_answered_in() {
    let mut engine = engine();
    for seed in 0..20 {
        let state = generate(&Plan::default(), seed);
        let rules = WorldRules::default();
        let command = "go to the biggest room".to_owned();
        let event = pump(&mut engine, 3, Request::Ask { command, state, rules }).pop();
        assert!(matches!(event, Some(Event::Answer(_))), "{seed}: {event:?}");
    }
}

#[test]
fn words_that_were_run_together_are_offered_apart() {
    let answer = answer("goto the blue room");
    assert_eq!(
        answer.words[0].near.first().map(String::as_str),
        Some("go to"),
        "{:?}",
        answer.words[0].near
    );
}
