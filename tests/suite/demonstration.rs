//! The project's own demonstration, `assets/corpus/six.csv`: six commands with three demonstrations each, made
//! here from seeds. The demonstrations of a row leave no reading but the meant one: whatever else a short form
//! could say (the biggest room, the object, the thing on the left …) one of them disproves.
//! `GROUNDLING_BLESS=1` writes the file anew.

use groundling::corpus::{Cells, Corpus, Decision, Example, Options, Pair, read, table};
use groundling::domain::{Color, Direction, Layout, Object, Plan, Shape, State, generate};
use groundling::ground::{Class, PREDICATES, PairId, Relation, Thing, Validator};
use groundling::logic::{TermId, Terms};
use std::collections::BTreeSet;

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/corpus/six.csv");

const COMMANDS: [(&str, &str); 6] = [
    ("green-room", "go to the green room"),
    ("green-room", "walk to the green room"),
    ("green-room", "go into the green room"),
    ("near-block", "go near the block"),
    ("near-block", "walk to the block"),
    ("near-block", "go next to the block"),
];

const AGENT: &str = "(the:<<e,t>,e> (lambda $0:e (agent:<e,t> $0)))";
const GREEN_ROOM: &str =
    "(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (green:<e,t> $0) (room:<e,t> $0))))";
const BLOCK: &str = "(the:<<e,t>,e> (lambda $0:e (block:<e,t> $0)))";

/// The cells that the robot reaches without pushing, each with the direction of the last step, nearest first.
fn reachable(state: &State) -> Vec<((i32, i32), Direction)> {
    let layout = Layout::new(state);
    let taken: BTreeSet<(i32, i32)> = state.objects.iter().map(|o| (o.x, o.y)).collect();
    let mut seen = BTreeSet::from([(state.agent.x, state.agent.y)]);
    let mut found = vec![((state.agent.x, state.agent.y), state.agent.direction)];
    let mut next = 0;
    while let Some(&((x, y), _)) = found.get(next) {
        next += 1;
        for &direction in Direction::ALL {
            let (dx, dy) = direction.step();
            let cell = (x + dx, y + dy);
            if layout.place(cell.0, cell.1).is_some() && !taken.contains(&cell) && seen.insert(cell)
            {
                found.push((cell, direction));
            }
        }
    }
    found
}

fn at(state: &State, (x, y): (i32, i32), direction: Direction) -> State {
    let mut state = state.clone();
    (state.agent.x, state.agent.y, state.agent.direction) = (x, y, direction);
    state
}

fn agent_is(relation: Relation, state: &State, what: impl Fn(Thing<'_>) -> bool) -> bool {
    let things = Thing::all(state);
    things.iter().any(|&thing| what(thing) && relation.holds(things[0], thing))
}

fn is_object(thing: Thing<'_>) -> bool {
    thing.class() == Class::Object
}

fn is_block(thing: Thing<'_>) -> bool {
    thing.shape() == Some(Shape::Block)
}

fn is_green_room(thing: Thing<'_>) -> bool {
    thing.class() == Class::Room && thing.color() == Some(Color::Green)
}

/// The `k`-th demonstration that `seed` gives for a task, if it gives one.
fn pair(task: &str, k: usize, seed: u64) -> Option<Pair> {
    let plan = Plan { side: (8, 10), objects: (2, 3) };
    let pre = generate(&plan, seed);
    let blocks = pre.objects.iter().filter(|o| o.shape == Shape::Block).count();
    let start_is_good = if task == "green-room" {
        let green_thing = pre.objects.iter().any(|o: &Object| o.color == Color::Green);
        !agent_is(Relation::In, &pre, is_green_room) && (k != 1 || green_thing)
    } else {
        let in_its_room = Thing::all(&pre).iter().any(|&room| {
            agent_is(Relation::In, &pre, |thing| thing.is(&room.entity()))
                && Thing::all(&pre).iter().any(|&t| is_block(t) && Relation::In.holds(t, room))
        });
        let near_another = agent_is(Relation::Near, &pre, is_object);
        blocks == 1
            && !agent_is(Relation::Near, &pre, is_block)
            && (k != 1 || in_its_room)
            && (k != 2 || near_another)
    };
    let goals: Vec<State> = reachable(&pre)
        .into_iter()
        .map(|(cell, direction)| at(&pre, cell, direction))
        .filter(|post| {
            if task == "green-room" {
                let near_object = agent_is(Relation::Near, post, is_object);
                agent_is(Relation::In, post, is_green_room) && (k != 0 || !near_object)
            } else {
                let near_another =
                    agent_is(Relation::Near, post, |thing| is_object(thing) && !is_block(thing));
                agent_is(Relation::Near, post, is_block) && !near_another
            }
        })
        .collect();
    let post = goals.get(usize::try_from(seed).ok()?.checked_rem(goals.len())?)?.clone();
    start_is_good.then_some(Pair::of(pre, post))
}

/// Every short form: a relation of the robot to something that is described in one or two words.
fn short_forms(terms: &mut Terms) -> Vec<TermId> {
    let words: Vec<&str> = PREDICATES.iter().filter(|p| p.ty == "<e,t>").map(|p| p.name).collect();
    let mut nouns: Vec<String> = words.iter().map(|word| format!("({word}:<e,t> $0)")).collect();
    for (i, a) in words.iter().enumerate() {
        let both =
            words[i + 1..].iter().map(|b| format!("(and:<t*,t> ({a}:<e,t> $0) ({b}:<e,t> $0))"));
        nouns.extend(both);
    }
    let mut forms = Vec::new();
    let mut add = |text: String| forms.push(groundling::logic::read(terms, &text).unwrap());
    for noun in &nouns {
        for relation in ["in", "near", "left", "right", "eq"] {
            add(format!(
                "(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> {noun} ({relation}:<e,<e,t>> {} $0))))",
                AGENT.replace("$0", "$1")
            ));
            for determiner in ["the", "argmax", "argmin"] {
                let phrase = match determiner {
                    "the" => format!("(the:<<e,t>,e> (lambda $0:e {noun}))"),
                    _ => {
                        format!("({determiner}:<<e,t>,<<e,n>,e>> (lambda $0:e {noun}) size:<e,n>)")
                    }
                };
                add(format!("({relation}:<e,<e,t>> {AGENT} {phrase})"));
                add(format!("({relation}:<e,<e,t>> {phrase} {AGENT})"));
                add(format!("(not:<t,t> ({relation}:<e,<e,t>> {AGENT} {phrase}))"));
            }
        }
    }
    forms
}

fn valid(terms: &Terms, forms: &[TermId], pairs: &[Pair]) -> BTreeSet<String> {
    let mut validator = Validator::new();
    let pairs: Vec<PairId> = pairs.iter().map(|p| validator.pair(&p.pre, &p.post)).collect();
    let valid = forms.iter().filter(|&&form| validator.valid(terms, form, &pairs));
    valid.map(|&form| groundling::logic::print(terms, form)).collect()
}

/// The forms that say what is meant: by `the`, by `exists`, and with an idle word beside it.
fn meant(task: &str) -> BTreeSet<String> {
    let some = |nouns: &str, relation: &str| {
        format!(
            "(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> {nouns} ({relation}:<e,<e,t>> {} $0))))",
            AGENT.replace("$0", "$1")
        )
    };
    let mut forms = BTreeSet::new();
    if task == "green-room" {
        forms.insert(format!("(in:<e,<e,t>> {AGENT} {GREEN_ROOM})"));
        forms.insert(some("(green:<e,t> $0)", "in"));
        forms.insert(some("(green:<e,t> $0) (room:<e,t> $0)", "in"));
    } else {
        let idle =
            BLOCK.replace("(block:<e,t> $0)", "(and:<t*,t> (block:<e,t> $0) (object:<e,t> $0))");
        for block in [BLOCK, &idle] {
            forms.insert(format!("(near:<e,<e,t>> {AGENT} {block})"));
            forms.insert(format!("(near:<e,<e,t>> {block} {AGENT})"));
        }
        forms.insert(some("(block:<e,t> $0)", "near"));
        forms.insert(some("(block:<e,t> $0) (object:<e,t> $0)", "near"));
    }
    // conjuncts print in canonical order, whatever the order here
    let mut terms = Terms::new();
    let printed = |text: &String| {
        let term = groundling::logic::read(&mut terms, text).unwrap();
        groundling::logic::print(&terms, term)
    };
    forms.iter().map(printed).collect()
}

fn make() -> Corpus {
    let mut terms = Terms::new();
    let forms = short_forms(&mut terms);
    let mut seeds = 1..;
    let mut next = |task: &str, k: usize| seeds.find_map(|seed| pair(task, k, seed)).unwrap();
    let mut examples = Vec::new();
    for (i, (task, command)) in COMMANDS.into_iter().enumerate() {
        let pairs = loop {
            let pairs: Vec<Pair> = (0..3).map(|k| next(task, k)).collect();
            if valid(&terms, &forms, &pairs) == meant(task) {
                break pairs;
            }
        };
        examples.push(Example {
            id: format!("demonstration-{}", i + 1),
            line: 0,
            command: command.to_owned(),
            task: Some(task.to_owned()),
            worker: None,
            decision: Decision::Open,
            pairs,
            rest: Cells::default(),
            keys: Cells::default(),
        });
    }
    Corpus { examples, ..Corpus::default() }
}

#[test]
fn the_file_is_what_its_seeds_make() {
    let mut made = Vec::new();
    table::write(&make(), &mut made).unwrap();
    if std::env::var_os("GROUNDLING_BLESS").is_some() {
        std::fs::write(PATH, &made).unwrap();
    }
    let file = std::fs::read(PATH).unwrap_or_default();
    assert!(file == made, "six.csv is not what is made here; GROUNDLING_BLESS=1 writes it anew");
}

#[test]
fn each_row_means_what_it_says_and_nothing_else() {
    let (corpus, flaws) = read(std::fs::File::open(PATH).unwrap(), Options::default());
    assert_eq!(flaws, []);
    assert_eq!(corpus.examples.len(), 6);
    let mut terms = Terms::new();
    let forms = short_forms(&mut terms);
    let mut layouts = BTreeSet::new();
    for example in &corpus.examples {
        assert!(!example.command.contains("blue"), "blue is what nobody says");
        assert_eq!(example.pairs.len(), 3);
        let task = example.task.as_deref().unwrap();
        assert_eq!(valid(&terms, &forms, &example.pairs), meant(task), "{}", example.command);
        layouts.extend(example.pairs.iter().map(|pair| pair.pre.write()));
    }
    assert_eq!(layouts.len(), 18, "no layout serves twice");
}
