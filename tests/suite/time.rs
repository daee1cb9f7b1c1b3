//! Goals in time: what a run satisfies against the definition written down directly, the monitor against both, and
//! whether two tasks are the same against all runs up to length 4.

#[path = "time/commands.rs"]
mod commands;
#[path = "time/shown.rs"]
mod shown;
#[path = "time/plans.rs"]
mod plans;
#[path = "time/hundred.rs"]
mod hundred;

use groundling::ground::{Beginnings, Comparison, Monitor, Outline, Part, compare};
use groundling::logic::{TermId, Terms, read};
use proptest::prelude::{Just, Strategy, prop, prop_assert, prop_assert_eq, prop_oneof, proptest};

/// A task over the guards `p`, `q` and `r`, as text.
fn task() -> impl Strategy<Value = String> {
    let guard = || {
        prop::sample::select(vec![
            "p:t",
            "q:t",
            "r:t",
            "true:t",
            "(not:<t,t> p:t)",
            "(or:<t*,t> p:t q:t)",
        ])
    };
    let leaf = prop_oneof![
        2 => Just("done:p".to_owned()),
        1 => Just("failed:p".to_owned()),
        3 => guard().prop_map(|holds| format!("(always:<t,p> {holds})")),
    ];
    leaf.prop_recursive(4, 12, 3, move |inner| {
        prop_oneof![
            4 => (guard(), guard(), inner.clone())
                .prop_map(|(hold, reach, then)| format!("(until:<t,<t,<p,p>>> {hold} {reach} {then})")),
            1 => prop::collection::vec(inner.clone(), 2..4).prop_map(|parts| format!("(all:<p*,p> {})", parts.join(" "))),
            1 => prop::collection::vec(inner, 2..4).prop_map(|parts| format!("(any:<p*,p> {})", parts.join(" "))),
        ]
    })
}

fn outline(text: &str) -> (Terms, TermId, Outline) {
    let mut terms = Terms::new();
    let term = read(&mut terms, text).unwrap();
    let outline = Outline::new(&terms, term).unwrap();
    (terms, term, outline)
}

/// The definition, word for word: whether a run of states, each given by what holds in it, satisfies a part.
fn satisfied(outline: &Outline, part: usize, run: &[u64]) -> bool {
    let holds = |state: u64, guard: usize| state >> guard & 1 == 1;
    match &outline.parts()[part] {
        Part::Done => true,
        Part::Failed => false,
        Part::Always(guard) => run.iter().all(|&state| holds(state, *guard)),
        Part::Until { hold, reach, then } => (0..run.len()).any(|at| {
            holds(run[at], *reach)
                && satisfied(outline, *then, &run[at..])
                && run[..at].iter().all(|&state| holds(state, *hold))
        }),
        Part::All(parts) => parts.iter().all(|&part| satisfied(outline, part, run)),
        Part::Any(parts) => parts.iter().any(|&part| satisfied(outline, part, run)),
    }
}

/// What the guards of a task say where `p`, `q` and `r` are so, or not.
fn valuation(terms: &Terms, outline: &Outline, world: u64) -> u64 {
    let is_so = |name: &str| {
        world >> ["p:t", "q:t", "r:t"].iter().position(|n| *n == name).unwrap() & 1 == 1
    };
    let holds = outline.guards().iter().map(|&guard| {
        match groundling::logic::print(terms, guard).as_str() {
            "true:t" => true,
            "(not:<t,t> p:t)" => !is_so("p:t"),
            "(or:<t*,t> p:t q:t)" => is_so("p:t") || is_so("q:t"),
            name => is_so(name),
        }
    });
    holds.enumerate().fold(0, |bits, (at, holds)| bits | u64::from(holds) << at)
}

proptest! {
    #[test]
    fn a_run_satisfies_what_the_definition_says(text in task(), worlds in prop::collection::vec(0_u64..8, 1..9)) {
        let (terms, _, outline) = outline(&text);
        let run: Vec<u64> = worlds.iter().map(|&world| valuation(&terms, &outline, world)).collect();
        let beginnings = Beginnings::of(&outline, &run);
        let mut monitor = Monitor::new(&outline).unwrap();
        let mut left = Monitor::START;
        let mut first = None;
        for last in 0..run.len() {
            let expected = satisfied(&outline, outline.parts().len() - 1, &run[..=last]);
            if expected {
                first.get_or_insert(last);
            }
            prop_assert_eq!(beginnings.holds(last), expected, "{}, up to {}", text, last);
            left = monitor.step(left, run[last]).unwrap();
            prop_assert_eq!(monitor.satisfies(left), expected, "{}, up to {}", text, last);
            prop_assert!(!(monitor.fails(left) && expected));
        }
        prop_assert_eq!(beginnings.first(), first);
    }

    #[test]
    fn what_has_failed_stays_so(text in task(), worlds in prop::collection::vec(0_u64..8, 1..9)) {
        let (terms, _, outline) = outline(&text);
        let mut monitor = Monitor::new(&outline).unwrap();
        let (mut left, mut has_failed) = (Monitor::START, false);
        for world in worlds {
            left = monitor.step(left, valuation(&terms, &outline, world)).unwrap();
            prop_assert!(!has_failed || monitor.fails(left));
            has_failed = monitor.fails(left);
        }
    }

    #[test]
    fn tasks_are_the_same_when_all_short_runs_say_so(a in task(), b in task()) {
        let mut terms = Terms::new();
        let (one, other) = (read(&mut terms, &a).unwrap(), read(&mut terms, &b).unwrap());
        let (left, right) = (Outline::new(&terms, one).unwrap(), Outline::new(&terms, other).unwrap());
        let first = |outline: &Outline, run: &[u64]| {
            let run: Vec<u64> = run.iter().map(|&world| valuation(&terms, outline, world)).collect();
            Beginnings::of(outline, &run).first()
        };
        let mut apart = None;
        'lengths: for length in 1..=4_u32 {
            for code in 0..8_u64.pow(length) {
                let run: Vec<u64> = (0..length).map(|at| code >> (3 * at) & 7).collect();
                if first(&left, &run) != first(&right, &run) {
                    apart = Some(run.len());
                    break 'lengths;
                }
            }
        }
        match compare(&terms, one, other, None).unwrap() {
            Comparison::Equivalent => prop_assert_eq!(apart, None),
            Comparison::Apart(run) => prop_assert!(apart.is_none_or(|length| length == run.len())),
        }
    }
}

#[test]
fn a_sequence_of_n_has_n_and_one_residuals() {
    let names = ["p:t", "q:t", "r:t"];
    let text = names.iter().rev().fold("done:p".to_owned(), |then, reach| {
        format!("(until:<t,<t,<p,p>>> true:t {reach} {then})")
    });
    let (terms, _, outline) = outline(&text);
    let mut monitor = Monitor::new(&outline).unwrap();
    let mut left = vec![Monitor::START];
    let mut next = 0;
    while next < left.len() {
        for world in 0..8 {
            let to = monitor.step(left[next], valuation(&terms, &outline, world)).unwrap();
            if !left.contains(&to) {
                left.push(to);
            }
        }
        next += 1;
    }
    assert_eq!(monitor.found(), names.len() + 1);
}
