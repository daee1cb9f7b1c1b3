//! What goals say, taken apart: `tests/data/ground/claims.txt`, in which every task of the corpus stands.

use groundling::ground::{Article, Claim, Description, Noun, claim};
use groundling::logic::{Terms, read};

const CASES: &str = include_str!("../../data/ground/claims.txt");
const TASKS: &str = include_str!("../../../assets/corpus/tasks.txt");

#[test]
fn every_claim_is_told_as_it_should_be() {
    let (mut forms, mut found) = (Vec::<&str>::new(), String::new());
    for line in CASES.lines() {
        if line.starts_with("=> ") {
            let mut terms = Terms::new();
            let term = read(&mut terms, forms.last().unwrap()).unwrap();
            let claim = claim(&terms, term);
            let json = serde_json::to_string(&claim).unwrap();
            assert_eq!(serde_json::from_str::<Claim>(&json).unwrap(), claim);
            found.push_str(&format!("=> {}\n", told(&claim)));
        } else {
            forms.push(line);
            found.push_str(&format!("{line}\n"));
        }
    }
    assert!(found == CASES, "tests/data/ground/claims.txt should read\n{found}");
    for goal in TASKS.lines().filter_map(|line| line.strip_prefix("goal ")) {
        assert!(forms.contains(&goal), "no case for {goal}");
    }
}

#[test]
fn what_is_nested_deeply_is_told_so_far_and_comes_back_from_json() {
    let mut inner = "(the:<<e,t>,e> room:<e,t>)".to_owned();
    for _ in 0..40 {
        inner = format!("(the:<<e,t>,e> (lambda $0:e (in:<e,<e,t>> $0 {inner})))");
    }
    let mut terms = Terms::new();
    let term = read(&mut terms, &format!("(red:<e,t> {inner})")).unwrap();
    let found = claim(&terms, term);
    assert!(told(&found).contains('`'), "it ends in a formula");
    let json = serde_json::to_string(&found).unwrap();
    let depth = json.chars().fold((0_i32, 0), |(at, most), c| {
        let at = at + i32::from("[{".contains(c)) - i32::from("]}".contains(c));
        (at, most.max(at))
    });
    assert!(depth.1 < 64, "{} brackets deep: a reader of JSON takes 128", depth.1);
    assert_eq!(serde_json::from_str::<Claim>(&json).unwrap(), found);
}

/// A claim in a line: `in(robot, the red room)`; descriptions have what else is said of them in braces, and formulas
/// stand in backquotes.
fn told(claim: &Claim) -> String {
    let each = |all: &[Claim]| all.iter().map(told).collect::<Vec<_>>().join(", ");
    match claim {
        Claim::All(all) => format!("all[{}]", each(all)),
        Claim::Any(any) => format!("any[{}]", each(any)),
        Claim::Not(of) => format!("not {}", told(of)),
        Claim::Related { relation, nouns } => {
            format!("{relation}({}, {})", called(&nouns[0]), called(&nouns[1]))
        }
        Claim::Is(property, of) => format!("{property}({})", called(of)),
        Claim::Exists(what) => format!("exists {}", described(what)),
        Claim::Then(all) => format!("then[{}]", each(all)),
        Claim::Never(of) => format!("never {}", told(of)),
        Claim::Until(both) => format!("until[{}]", each(&both[..])),
        Claim::Formula(text) => format!("`{text}`"),
    }
}

fn called(noun: &Noun) -> String {
    match noun {
        Noun::Robot => "robot".to_owned(),
        Noun::It => "it".to_owned(),
        Noun::Outer => "outer".to_owned(),
        Noun::Described(what) => described(what),
        Noun::Formula(text) => format!("`{text}`"),
    }
}

fn described(what: &Description) -> String {
    let article = match what.article {
        Article::A => "a",
        Article::The => "the",
        Article::Biggest => "biggest",
        Article::Smallest => "smallest",
        Article::Closest(shade) => shade.name(),
    };
    let words = std::iter::once(article).chain(what.properties.iter().map(|p| &**p));
    let words = words.collect::<Vec<_>>().join(" ");
    match &what.claims[..] {
        [] => words,
        claims => format!("{words} {{{}}}", claims.iter().map(told).collect::<Vec<_>>().join(", ")),
    }
}
