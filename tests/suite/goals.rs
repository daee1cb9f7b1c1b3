//! Meaning in a world: the conformance cases, by both ways to evaluate a goal; the ontology against the table;
//! what phrases refer to; and what the cases do not reach.

#[path = "goals/cells.rs"]
mod cells;
#[path = "goals/claims.rs"]
mod claims;
#[path = "goals/shades.rs"]
mod shades;

use groundling::domain::{Object, Plan, State, generate};
use groundling::ground::{Entity, Failure, Goal, ONTOLOGY, PREDICATES, Side, Validator, phrases};
use groundling::logic::{Signature, TermId, Terms, read};

/// Two rooms, red and blue, with a wall at column 4; sizes 16 and 24; what `change` makes of it.
fn world(change: impl FnOnce(&mut State)) -> State {
    let mut state = State::read(
        r#"{"agent":{"x":1,"y":1,"direction":"south"},
        "rooms":[{"name":"r","color":"red","left":0,"bottom":0,"right":4,"top":4},
                 {"name":"b","color":"blue","left":4,"bottom":0,"right":10,"top":4}],
        "doors":[{"name":"d","left":4,"bottom":2,"right":4,"top":2,"lock":"unlocked"}],
        "objects":[{"name":"c","shape":"chair","color":"red","x":7,"y":2},
                   {"name":"k","shape":"chair","color":"blue","x":9,"y":1}]}"#,
    )
    .unwrap();
    change(&mut state);
    state
}

/// Whether a goal holds; the validator must say the same.
fn holds(terms: &mut Terms, goal: &str, initial: &State, current: &State) -> bool {
    let term = read(terms, goal).unwrap_or_else(|e| panic!("{goal}: {e}"));
    let holds = Goal::new(terms, term, initial).unwrap().holds(current);
    let mut validator = Validator::new();
    let pair = validator.pair(initial, current);
    assert_eq!(validator.holds(terms, term, pair, Side::Post), Some(holds), "{goal}");
    holds
}

#[test]
fn every_conformance_case_holds_as_it_should() {
    let mut terms = Terms::new();
    let mut lines = 0;
    for (line, text) in (1..).zip(include_str!("../data/conformance/goals.jsonl").lines()) {
        let case: serde_json::Value = serde_json::from_str(text).unwrap();
        let state = |side: &str| State::read(&case[side].to_string()).unwrap();
        let goal = case["goal"].as_str().unwrap();
        let holds = holds(&mut terms, goal, &state("initial"), &state("current"));
        assert_eq!(holds, case["holds"].as_bool().unwrap(), "line {line}: {goal}");
        lines += 1;
    }
    assert!(lines > 300);
}

#[test]
fn the_table_means_what_the_ontology_names() {
    let ontology = Signature::read(ONTOLOGY).unwrap();
    let table: Vec<_> = PREDICATES.iter().map(|known| (known.name, known.ty)).collect();
    assert_eq!(ontology.iter().collect::<Vec<_>>(), table);
}

#[test]
fn what_is_no_goal_is_refused_with_the_reason() {
    let mut terms = Terms::new();
    let state = world(|_| {});
    for (text, said) in [
        (
            "(the:<<e,t>,e> room:<e,t>)",
            "a goal has type t, or p where it speaks of time; this term has type e",
        ),
        ("(purple:<e,t> (the:<<e,t>,e> room:<e,t>))", "unknown constant purple: use one of agent"),
        ("(in:<e,t> (the:<<e,t>,e> room:<e,t>))", "in has type <e,<e,t>>, not <e,t>"),
        ("(lambda $0:e (red:<e,t> $0))", "this term has type <e,t>"),
    ] {
        let term = read(&mut terms, text).unwrap();
        let error = Goal::new(&terms, term, &state).unwrap_err().to_string();
        assert!(error.contains(said), "{text}: {error}");
        let mut validator = Validator::new();
        let pair = validator.pair(&state, &state);
        assert_eq!(validator.holds(&terms, term, pair, Side::Pre), None, "{text}");
        assert!(!validator.valid(&terms, term, &[pair]));
    }
}

#[test]
fn phrases_refer_or_say_why_not() {
    let mut terms = Terms::new();
    let state = world(|s| {
        s.rooms[1].bounds.right = 8;
        s.objects[1].x = 6;
    });
    // What each closed phrase refers to, inner ones first.
    for (phrase, wanted) in [
        ("(the:<<e,t>,e> agent:<e,t>)", "agent"),
        ("(the:<<e,t>,e> door:<e,t>)", "4 2 4 2"),
        ("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (blue:<e,t> $0) (chair:<e,t> $0))))", "k"),
        ("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (yellow:<e,t> $0) (chair:<e,t> $0))))", "none"),
        ("(the:<<e,t>,e> room:<e,t>)", "several: 0 0 4 4, 4 0 8 4"),
        ("(the:<<e,t>,e> chair:<e,t>)", "several: c, k"),
        ("(argmax:<<e,t>,<<e,n>,e>> room:<e,t> size:<e,n>)", "tie: 0 0 4 4, 4 0 8 4"),
        ("(argmin:<<e,t>,<<e,n>,e>> room:<e,t> size:<e,n>)", "tie: 0 0 4 4, 4 0 8 4"),
        ("(argmax:<<e,t>,<<e,n>,e>> door:<e,t> size:<e,n>)", "single: 4 2 4 2"),
        ("(argmax:<<e,t>,<<e,n>,e>> agent:<e,t> size:<e,n>)", "single: agent"),
        ("(argmax:<<e,t>,<<e,n>,e>> red:<e,t> size:<e,n>)", "mixed: 0 0 4 4, c"),
        ("(argmax:<<e,t>,<<e,n>,e>> room:<e,t> navy:<e,n>)", "4 0 8 4"),
        ("(argmax:<<e,t>,<<e,n>,e>> chair:<e,t> crimson:<e,n>)", "c"),
        ("(argmax:<<e,t>,<<e,n>,e>> room:<e,t> lime:<e,n>)", "none"),
        ("(argmax:<<e,t>,<<e,n>,e>> door:<e,t> navy:<e,n>)", "none"),
        (
            "(argmax:<<e,t>,<<e,n>,e>> (lambda $0:e (or:<t*,t> (agent:<e,t> $0) (door:<e,t> $0))) navy:<e,n>)",
            "none",
        ),
        (
            "(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (chair:<e,t> $0) (in:<e,<e,t>> $0 (the:<<e,t>,e> green:<e,t>)))))",
            "none; inner",
        ),
        (
            "(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (box:<e,t> $0) (in:<e,<e,t>> $0 (the:<<e,t>,e> (lambda $1:e (and:<t*,t> (room:<e,t> $1) (blue:<e,t> $1))))))))",
            "4 0 8 4; none",
        ),
        (
            "(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (chair:<e,t> $0) (in:<e,<e,t>> $0 (the:<<e,t>,e> (lambda $1:e (and:<t*,t> (room:<e,t> $1) (blue:<e,t> $1))))))))",
            "4 0 8 4; several: c, k",
        ),
    ] {
        let term = read(&mut terms, &format!("(near:<e,<e,t>> {phrase} {phrase})")).unwrap();
        let found = phrases(&terms, term, &state).unwrap();
        let said: Vec<String> = found.iter().map(|one| referred(&one.referent)).collect();
        assert_eq!(said.join("; "), wanted, "{phrase}");
        let all_refer = found.iter().all(|one| one.referent.is_ok());
        let goal = Goal::new(&terms, term, &state).unwrap();
        assert_eq!(goal.failures().is_empty(), all_refer, "{phrase}");
    }
}

fn referred(referent: &Result<Entity, Failure>) -> String {
    let all = |kind: &str, which: &[Entity]| {
        format!("{kind}: {}", which.iter().map(known).collect::<Vec<_>>().join(", "))
    };
    match referent {
        Ok(entity) => known(entity),
        Err(Failure::None) => "none".to_owned(),
        Err(Failure::Several(which)) => all("several", which),
        Err(Failure::Tie(which)) => all("tie", which),
        Err(Failure::Single(only)) => all("single", std::slice::from_ref(only)),
        Err(Failure::Mixed(which)) => all("mixed", which),
        Err(Failure::Inner) => "inner".to_owned(),
    }
}

fn known(entity: &Entity) -> String {
    match entity {
        Entity::Agent => "agent".to_owned(),
        Entity::Object(name) => name.clone(),
        Entity::Room(b) | Entity::Door(b) => {
            format!("{} {} {} {}", b.left, b.bottom, b.right, b.top)
        }
        Entity::Stranger(_) => "stranger".to_owned(),
    }
}

const AGENT: &str = "(the:<<e,t>,e> agent:<e,t>)";
const BLUE_CHAIR: &str =
    "(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (blue:<e,t> $0) (chair:<e,t> $0))))";

#[test]
fn references_are_bound_before_and_asked_about_after() {
    let mut terms = Terms::new();
    let before = world(|_| {});
    // The chair that was blue is red now, and the rooms have changed names.
    let after = world(|s| {
        s.objects.swap(0, 1);
        s.objects[0].color = s.objects[1].color;
        s.rooms[0].name = "b".into();
        s.rooms[1].name = "r".into();
        (s.agent.x, s.agent.y) = (8, 2);
    });
    for (goal, expected) in [
        (format!("(near:<e,<e,t>> {AGENT} {BLUE_CHAIR})"), true),
        (format!("(red:<e,t> {BLUE_CHAIR})"), true),
        (format!("(blue:<e,t> {BLUE_CHAIR})"), false),
        (
            format!(
                "(in:<e,<e,t>> {AGENT} (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) (blue:<e,t> $0)))))"
            ),
            true,
        ),
        (
            "(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> (blue:<e,t> $0) (chair:<e,t> $0))))".into(),
            false,
        ),
        // a determiner below `exists` still looks at the state before, where the robot was far from chairs
        (
            format!(
                "(exists:<<e,t>,t> (lambda $0:e (eq:<e,<e,t>> $0 (the:<<e,t>,e> (lambda $1:e (near:<e,<e,t>> $1 {AGENT}))))))"
            ),
            false,
        ),
        (
            format!(
                "(exists:<<e,t>,t> (lambda $0:e (in:<e,<e,t>> {AGENT} (the:<<e,t>,e> (lambda $1:e (and:<t*,t> (room:<e,t> $1) (in:<e,<e,t>> $0 $1)))))))"
            ),
            true,
        ),
    ] {
        assert_eq!(holds(&mut terms, &goal, &before, &after), expected, "{goal}");
    }
}

#[test]
fn what_came_or_went_is_there_only_where_it_is() {
    let mut terms = Terms::new();
    let before = world(|_| {});
    let gone = world(|s| drop(s.objects.pop()));
    let came = world(|s| {
        let bag = Object {
            name: "new".into(),
            shape: groundling::domain::Shape::Bag,
            x: 2,
            y: 2,
            ..s.objects[0].clone()
        };
        s.objects.push(bag);
    });
    let some = |body: &str| format!("(exists:<<e,t>,t> (lambda $0:e {body}))");
    for (goal, current, expected) in [
        (format!("(chair:<e,t> {BLUE_CHAIR})"), &gone, false),
        (some(&format!("(eq:<e,<e,t>> $0 {BLUE_CHAIR})")), &gone, false),
        (
            some(
                "(not:<t,t> (or:<t*,t> (agent:<e,t> $0) (door:<e,t> $0) (room:<e,t> $0) (red:<e,t> $0)))",
            ),
            &gone,
            false,
        ),
        (some("(bag:<e,t> $0)"), &came, true),
        (some(&format!("(and:<t*,t> (bag:<e,t> $0) (near:<e,<e,t>> $0 {AGENT}))")), &came, true),
        // below a determiner the newcomer is unknown, so this `the` finds nothing
        (
            some(
                "(and:<t*,t> (bag:<e,t> $0) (object:<e,t> (the:<<e,t>,e> (lambda $1:e (eq:<e,<e,t>> $0 $1)))))",
            ),
            &came,
            false,
        ),
        (
            some(&format!(
                "(and:<t*,t> (bag:<e,t> $0) {})",
                some("(near:<e,<e,t>> $0 $1)")
                    .replace("$0", "$9")
                    .replace("$1", "$0")
                    .replace("$9", "$1")
            )),
            &came,
            true,
        ),
    ] {
        assert_eq!(holds(&mut terms, &goal, &before, current), expected, "{goal}");
    }
}

/// Goals over all properties and relations, some with nested and dependent phrases.
fn many_goals(terms: &mut Terms) -> Vec<TermId> {
    let mut nouns = vec!["(lambda $0:e (and:<t*,t> (not:<t,t> (room:<e,t> $0)) (near:<e,<e,t>> $0 (the:<<e,t>,e> agent:<e,t>))))".to_owned()];
    for known in PREDICATES.iter().filter(|known| known.ty == "<e,t>") {
        nouns.push(format!("(lambda $0:e ({}:<e,t> $0))", known.name));
        nouns.push(format!(
            "(lambda $0:e (and:<t*,t> (object:<e,t> $0) ({}:<e,t> $0)))",
            known.name
        ));
        nouns.push(format!("(lambda $0:e (and:<t*,t> (room:<e,t> $0) (or:<t*,t> ({}:<e,t> $0) (in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) $0))))", known.name));
        nouns.push(format!("(lambda $0:e (and:<t*,t> (object:<e,t> $0) (exists:<<e,t>,t> (lambda $1:e (and:<t*,t> ({}:<e,t> $1) (near:<e,<e,t>> $0 $1))))))", known.name));
    }
    nouns.push("(lambda $0:e (eq:<e,<e,t>> $0 (argmin:<<e,t>,<<e,n>,e>> (lambda $1:e (near:<e,<e,t>> $0 $1)) size:<e,n>)))".into());
    let mut phrases: Vec<String> = Vec::new();
    for noun in &nouns {
        phrases.push(format!("(the:<<e,t>,e> {noun})"));
        phrases.push(format!("(argmax:<<e,t>,<<e,n>,e>> {noun} size:<e,n>)"));
    }
    for noun in nouns.iter().step_by(3) {
        phrases.push(format!("(argmax:<<e,t>,<<e,n>,e>> {noun} violet:<e,n>)"));
    }
    let mut goals = Vec::new();
    for (i, a) in phrases.iter().enumerate() {
        for b in phrases.iter().skip(i % 7).step_by(7) {
            for relation in ["in", "near", "left", "right", "eq"] {
                goals.push(read(terms, &format!("({relation}:<e,<e,t>> {a} {b})")).unwrap());
                goals.push(read(terms, &format!("(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> (object:<e,t> $0) (not:<t,t> ({relation}:<e,<e,t>> $0 {b})))))").replace("$1", "$2")).unwrap_or_else(|e| panic!("{e}: {b}")));
            }
        }
    }
    goals
}

#[test]
fn the_validator_agrees_with_the_goal() {
    let mut terms = Terms::new();
    let goals = many_goals(&mut terms);
    let mut validator = Validator::new();
    let mut held = 0;
    for seed in 0..6 {
        let pre = generate(&Plan { objects: (0, 8), ..Plan::default() }, seed);
        let mut post = generate(&Plan::default(), seed + 100);
        (post.rooms, post.doors) = (pre.rooms.clone(), pre.doors.clone());
        let pair = validator.pair(&pre, &post);
        for &term in &goals[seed as usize % 3..] {
            let goal = Goal::new(&terms, term, &pre).unwrap();
            let both = [goal.holds(&pre), goal.holds(&post)];
            let bits = [Side::Pre, Side::Post]
                .map(|side| validator.holds(&terms, term, pair, side).unwrap());
            assert_eq!(both, bits, "{}", groundling::logic::print(&terms, term));
            assert_eq!(validator.valid(&terms, term, &[pair]), both == [false, true]);
            held += usize::from(both[0]) + usize::from(both[1]);
        }
    }
    assert!(held > 500, "{held}");
}

#[test]
fn a_world_of_very_many_things_is_left_to_the_goal() {
    let crowd = |name: &'static str, row: i32| {
        (0..60).map(move |i| Object {
            name: format!("{name}{i}"),
            shape: groundling::domain::Shape::Box,
            color: groundling::domain::Color::Tan,
            size: None,
            x: 2 + i,
            y: row,
        })
    };
    let wide = |s: &mut State| {
        s.rooms[1].bounds = groundling::domain::Bounds { left: 4, bottom: 4, right: 100, top: 40 }
    };
    let pre = world(|s| {
        wide(s);
        s.objects.extend(crowd("a", 10));
    });
    let post = world(|s| {
        wide(s);
        s.objects.extend(crowd("b", 20));
    });
    let mut terms = Terms::new();
    let goal =
        "(exists:<<e,t>,t> (lambda $0:e (exists:<<e,t>,t> (lambda $1:e (left:<e,<e,t>> $0 $1)))))";
    assert!(holds(&mut terms, goal, &pre, &post));
}

#[test]
fn nesting_without_end_is_refused_in_time() {
    let mut terms = Terms::new();
    let state = generate(&Plan { objects: (8, 8), ..Plan::default() }, 1);
    let mut goal = "(near:<e,<e,t>> $0 $1)".to_owned();
    for depth in (0..14).rev() {
        goal = format!("(exists:<<e,t>,t> (lambda ${depth}:e (not:<t,t> {goal})))");
    }
    let term = read(&mut terms, &goal).unwrap();
    assert!(Goal::new(&terms, term, &state).is_err());
    let mut validator = Validator::new();
    let pair = validator.pair(&state, &state);
    assert!(!validator.valid(&terms, term, &[pair]));
    let phrase = goal.replacen("(exists:<<e,t>,t>", "(room:<e,t> (the:<<e,t>,e>", 1) + ")";
    let term = read(&mut terms, &phrase).unwrap();
    assert!(Goal::new(&terms, term, &state).is_err());
}
